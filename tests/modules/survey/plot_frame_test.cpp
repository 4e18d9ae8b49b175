#include "survey/core/plot_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

PlotFrame find(const TargetPlot& plot, const FrameOptions& options = {}, bool with_trajectory = true) { return find_plot_frame(plot.cloud, with_trajectory ? &plot.trajectory : nullptr, options, Run{}); }

TEST(PlotFrame, TiltedMapOfASlopingPlotIsSetRight) {
  const auto plot = TargetPlotMaker({}).make(tilted_map());
  const auto frame = find(plot);
  const auto e = frame_error(frame, tilted_map());
  printf("%s\n tilt %.3f heading %.3f deg, origin %.3f %.3f %.3f\n", frame.report.message.c_str(), e.tilt_deg, e.heading_deg, e.origin_m.x(), e.origin_m.y(), e.origin_m.z());
  for (const auto& [k, v] : frame.report.facts) printf("  %s: %s\n", k.c_str(), v.c_str());
  for (const auto& w : frame.report.warnings) printf("  ! %s\n", w.c_str());
  EXPECT_EQ(frame.axes, Axes::plot);
  EXPECT_LT(e.tilt_deg, 0.3);
  EXPECT_LT(std::abs(e.heading_deg), 0.2);
  EXPECT_LT(e.origin_m.head<2>().norm(), 0.02);
  EXPECT_LT(std::abs(e.origin_m.z()), 0.02);
}

}  // namespace
}  // namespace bole::survey
