#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cloud/breast_height.h"
#include "modules/render/small_survey.h"
#include "render/offscreen/offscreen.h"
#include "render/scene/actors.h"
#include "render/scene/eye_dome.h"
#include "render/scene/map_figure.h"
#include "render/scene/thin.h"

namespace bole::render {
namespace {

PointCloud copies(int times) {
  PointCloud::Positions positions;
  for (int k = 0; k < times; ++k)
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < 100; ++j)
        positions.emplace_back(0.05F * static_cast<float>(i) + 0.001F, 0.05F * static_cast<float>(j) + 0.001F, 0.001F);
  return PointCloud(std::move(positions));
}

TEST(Thin, KeepsTheBudgetAndTheWindow) {
  const auto cloud = copies(1);
  const auto kept = thin_for_drawing(cloud, {{1, 1}, {3, 3}}, 500);
  EXPECT_LE(kept.size(), 500U);
  EXPECT_GT(kept.size(), 100U);
  for (const auto i : kept) EXPECT_TRUE((Window{{1, 1}, {3, 3}}).contains(cloud.position(i)));
  EXPECT_EQ(thin_for_drawing(cloud, {}, 1000000).size(), cloud.size());
}

TEST(Thin, PlacesScannedOftenAreDrawnOnce) {
  EXPECT_NEAR(static_cast<double>(thin_for_drawing(copies(5), {}, 12000).size()), 10000, 100);
}

TEST(Thin, DropsWhatIsNotANumber) {
  PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {std::nanf(""), 0, 0}});
  EXPECT_EQ(thin_for_drawing(cloud, {}, 10).size(), 1U);
}

TEST(Thin, CancelStops) {
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(thin_for_drawing(copies(1), {}, 100, run), Error);
}

TEST(EyeDome, DarkensTheFarSideOfAStepWithinItsBound) {
  const int w = 40, h = 10;
  std::vector<std::uint8_t> rgb(3 * w * h, 200);
  std::vector<float> depth(w * h, 5);
  for (int y = 0; y < h; ++y)
    for (int x = 20; x < w; ++x)
      depth[static_cast<std::size_t>(y * w + x)] = x == 39 ? std::numeric_limits<float>::infinity() : 8;
  shade_eye_dome(rgb, depth, w, h, {2, 0.5, 0.6});
  const auto at = [&](int x) { return rgb[static_cast<std::size_t>(3 * (5 * w + x))]; };
  EXPECT_EQ(at(5), 200);
  EXPECT_EQ(at(19), 200);  // the near side
  EXPECT_LT(at(20), 170);  // beside it, the far side
  EXPECT_GE(at(20), 80);   // never below 1 - strength
  EXPECT_EQ(at(30), 200);
  EXPECT_EQ(at(39), 200);  // background
}

TEST(Stems, PointsOnThemGoAndOthersStay) {
  StemShape stem;
  stem.axis = {{0, 0, 0}, {0, 0, 4}};
  stem.radius_m = {0.2, 0.1};
  PointCloud cloud(PointCloud::Positions{{0.2F, 0, 0.1F}, {0.2F, 0, 3.9F}, {0.1F, 0, 3.9F}, {0, 0, 4.5F}, {3, 0, 1}});
  std::vector<std::uint32_t> indices{0, 1, 2, 3, 4};
  drop_points_on_stems(cloud, {stem}, 0.02, indices);
  EXPECT_THAT(indices, testing::ElementsAre(1, 3, 4));
}

TEST(Stems, ShapesFollowSectionsElseLeanAndTaper) {
  const auto s = testing_data::make_small_survey();
  const auto from_sections = stem_shapes(s.stems, &s.sections), from_table = stem_shapes(s.stems, nullptr);
  ASSERT_EQ(from_sections.size(), s.stems.rows());
  EXPECT_EQ(from_sections[0].axis.size(), 6U);  // ground, four sections, a little more
  EXPECT_NEAR(from_sections[0].axis[0].z(), s.stems.numbers("z_m")[0], 1e-9);
  ASSERT_EQ(from_table[0].axis.size(), 3U);
  // The table's taper is what the diameter loses upwards, 0.8 cm per metre: thicker at the ground, thinner above.
  const double breast = s.stems.numbers("dbh_cm")[0] / 200;
  EXPECT_NEAR(from_table[0].radius_m[0], breast + 0.004 * 1.3, 1e-9);
  EXPECT_NEAR(from_table[0].radius_m[1], breast, 1e-9);
  EXPECT_LT(from_table[0].radius_m[2], breast - 0.004);
  const double lean = s.stems.numbers("lean_deg")[0] * std::numbers::pi / 180;
  const Eigen::Vector3d along = (from_table[0].axis[2] - from_table[0].axis[0]).normalized();
  EXPECT_NEAR(std::acos(along.z()), lean, 1e-6);
  EXPECT_NEAR(std::atan2(along.x(), along.y()), 30 * std::numbers::pi / 180, 1e-6);  // azimuth from north
}

