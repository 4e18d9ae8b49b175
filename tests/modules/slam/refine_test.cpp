#include "slam/core/map/refine.h"

#include <gtest/gtest.h>

#include "synthetic/scan_world.h"

namespace bole::slam {
namespace {

using synthetic::SpinningSensor;
using synthetic::SyntheticScan;

std::vector<FrameSample> samples_of(const SyntheticScan& source) {
  SlamOptions options;
  options.preset = Preset::best;
  FeatureExtractor extractor(resolved(options));
  std::vector<FrameSample> samples;
  ScanFrame frame;
  Scan scan;
  Features features;
  for (std::size_t k = 0; k < source.size(); ++k) {
    source.read(k, frame);
    prepare_scan(frame, {0.5, 60, source.rings()}, scan);
    extractor.extract(scan, features);
    samples.push_back({scan.begin_time_s, scan.end_time_s, features.map});
  }
  return samples;
}

// Mean over the returns from trunks of how much nearer the sensor is put than it was.
double mean_nearness_m(const Path& path, const SyntheticScan& source, const std::vector<FrameSample>& samples) {
  double sum = 0, n = 0;
  for (const auto& sample : samples)
    for (const auto& p : sample.features.planes) {
      const double t = sample.begin_s + static_cast<double>(p.s) * (sample.end_s - sample.begin_s);
      const Pose truth = source.truth(t);
      const Eigen::Vector3d ray = truth.linear() * p.position.cast<double>();
      if (ray.z() + truth.translation().z() < 0.3) continue;
      sum += ray.normalized().dot(path.at(t).translation() - truth.translation());
      n += 1;
    }
  return sum / n;
}

// A sensor that turns sees one side at a time, so a path that bends fast enough can be too near on all sides.
TEST(Refine, DoesNotDrawThePathToTheTrunks) {
  auto sensor = SpinningSensor::even(32, -25, 15, 600);
  sensor.range_noise_m = 0.01;
  const SyntheticScan source(
      synthetic::trunks(10, 2.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); }, 14);
  const auto samples = samples_of(source);
  std::vector<StampedPose> nodes;
  for (double t = 0; t < 1.41; t += 0.05) nodes.push_back({t, source.truth(t)});
  RefineSettings settings;
  settings.iterations = 4;
  const auto refined = refine_path(Path(nodes), samples, settings, {});
  EXPECT_LT(std::abs(mean_nearness_m(refined.path, source, samples)), 0.0015);
  double worst_m = 0;
  for (double t = 0; t < 1.4; t += 0.01)
    worst_m = std::max(worst_m, (refined.path.at(t).translation() - source.truth(t).translation()).norm());
  EXPECT_LT(worst_m, 0.015);
}

// With nothing to hold the nodes that no frame touches, the system has no solution: the path stays, and this is told.
TEST(Refine, KeepsThePathWhereTheFramesDoNotDetermineIt) {
  const SyntheticScan source(
      synthetic::trunks(10, 2.5), SpinningSensor::even(16, -25, 15, 300),
      [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); }, 4);
  std::vector<StampedPose> nodes;
  for (double t = 0; t < 2.01; t += 0.05) nodes.push_back({t, source.truth(t)});
  RefineSettings settings;
  settings.acceleration_sigma = settings.angular_acceleration_sigma = 1e200;
  const auto refined = refine_path(Path(nodes), samples_of(source), settings, {});
  EXPECT_EQ(refined.stopped, "it has no solution");
  EXPECT_TRUE(refined.rms.empty());
  EXPECT_EQ(refined.path.at(0.2).matrix(), Path(nodes).at(0.2).matrix());
}

}  // namespace
}  // namespace bole::slam
