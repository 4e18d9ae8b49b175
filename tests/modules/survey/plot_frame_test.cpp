#include "survey/core/plot_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "checks.h"
#include "cloud/known_facts.h"
#include "survey/core/move_cloud.h"
#include "synthetic/target_plot.h"

namespace bole::survey {
namespace {

using synthetic::TargetPlot;
using synthetic::TargetPlotMaker;
using synthetic::TargetPlotRecipe;
using ::testing::HasSubstr;

constexpr double deg = std::numbers::pi / 180;

// Where a hand-held start may leave the map: turned, tilted, 1.6 m above the ground and a step away.
Pose tilted_map() {
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(6 * deg, -4 * deg, 73 * deg);
  T.translation() = Eigen::Vector3d(0.7, -0.4, -1.5);
  return T;
}

struct FrameError {
  double tilt_deg = 0, heading_deg = 0;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
};

FrameError frame_error(const PlotFrame& frame, const Pose& T_map_plot) {
  const Pose T = frame.T_plot_map * T_map_plot;  // identity when right
  FrameError e;
  e.tilt_deg = std::acos(std::min(1.0, T.linear()(2, 2))) / deg;
  e.heading_deg = std::atan2(T.linear()(1, 0), T.linear()(0, 0)) / deg;
  e.origin_m = T.translation();
  return e;
}

PlotFrame find(const TargetPlot& plot, const FrameOptions& options = {}, bool with_trajectory = true) {
  return find_plot_frame(plot.cloud, with_trajectory ? &plot.trajectory : nullptr, options, bole::Run{});
}

TEST(PlotFrame, TiltedMapsOfSlopingPlotsAreSetRight) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    TargetPlotRecipe r;
    r.seed = seed;
    const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
    const auto e = frame_error(frame, tilted_map());
    printf("seed %u: tilt %.3f deg, heading %.3f deg, origin (%.3f, %.3f, %.3f) m; %s\n", seed, e.tilt_deg,
           e.heading_deg, e.origin_m.x(), e.origin_m.y(), e.origin_m.z(), frame.report.message.c_str());
    EXPECT_EQ(frame.axes, Axes::plot);
    EXPECT_EQ(frame.report.facts.at("axes"), "plot");
    EXPECT_EQ(frame.report.facts.at("level"), "stems");
    // 50 stems that lean by 1 deg (SD per axis) tell the vertical to 0.14 deg per axis, whatever the method.
    const double se = frame.report.metrics.at("tilt_standard_error").value;
    EXPECT_LT(se, 0.2);
    EXPECT_LT(e.tilt_deg, 3 * se);
    EXPECT_LT(std::abs(e.heading_deg), 0.15);
    EXPECT_LT(e.origin_m.head<2>().norm(), 0.015);
    EXPECT_LT(std::abs(e.origin_m.z()), 0.02);
    ASSERT_EQ(frame.targets.rows(), 2U);
    EXPECT_EQ(frame.targets.texts("name"), (std::vector<std::string>{"centre", "north"}));
    EXPECT_NEAR(frame.targets.numbers("y_m")[1], 16, 0.03);
    EXPECT_EQ(frame.targets.facts.at("axes"), "plot");
  }
}

TEST(PlotFrame, GravityThatAUnitToldGoesBeforeTheStems) {
  TargetPlotRecipe r;
  auto plot = TargetPlotMaker(r).make(Pose::Identity());
  FrameOptions options;
  options.level = Level::gravity;
  EXPECT_THAT(testing_checks::refusal_of([&] { find(plot, options); }), HasSubstr("direction of gravity"));
  const auto by_stems = find(plot);
  EXPECT_FALSE(by_stems.by_gravity);

  set_fact(plot.cloud.facts, facts::level_sigma, 0.04);
  for (const auto level : {Level::automatic, Level::gravity}) {
    options.level = level;
    const auto frame = find(plot, options);
    EXPECT_TRUE(frame.by_gravity);
    EXPECT_EQ(frame.report.facts.at("level"), "gravity");
    EXPECT_NEAR(frame.report.metrics.at("tilt_standard_error").value, 0.04, 1e-12);
    EXPECT_NEAR(frame.T_plot_map.linear()(2, 2), 1, 1e-12);  // z stays up
    EXPECT_NEAR(frame.report.metrics.at("target_distance").value, by_stems.report.metrics.at("target_distance").value,
                0.2);
  }
  options.level = Level::stems;
  EXPECT_FALSE(find(plot, options).by_gravity);
  set_fact(plot.cloud.facts, facts::level_sigma, 0.8);  // the stems tell it better
  EXPECT_EQ(find(plot).report.facts.at("level"), "stems");
}

