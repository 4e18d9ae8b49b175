#include "slam/core/odometry/ground.h"

#include <gtest/gtest.h>

#include "synthetic/scan_world.h"

namespace bole::slam {
namespace {

TEST(Ground, GroundIsTheFloorThingsAreTrunksAndSpecksAreNot) {
  synthetic::World world;
  world.planes.push_back({Eigen::Vector3d::UnitZ(), 0});
  for (const double y : {-3.0, 0.5, 4.0}) world.cylinders.push_back({{6, y, -0.2}, Eigen::Vector3d::UnitZ(), 0.3, 8});
  const auto still = [](double) {
    Pose T = Pose::Identity();
    T.translation().z() = 1.5;
    return T;
  };
  synthetic::SyntheticScan source(world, synthetic::SpinningSensor::vlp32c(900), still, 1);
  source.spoil = [](std::size_t, ScanFrame& frame) {  // specks in the air, far from one another
    for (std::size_t i = 0; i < frame.size(); i += 997) frame.positions[i] = frame.positions[i].normalized() * 2;
  };
  ScanFrame frame;
  source.read(0, frame);
  Scan scan;
  prepare_scan(frame, {0.5, 60, 32}, scan);
  const auto labels = label_scan(scan);
  ASSERT_EQ(labels.size(), scan.points.size());
  std::size_t floor = 0, floor_right = 0, trunk = 0, trunk_right = 0, specks = 0, specks_right = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double z = scan.points[i].position.z();
    if (std::abs(scan.points[i].range - 2) < 1e-3) {
      ++specks;
      specks_right += labels[i] != ScanLabel::object;
    } else if (z < -1.45) {
      ++floor;
      floor_right += labels[i] == ScanLabel::ground;
    } else if (z > -1.2) {
      ++trunk;
      trunk_right += labels[i] == ScanLabel::object;
    }
  }
  EXPECT_GT(static_cast<double>(floor_right), 0.9 * static_cast<double>(floor));
  EXPECT_GT(static_cast<double>(trunk_right), 0.9 * static_cast<double>(trunk));
  EXPECT_GT(static_cast<double>(specks_right), 0.8 * static_cast<double>(specks));
}

}  // namespace
}  // namespace bole::slam