TEST(Stems, ShapesHaveTheBreastHeightOfTheirTable) {
  auto stems = testing_data::make_small_survey().stems;
  const auto usual = stem_shapes(stems, nullptr);
  set_breast_height_m(stems, 1.37);
  const auto shapes = stem_shapes(stems, nullptr);
  const double ground = stems.numbers("z_m")[0], radius = stems.numbers("dbh_cm")[0] / 200;
  EXPECT_NEAR(usual[0].breast_height.z(), ground + 1.3, 1e-9);
  EXPECT_NEAR(shapes[0].breast_height.z(), ground + 1.37, 1e-9);
  EXPECT_NEAR(shapes[0].axis[1].z(), ground + 1.37, 1e-9);
  EXPECT_NEAR(shapes[0].radius_m[0], radius + 0.004 * 1.37, 1e-9);
}

TEST(Map, ShowsGroundStemsAndPaper) {
  use_backend(Backend::automatic);
  const auto s = testing_data::make_small_survey();
  const MapData data{&s.points, &s.stems, &s.sections, nullptr, rectangle_area({0, 0}, 20, 20), true, nullptr};
  MapOptions options;
  options.dpi = 60;
  options.view = MapView::top;
  const auto figure = map_figure(data, options, 150);
  const auto image = figure_image(figure, 60);
  EXPECT_EQ(image.width, 354);
  const auto ground = image.pixel(image.width / 3, image.height / 3), corner = image.pixel(2, image.height - 2);
  EXPECT_DOUBLE_EQ(corner.r, 1);
  EXPECT_LT(ground.b, 0.95);
  options.view = MapView::oblique;
  const auto oblique = figure_image(map_figure(data, options, 150), 60);
  int orange = 0, yellow = 0;
  for (int y = 0; y < oblique.height; ++y)
    for (int x = 0; x < oblique.width - 45; ++x) {
      const auto c = oblique.pixel(x, y);
      orange += c.r > 0.5 && c.r > 1.5 * c.g && c.r > 2 * c.b;
      yellow += c.r > 0.6 && c.g > 0.8 * c.r && c.b < 0.55 * c.r;
    }
  EXPECT_GT(orange, 40);  // fitted stems
  EXPECT_GT(yellow, 40);  // rings at breast height
}

TEST(Map, ChosenPointsDrawTheSame) {
  use_backend(Backend::automatic);
  const auto s = testing_data::make_small_survey();
  MapData data{&s.points, &s.stems, &s.sections, nullptr, rectangle_area({0, 0}, 20, 20), true, nullptr};
  MapOptions options;
  options.dpi = 40, options.point_budget = 20000;
  const auto anew = figure_image(map_figure(data, options, 100), 40);
  const auto chosen = choose_map_points(data, options.point_budget);
  EXPECT_LT(chosen.off_stems.size(), chosen.all.size());
  data.chosen = &chosen;
  EXPECT_EQ(figure_image(map_figure(data, options, 100), 40).rgba, anew.rgba);
}

TEST(Map, LargeCoordinatesDrawTheSame) {
  use_backend(Backend::automatic);
  auto s = testing_data::make_small_survey();
  MapOptions options;
  options.dpi = 40, options.furniture = false;
  const auto at_origin =
      figure_image(map_figure({&s.points, nullptr, nullptr, nullptr, {}, true, nullptr}, options, 100), 40);
  auto far = s.points;
  far.origin = {512345, 5412345, 300};
  const auto far_away =
      figure_image(map_figure({&far, nullptr, nullptr, nullptr, {}, true, nullptr}, options, 100), 40);
  ASSERT_EQ(at_origin.rgba.size(), far_away.rgba.size());
  double difference = 0;
  for (std::size_t i = 0; i < at_origin.rgba.size(); ++i) difference += std::abs(at_origin.rgba[i] - far_away.rgba[i]);
  EXPECT_LT(difference / static_cast<double>(at_origin.rgba.size()), 3);
}

TEST(Map, NothingToDrawIsSaid) {
  EXPECT_THROW(map_figure({}, {}, 100), Error);
  const PointCloud empty;
  EXPECT_THROW(map_figure({&empty, nullptr, nullptr, nullptr, {}, true, nullptr}, {}, 100), Error);
}

TEST(Map, WriteThemForTheEye) {
  const char* dir = std::getenv("BOLE_FIGURES_DIR");
  if (dir == nullptr) GTEST_SKIP() << "BOLE_FIGURES_DIR is not set";
  use_backend(Backend::automatic);
  testing_data::SurveyOptions size;
  size.points_per_tree = 40000;
  size.ground_points = 800000;
  const auto s = testing_data::make_small_survey(size);
  const MapData data{&s.points, &s.stems, &s.sections, &s.trajectory, rectangle_area({0, 0}, 20, 20), true, nullptr};
  MapOptions options;
  const auto write = [&](const Figure& f) {
    write_text_file(std::filesystem::path(dir) / (f.name + ".png"), figure_png(f, options.dpi));
  };
  options.dpi = 200;
  const auto start = std::chrono::steady_clock::now();
  const auto lap = [&](const char* what) {
    std::printf("%s %.2f s\n", what, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  };
  write(map_figure(data, options, 180));
  lap("height");
  options.color = PointColor::tree;
  write(map_figure(data, options, 180));
  lap("tree");
  options.view = MapView::top;
  write(map_figure(data, options, 180));
  lap("top");
  write(hero_figure(data, 240, options.dpi));
  lap("hero");
}

}  // namespace
}  // namespace bole::render