TEST(PlotFrame, UprightStemsTellTheVerticalToATenthOfADegree) {
  TargetPlotRecipe r;
  r.lean_sd_deg = 0.2, r.slope_deg = 30;
  const auto e = frame_error(find(TargetPlotMaker(r).make(tilted_map())), tilted_map());
  EXPECT_LT(e.tilt_deg, 0.1);
  EXPECT_LT(std::abs(e.heading_deg), 0.1);
}

TEST(PlotFrame, BearingOfTheNorthTargetTurnsTheAxes) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  FrameOptions o;
  o.north_bearing_deg = 10;
  EXPECT_NEAR(frame_error(find(plot, o), tilted_map()).heading_deg, -10, 0.2);
  const auto frame = find(plot, o);
  EXPECT_NEAR(frame.targets.numbers("x_m")[1], 16 * std::sin(10 * deg), 0.05);
  EXPECT_NEAR(frame.targets.numbers("y_m")[1], 16 * std::cos(10 * deg), 0.05);
}

TEST(PlotFrame, ClutterIsRejectedWithReasons) {
  const auto frame = find(TargetPlotMaker({}).make(tilted_map()));
  EXPECT_EQ(frame.report.counts.at("target_candidates"), 2);
  std::string reasons;
  for (const auto& [name, text] : frame.report.facts)
    if (name.rfind("rejected", 0) == 0) reasons += text + "\n";
  EXPECT_THAT(reasons, HasSubstr("target_size"));
  EXPECT_THAT(reasons, HasSubstr("target_views"));
}

TEST(PlotFrame, ABentMapKeepsItsTargetsAndSaysSo) {
  TargetPlotRecipe r;
  r.bend_m = 0.8;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  EXPECT_EQ(frame.axes, Axes::plot);
  EXPECT_NEAR(frame.targets.numbers("y_m").at(1), r.north_distance_m, 0.1);
  EXPECT_THAT(frame.report.warnings, ::testing::Contains(HasSubstr("the map is bent or doubled there")));
  r.bend_m = 0;
  EXPECT_THAT(find(TargetPlotMaker(r).make(tilted_map())).report.warnings, ::testing::IsEmpty());
}

TEST(PlotFrame, APassOfAnotherTypeIsReadToo) {
  auto plot = TargetPlotMaker({}).make(tilted_map());
  plot.cloud.set_column(arrays::pass.name, make_column(ArrayType::uint8, plot.cloud.size()));
  EXPECT_EQ(find(plot).axes, Axes::plot);
}

TEST(PlotFrame, AReflectiveJacketThatWalksAlongIsNoTarget) {
  TargetPlotRecipe r;
  r.moving_jacket = true;
  r.north_target = false;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  ASSERT_EQ(frame.targets.rows(), 1U);
  EXPECT_THAT(frame.report.warnings, ::testing::Contains(HasSubstr("not taken for the other target")));
  std::string reasons;
  for (const auto& [name, text] : frame.report.facts)
    if (name.rfind("rejected", 0) == 0) reasons += text + "\n";
  EXPECT_THAT(reasons, HasSubstr("it moves, or the map is bent"));
}

TEST(PlotFrame, WithoutTargetsTheMapIsLevelledAndKept) {
  TargetPlotRecipe r;
  r.centre_target = r.north_target = false;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  EXPECT_EQ(frame.axes, Axes::map);
  EXPECT_EQ(frame.report.facts.at("axes"), "map");
  EXPECT_EQ(frame.targets.rows(), 0U);
  EXPECT_TRUE(frame.targets.has("x_m"));
  EXPECT_LT(frame.T_plot_map.translation().norm(), 1e-9);
  EXPECT_LT(frame_error(frame, tilted_map()).tilt_deg, 0.5);
  EXPECT_THAT(frame.report.message, HasSubstr("no targets"));
}

TEST(PlotFrame, OneTargetGivesTheOriginAndKeepsTheHeading) {
  TargetPlotRecipe r;
  r.north_target = false;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  EXPECT_EQ(frame.axes, Axes::map);
  ASSERT_EQ(frame.targets.rows(), 1U);
  const auto e = frame_error(frame, tilted_map());
  EXPECT_LT(e.origin_m.norm(), 0.03);
  EXPECT_NEAR(e.heading_deg, 73, 1.0);
  EXPECT_THAT(frame.report.warnings, ::testing::Contains(HasSubstr("heading")));
}

