// The hot paths of the SLAM engine: the distribution map, the registration of one frame, and odometry frame by frame.
#include <benchmark/benchmark.h>

#include "slam/core/odometry/features.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/odometry/observability.h"
#include "slam/core/slam.h"
#include "synthetic/scan_world.h"

namespace {

using namespace bole;

synthetic::SyntheticScan walk(std::size_t frames) {
  auto sensor = synthetic::SpinningSensor::vlp32c(900);
  sensor.range_noise_m = 0.01;
  return {synthetic::trunks(16, 4), sensor, [](double t) { return synthetic::walk_on_circle(t, 8, 1, 1, 0.3); },
          frames};
}

// A second of walking as a map with true poses, and the frame after it.
struct Scene {
  slam::SlamSettings settings = slam::resolved({});
  slam::FeatureMaps maps{settings.cell_size};
  std::vector<Eigen::Vector3d> points;  // of the map
  slam::FeatureSet query;
  slam::FrameMotion truth, guess;

  Scene() {
    const auto source = walk(12);
    slam::FeatureExtractor extractor(settings);
    ScanFrame frame;
    slam::Scan scan;
    slam::Features features;
    for (std::size_t i = 0; i < source.size(); ++i) {
      source.read(i, frame);
      slam::prepare_scan(frame, {0.5, 60, source.rings()}, scan);
      extractor.extract(scan, features);
      const slam::FrameMotion motion{source.truth(frame.start_time_s), source.truth(frame.end_time_s)};
      if (i + 1 == source.size()) {
        query = features.query;
        truth = motion;
      } else {
        const auto keyframe = slam::make_keyframe(i, frame.end_time_s, features.map, motion);
        slam::insert_keyframe(keyframe, maps);
        for (const auto& p : keyframe.planes) points.push_back(keyframe.T_map_keyframe * p.cast<double>());
      }
    }
    const Pose off = se3_exp((Vector6d() << 0.01, -0.005, 0.01, 0.03, 0.02, -0.02).finished());
    guess = {truth.T_map_begin * off, truth.T_map_end * off};
  }
};

const Scene& scene() {
  static const Scene s;
  return s;
}

void map_insert(benchmark::State& state) {
  const auto& s = scene();
  for (auto _ : state) {
    slam::DistributionMap map(s.settings.cell_size);
    map.insert(s.points);
    benchmark::DoNotOptimize(map.cells(0));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(s.points.size()));
}
BENCHMARK(map_insert)->Unit(benchmark::kMillisecond);

void map_look_up(benchmark::State& state) {
  const auto& s = scene();
  const int level = static_cast<int>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(s.maps.planes.surface(s.points[i], level));
    i = (i + 7919) % s.points.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(map_look_up)->Arg(0)->Arg(2)->Arg(4);

void register_elastic(benchmark::State& state) {
  const auto& s = scene();
  slam::RegistrationSettings settings;
  settings.model = slam::MotionModel::elastic;
  settings.begin_sigma = settings.motion_sigma = 0.1;
  settings.begin_sigma_rad = settings.motion_sigma_rad = 0.05;
  double iterations = 0;
  for (auto _ : state) {
    const auto r = slam::register_frame(s.query, s.maps, s.guess, settings, {});
    iterations = r.iterations;
    benchmark::DoNotOptimize(r.overlap);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(s.query.size()));
  state.counters["iterations"] = iterations;
}
BENCHMARK(register_elastic)->Unit(benchmark::kMillisecond)->UseRealTime();

void judge_observability(benchmark::State& state) {
  const auto& s = scene();
  for (auto _ : state) benchmark::DoNotOptimize(slam::observability(s.query, s.maps, s.truth, {}, {}).weakest);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(s.query.size()));
}
BENCHMARK(judge_observability)->Unit(benchmark::kMillisecond)->UseRealTime();

// Frames per second of odometry alone, features included; frames are made beforehand.
void odometry(benchmark::State& state) {
  class Made : public synthetic::SyntheticScan {
   public:
    explicit Made(synthetic::SyntheticScan scan) : SyntheticScan(std::move(scan)) {
      frames_.resize(size());
      for (std::size_t i = 0; i < size(); ++i) SyntheticScan::read(i, frames_[i]);
    }
    void read(std::size_t index, ScanFrame& frame) const override { frame = frames_[index]; }

   private:
    std::vector<ScanFrame> frames_;
  };
  const Made source(walk(20));
  slam::SlamOptions options;
  options.loops = slam::LoopSource::none;
  options.refine_iterations = 0;
  options.dense_map = false;
  for (auto _ : state) benchmark::DoNotOptimize(slam::run_slam(source, options, {}).trajectory.poses.size());
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(source.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(odometry)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
