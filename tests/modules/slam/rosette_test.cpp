// Scanners without scan lines: the walk is mapped by thinned points, with an inertial unit and without.
#include <gmock/gmock.h>

#include <cmath>

#include "modules/slam/walks.h"
#include "slam/core/slam.h"
#include "synthetic/inertial_unit.h"
#include "synthetic/rosette_scan.h"

namespace bole::slam {
namespace {

using synthetic::RosetteModel;
using synthetic::RosetteScan;
using testing::HasSubstr;

RosetteScan rosette_walk(std::size_t frames, const RosetteModel& model = {}) {
  return {synthetic::trunks(9, 3.5), model, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); },
          frames};
}

TEST(Rosette, AWalkIsMapped) {
  const auto scan = rosette_walk(30);
  auto options = with_preset(Preset::best);
  const auto result = run_slam(scan, options, {});
  // Two frames at rest tell too little by themselves, and are left out.
  EXPECT_GE(result.report.counts.at("frames"), 28) << testing::PrintToString(result.report.warnings);
  EXPECT_LT(worst_m(result.trajectory, scan), 0.03);
  EXPECT_GT(result.points.size(), 10000u);
  const auto& rings = result.points.values<std::uint16_t>(arrays::ring);
  EXPECT_TRUE(std::ranges::all_of(rings, [](auto r) { return r == 0; }));
}

TEST(Rosette, WithAnInertialUnitItIsLevelAndAtLeastAsGood) {
  const auto scan = rosette_walk(30);
  auto options = with_preset(Preset::best);
  options.dense_map = false;
  const auto without = run_slam(scan, options, {});
  const auto record =
      synthetic::inertial_record([&](double t) { return scan.truth(t); }, -0.5, 4, synthetic::small_unit());
  const synthetic::WithUnit with_unit(scan, record);
  const auto with = run_slam(with_unit, options, {});
  EXPECT_EQ(with.report.counts.at("frames"), 30) << testing::PrintToString(with.report.warnings);
  EXPECT_GT(with.report.counts.at("frames_inertial"), 25);
  EXPECT_LT(worst_m(with.trajectory, scan), std::max(0.03, worst_m(without.trajectory, scan) + 0.005));
}

// A view of 80 by 25 deg sees a part of the plot only: the walk of a circle is 8 cm off at its worst place.
TEST(Rosette, ANarrowViewIsMappedWithAnInertialUnit) {
  RosetteModel model;
  model.half_width_deg = 40.85;
  model.low_deg = -14;
  model.high_deg = 11;
  model.turns_hz = 53.1;
  const auto scan = rosette_walk(30, model);
  auto options = with_preset(Preset::inertial);
  options.dense_map = false;
  const auto record =
      synthetic::inertial_record([&](double t) { return scan.truth(t); }, -0.5, 4, synthetic::small_unit());
  const synthetic::WithUnit with_unit(scan, record);
  const auto result = run_slam(with_unit, options, {});
  EXPECT_EQ(result.report.counts.at("frames"), 30) << testing::PrintToString(result.report.warnings);
  EXPECT_LT(worst_m(result.trajectory, scan), 0.1);
}

}  // namespace
}  // namespace bole::slam