TEST(PlotFrame, MissingIntensityOnlyLevels) {
  TargetPlotRecipe r;
  r.intensity = false;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  EXPECT_EQ(frame.axes, Axes::map);
  ASSERT_FALSE(frame.report.warnings.empty());
  EXPECT_THAT(frame.report.warnings.front(), HasSubstr("no array intensity"));
}

TEST(PlotFrame, IntensityOfAnotherScaleIsNotTakenForTargets) {
  auto plot = TargetPlotMaker({}).make(tilted_map());
  auto intensity = plot.cloud.values<float>(arrays::intensity);
  for (auto& v : intensity) v *= 100;
  plot.cloud.set_column(arrays::intensity, std::move(intensity));
  const auto frame = find(plot);
  EXPECT_EQ(frame.axes, Axes::map);
  EXPECT_THAT(frame.report.warnings.front(), HasSubstr("min_intensity"));
}

TEST(PlotFrame, WithoutTrajectoryTheAssumptionIsNamed) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  const auto frame = find(plot, {}, false);
  EXPECT_EQ(frame.axes, Axes::plot);
  EXPECT_LT(frame_error(frame, tilted_map()).origin_m.norm(), 0.03);
  EXPECT_THAT(frame.report.warnings.front(), HasSubstr("no trajectory"));
}

TEST(PlotFrame, DistanceOfTheTargetsMustFit) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  FrameOptions o;
  o.target_distance = 16;
  EXPECT_EQ(find(plot, o).axes, Axes::plot);
  o.target_distance = 12;
  const auto frame = find(plot, o);
  EXPECT_EQ(frame.axes, Axes::map);
  EXPECT_THAT(frame.report.warnings.front(), HasSubstr("12 +- 1 m"));
}

TEST(PlotFrame, FewStemsFallBackToTheGroundWithAWarning) {
  TargetPlotRecipe r;
  r.stems = 0, r.slope_deg = 0;
  const auto frame = find(TargetPlotMaker(r).make(tilted_map()));
  EXPECT_EQ(frame.report.facts.at("level"), "ground");
  EXPECT_LT(frame_error(frame, tilted_map()).tilt_deg, 0.2);
  EXPECT_THAT(frame.report.warnings.front(), HasSubstr("min_stems"));
}

TEST(PlotFrame, OrderOfPointsDoesNotMatter) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  std::vector<std::uint32_t> order(plot.cloud.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const auto a = find(plot), b = find({plot.cloud.subset(order), plot.trajectory});
  EXPECT_LT((a.T_plot_map.matrix() - b.T_plot_map.matrix()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(PlotFrame, EmptyCloudIsRefused) {
  try {
    find_plot_frame(PointCloud(), nullptr, {}, bole::Run{});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    EXPECT_THAT(e.what(), HasSubstr("no points"));
  }
}

TEST(PlotFrame, CancelLeavesAtOnce) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(find_plot_frame(plot.cloud, nullptr, {}, run), Error);
}

TEST(MoveCloud, SensorPositionsAndTrajectoryMoveAlong) {
  const auto plot = TargetPlotMaker({}).make(Pose::Identity());
  const Pose T = tilted_map();
  const auto moved = move_cloud(plot.cloud, T, Eigen::Vector3d(1, 2, 3), Axes::plot, bole::Run{});
  EXPECT_EQ(moved.axes, Axes::plot);
  for (const std::size_t i : {std::size_t{0}, plot.cloud.size() / 2, plot.cloud.size() - 1}) {
    EXPECT_LT((moved.position(i) - T * plot.cloud.position(i)).norm(), 1e-5);
    const Eigen::Vector3d before(plot.cloud.values<float>(arrays::sensor_x)[i],
                                 plot.cloud.values<float>(arrays::sensor_y)[i],
                                 plot.cloud.values<float>(arrays::sensor_z)[i]);
    const Eigen::Vector3d after(moved.values<float>(arrays::sensor_x)[i], moved.values<float>(arrays::sensor_y)[i],
                                moved.values<float>(arrays::sensor_z)[i]);
    EXPECT_LT((moved.origin + after - T * before).norm(), 1e-5);
  }
  // Other columns are shared, not copied.
  EXPECT_EQ(moved.columns().at("intensity").get(), plot.cloud.columns().at("intensity").get());
  const auto path = move_trajectory(plot.trajectory, T, Axes::plot);
  EXPECT_LT((path.poses[7].T_target_sensor.matrix() - (T * plot.trajectory.poses[7].T_target_sensor).matrix()).norm(),
            1e-12);
}

}  // namespace
}  // namespace bole::survey
