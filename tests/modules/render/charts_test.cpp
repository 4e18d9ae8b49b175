#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/atomic_file.h"
#include "modules/render/small_survey.h"
#include "modules/render/well_formed.h"
#include "render/charts/dbh_charts.h"
#include "render/charts/position_charts.h"
#include "render/charts/slice_sheet.h"
#include "render/charts/trajectory_charts.h"
#include "render/maps/stem_map.h"

namespace bole::render {
namespace {

const testing_data::SmallSurvey& survey() {
  static const auto made = testing_data::make_small_survey();
  return made;
}

StemMapData map_data() {
  const auto& s = survey();
  return {&s.stems, rectangle_area({0, 0}, 20, 20), &s.targets, &s.trajectory, &s.matches, true};
}

// One right, one wrong, and one of a time that the path does not cover.
Table two_loops(const Trajectory& path) {
  const double start = path.poses.front().time_s, end = path.poses.back().time_s;
  Table t;
  t.set("from_time_s", std::vector<double>{start, start + 1, start - 100});
  t.set("to_time_s", std::vector<double>{end, 0.5 * (start + end), end});
  t.set("right", std::vector<std::int64_t>{1, 0, 1});
  return t;
}

std::vector<Figure> all_charts() {
  const auto& s = survey();
  std::vector<Figure> figures{stem_map(map_data(), 160),
                              dbh_scatter(s.matches, 85),
                              dbh_error_boxes(s.matches, 85),
                              dbh_histogram(s.stems.numbers("dbh_cm"), 85),
                              position_errors(s.matches, 85),
                              trajectory_plan(s.trajectory, &s.reference, 120),
                              trajectory_plan(s.trajectory, nullptr, 120)};
  figures.back().name = "trajectory_time";
  static const Table loops = two_loops(s.trajectory);
  const TrajectoryComparison both{&s.trajectory, &s.reference, &loops};
  for (const auto& figure :
       {trajectory_overlay(both, 160), trajectory_error_chart(both, 160), trajectory_sheet(both, 160)})
    figures.push_back(figure);
  figures.back().name = "trajectory_sheet";
  for (auto& page : slice_sheets(s.stems, s.slice, 180)) figures.push_back(page);
  return figures;
}

int pixels_near(const Image& image, const Color& color, double tolerance = 0.08) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto c = image.pixel(x, y);
      count += std::abs(c.r - color.r) < tolerance && std::abs(c.g - color.g) < tolerance &&
               std::abs(c.b - color.b) < tolerance;
    }
  return count;
}

Table one_stem(double dbh_cm, const std::string& quality) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{1}), t.set("x_m", std::vector<double>{0}),
      t.set("y_m", std::vector<double>{0}), t.set("dbh_cm", std::vector<double>{dbh_cm}),
      t.set("quality", std::vector<std::string>{quality});
  return t;
}

TEST(StemMap, StemsAreTrueToScale) {
  const PlotArea area = rectangle_area({0, 0}, 20, 20);
  const auto thick = one_stem(200, "poor"), thin = one_stem(100, "poor");
  const auto color = mix(ink::paper, ink::poor, 0.85);
  const auto big =
      pixels_near(figure_image(stem_map({&thick, area, nullptr, nullptr, nullptr, true}, 100), 200), color);
  const auto small =
      pixels_near(figure_image(stem_map({&thin, area, nullptr, nullptr, nullptr, true}, 100), 200), color);
  // A disc of 2 m on 23 m of map (6 % and 0.3 m around the plot) over 83.5 mm; the legend has a disc of 2.2 mm.
  const double disc = std::numbers::pi * std::pow(1.0 / 23 * 83.5 / 25.4 * 200, 2);
  EXPECT_NEAR(big - small, 0.75 * disc, 0.06 * disc);
}

TEST(StemMap, MissedAndFalseAreMarkedOnlyWhenCompared) {
  auto data = map_data();
  const auto with = pixels_near(figure_image(stem_map(data, 120), 150), ink::accent, 0.05);
  data.matches = nullptr;
  const auto without = pixels_near(figure_image(stem_map(data, 120), 150), ink::accent, 0.05);
  EXPECT_GT(with, without + 60);
}

TEST(StemMap, NoStemsNoBoundary) {
  Table empty;
  for (const char* c : {"x_m", "y_m"}) empty.set(c, std::vector<double>{});
  EXPECT_GT(figure_image(stem_map({&empty, {}, nullptr, nullptr, nullptr, false}, 100), 50).height, 30);
}

