#include "render/charts/stand_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "modules/render/small_survey.h"
#include "render/charts/trajectory_charts.h"
#include "render/maps/raster_map.h"
#include "render/scene/map_figure.h"
#include "render/scene/thin.h"

namespace bole::render {
namespace {

using testing::HasSubstr;

int pixels_like(const Image& image, const Color& color, double reach = 0.06) {
  int n = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto c = image.pixel(x, y);
      n += std::abs(c.r - color.r) < reach && std::abs(c.g - color.g) < reach && std::abs(c.b - color.b) < reach;
    }
  return n;
}

Table height_curve() {
  Table t;
  t.set("breast_height_m", std::vector<double>{1.3}), t.set("a", std::vector<double>{1.5}),
      t.set("b", std::vector<double>{0.2}), t.set("min_dbh_cm", std::vector<double>{8}),
      t.set("max_dbh_cm", std::vector<double>{40});
  return t;
}

TEST(StandCharts, HeightsHaveTheirCurveWhereThereIsOne) {
  const auto s = testing_data::make_small_survey();
  EXPECT_TRUE(has_heights(s.stems));
  const auto curve = height_curve();
  const auto with = height_diameter(s.stems, &curve, 90), without = height_diameter(s.stems, nullptr, 90);
  EXPECT_THAT(with.caption, HasSubstr("height curve"));
  EXPECT_THAT(without.caption, testing::Not(HasSubstr("height curve")));
  EXPECT_GT(pixels_like(figure_image(with, 150), ink::text), pixels_like(figure_image(without, 150), ink::text) + 50);
  Table none = s.stems;
  none.set("height_m", std::vector<double>(none.rows(), std::nan("")));
  EXPECT_FALSE(has_heights(none));
}

TEST(StandCharts, LowerBoundsAreRings) {
  auto s = testing_data::make_small_survey();
  s.stems.set("quality", std::vector<std::string>(s.stems.rows(), "good"));
  const auto paper = [&] { return pixels_like(figure_image(height_diameter(s.stems, nullptr, 90), 200), ink::paper); };
  const auto around_discs = paper();
  s.stems.set("height_lower_bound_m", s.stems.numbers("height_m"));
  s.stems.set("height_m", std::vector<double>(s.stems.rows(), std::nan("")));
  s.stems.set("height_seen", std::vector<std::int64_t>(s.stems.rows(), 0));
  EXPECT_GT(paper(), around_discs + 300);  // rings are hollow
}

TEST(StandCharts, TaperTakesTheSectionsOfTheStemsGiven) {
  const auto s = testing_data::make_small_survey();
  ASSERT_TRUE(has_stem_curves(s.stems, s.sections));
  const auto paper = [](const Figure& f) { return pixels_like(figure_image(f, 120), ink::paper, 0.01); };
  EXPECT_GT(paper(taper_curves(s.stems.subset({0, 1}), s.sections, 90)), paper(taper_curves(s.stems, s.sections, 90)));
  EXPECT_FALSE(has_stem_curves(s.stems.subset({}), s.sections));
}

TEST(RasterMap, TerrainHasContoursAndCanopyHasNone) {
  const auto s = testing_data::make_small_survey();
  const auto terrain = raster_map({&s.dem, &s.stems, rectangle_area({0, 0}, 20, 20), true}, RasterKind::terrain, 90);
  EXPECT_THAT(terrain.caption, HasSubstr("contour lines every 0.2 m"));
  EXPECT_EQ(terrain.name, "terrain");
  const auto image = figure_image(terrain, 120);
  EXPECT_GT(pixels_like(image, ink::accent, 0.1), 40);  // the stems
  EXPECT_LT(pixels_like(image, ink::paper, 0.01), image.width * image.height / 2);
  EXPECT_THAT(raster_map({&s.dem, nullptr, {}, true}, RasterKind::canopy, 90).caption,
              testing::Not(HasSubstr("contour")));
}

TEST(RasterMap, HolesArePaperAndNothingIsAnError) {
  auto s = testing_data::make_small_survey();
  for (auto& v : s.dem.values) v = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(raster_map({&s.dem, nullptr, {}, true}, RasterKind::terrain, 90), Error);
  EXPECT_THROW(raster_map({nullptr, nullptr, {}, true}, RasterKind::terrain, 90), Error);
  s.dem.values[0] = 3;
  EXPECT_GT(figure_png(raster_map({&s.dem, nullptr, {}, true}, RasterKind::terrain, 90), 60).size(), 100U);
}

TEST(TrajectoryCharts, AlignedPathsLieOnTheirReference) {
  const auto s = testing_data::make_small_survey();
  Pose moved = Pose::Identity();
  moved.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.1, 0.2, 1).normalized()).toRotationMatrix();
  moved.translation() = Eigen::Vector3d(5, -3, 1);
  auto estimate = s.reference;
  for (auto& pose : estimate.poses) pose.T_target_sensor = moved * pose.T_target_sensor;
  const auto aligned = aligned_to(estimate, s.reference);
  for (std::size_t i = 0; i < aligned.poses.size(); ++i)
    EXPECT_LT(
        (aligned.poses[i].T_target_sensor.translation() - s.reference.poses[i].T_target_sensor.translation()).norm(),
        1e-6);
  EXPECT_GT(greatest_error_cm({&estimate, &s.reference, nullptr}), 100);
  EXPECT_LT(greatest_error_cm({&aligned, &s.reference, nullptr}), 1e-3);
  auto short_path = s.reference;
  short_path.poses.resize(2);
  EXPECT_EQ(aligned_to(short_path, s.reference).poses.size(), 2U);
}

TEST(Thin, OfALargeCloudTheChoiceStaysEvenAndInTheWindow) {
  PointCloud::Positions positions;
  // A dense heap in the order of the file first, then a thin sheet: an even choice covers the sheet as the heap.
  for (int i = 0; i < 300000; ++i)
    positions.emplace_back(0.001F * static_cast<float>(i % 1000), 0.001F * static_cast<float>(i / 1000), 0);
  for (int i = 0; i < 90000; ++i)
    positions.emplace_back(2 + 0.01F * static_cast<float>(i % 300), 0.01F * static_cast<float>(i / 300), 0);
  const PointCloud cloud(std::move(positions));
  const auto kept = thin_for_drawing(cloud, {}, 3000);
  EXPECT_GT(kept.size(), 1000U);
  EXPECT_LE(kept.size(), 3600U);
  int heap = 0, sheet = 0;
  for (const auto i : kept) (cloud.position(i).x() < 1.5 ? heap : sheet)++;
  EXPECT_GT(sheet, 10 * heap);  // areas of 0.3 and 9 square metres
  const Window corner{{4.5, 2.5}, {5, 3}};
  const auto few = thin_for_drawing(cloud, corner, 400);
  EXPECT_GT(few.size(), 150U);
  for (const auto i : few) EXPECT_TRUE(corner.contains(cloud.position(i)));
}

}  // namespace
}  // namespace bole::render