TEST(SliceSheet, WorstFirstOnAsManyPagesAsNeeded) {
  const auto& s = survey();
  const auto pages = slice_sheets(s.stems, s.slice, 180);
  ASSERT_EQ(pages.size(), 2U);  // 40 trees, 30 to a page
  EXPECT_EQ(pages[0].name, "slices_01");
  const auto first = figure_image(pages[0], 60), last = figure_image(pages[1], 60);
  EXPECT_GT(pixels_near(first, ink::poor), pixels_near(last, ink::poor));
  EXPECT_EQ(pixels_near(last, ink::poor, 0.04), 0);
  // The head of the first panel is tinted as a poor one.
  const auto head = first.pixel(40, 4);
  EXPECT_GT(head.r, head.g);
}

TEST(SliceSheet, TreesWithoutPointsAreShown) {
  const auto& s = survey();
  EXPECT_EQ(slice_sheets(s.stems, PointCloud(), 180).size(), 2U);
}

TEST(Statistics, ByHand) {
  const auto s = error_statistics({11, 19, 33}, {10, 20, 30});
  EXPECT_EQ(s.count, 3U);
  EXPECT_DOUBLE_EQ(s.bias, 1);
  // (10 - 5 + 10) / 3 and the root of (100 + 25 + 100) / 3, as evaluation.plot defines relBIAS and relRMSE
  EXPECT_NEAR(s.relative_bias_pct, 5, 1e-12);
  EXPECT_NEAR(s.relative_rmse_pct, std::sqrt(75.0), 1e-12);
  EXPECT_NEAR(s.rmse, std::sqrt(11.0 / 3), 1e-12);
  EXPECT_NEAR(error_statistics({1, 2, 3}, {2, 4, 6}).r_squared, 1, 1e-12);
}

TEST(Statistics, SpreadOfPositions) {
  const auto s = error_spread({{1, 0}, {-1, 0}, {0, 0.5}, {0, -0.5}});
  EXPECT_DOUBLE_EQ(s.mean.norm(), 0);
  EXPECT_DOUBLE_EQ(s.covariance(0, 0), 0.5);
  EXPECT_NEAR(s.max_sigma, std::sqrt(0.5), 1e-12);
}

TEST(Charts, AllComeOutInEveryFormat) {
  for (const auto& figure : all_charts()) {
    const auto image = figure_image(figure, 40);
    EXPECT_EQ(image.width, std::lround(figure.width_mm / 25.4 * 40)) << figure.name;
    EXPECT_LT(pixels_near(image, ink::paper, 0.02), 0.97 * image.width * image.height) << figure.name;
    EXPECT_EQ(testing_data::markup_trouble(figure_svg(figure)), "") << figure.name;
    EXPECT_THAT(figure_pdf(figure), testing::StartsWith("%PDF")) << figure.name;
    EXPECT_FALSE(figure.caption.empty());
  }
}

// Set BOLE_FIGURES_DIR to look at them.
TEST(Charts, WriteThemForTheEye) {
  const char* dir = std::getenv("BOLE_FIGURES_DIR");
  if (dir == nullptr) GTEST_SKIP() << "BOLE_FIGURES_DIR is not set";
  for (const auto& figure : all_charts()) {
    write_text_file(std::filesystem::path(dir) / (figure.name + ".png"), figure_png(figure, 200));
    write_text_file(std::filesystem::path(dir) / (figure.name + ".svg"), figure_svg(figure));
    write_text_file(std::filesystem::path(dir) / (figure.name + ".pdf"), figure_pdf(figure));
  }
}

TEST(Charts, RightAndWrongLoopsAreDrawnInTheirColours) {
  const auto& s = survey();
  const auto loops = two_loops(s.trajectory);
  const auto without = figure_image(trajectory_overlay({&s.trajectory, &s.reference, nullptr}, 160), 100),
             with = figure_image(trajectory_overlay({&s.trajectory, &s.reference, &loops}, 160), 100);
  EXPECT_GT(pixels_near(with, ink::poor), pixels_near(without, ink::poor));
  EXPECT_GT(pixels_near(with, ink::good), pixels_near(without, ink::good));
}

TEST(Charts, ATrajectoryOfOnePoseIsRefused) {
  const auto& s = survey();
  Trajectory one;
  one.poses.push_back(s.trajectory.poses.front());
  EXPECT_THROW(trajectory_overlay({&one, &s.reference, nullptr}, 160), Error);
  EXPECT_THROW(trajectory_sheet({&s.trajectory, nullptr, nullptr}, 160), Error);
}

}  // namespace
}  // namespace bole::render
