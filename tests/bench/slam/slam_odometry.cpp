// slam_odometry SCAN [poses=FILE] [frames=N] [repeat=N] [option=value ...]
// Odometry alone (no loops, no adjustment, no map) on a scan held in memory: prints a line of JSON with the time per
// frame and, for `poses`, writes the pose in the middle of each frame, in the axes of the first (KITTI: three rows of
// four). What tests/bench/peers/kiss_icp_odometry.py runs.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "io/core/scans/frame_source.h"
#include "slam/core/slam.h"

namespace {

using namespace bole;

class FramesInMemory : public FrameSource {
 public:
  FramesInMemory(const FrameSource& source, std::size_t max_frames) : rings_(source.rings()) {
    frames_.resize(std::min(max_frames, source.size()));
    for (std::size_t i = 0; i < frames_.size(); ++i) source.read(i, frames_[i]);
  }
  std::size_t size() const override { return frames_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override { frame = frames_[index]; }
  double frame_time_s(std::size_t index) const override { return frames_[index].start_time_s; }
  int rings() const override { return rings_; }
  std::string sensor_model() const override { return "unknown"; }
  std::string description() const override { return "frames in memory"; }
  std::string locator() const override { return "{}"; }
  const ScanFrame& frame(std::size_t index) const { return frames_[index]; }

 private:
  std::vector<ScanFrame> frames_;
  int rings_;
};

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

void write_poses(const std::string& file, const FramesInMemory& source, const Trajectory& trajectory) {
  std::ofstream out(file);
  out.precision(9);
  const auto at_middle = [&](std::size_t i) {
    const auto& frame = source.frame(i);
    return trajectory.at(0.5 * (frame.start_time_s + frame.end_time_s));
  };
  const Pose T_first_map = at_middle(0).inverse();
  for (std::size_t i = 0; i < source.size() && source.frame(i).start_time_s < trajectory.poses.back().time_s; ++i) {
    const Eigen::Matrix<double, 3, 4> T = (T_first_map * at_middle(i)).matrix().topRows<3>();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) out << T(r, c) << (r == 2 && c == 3 ? '\n' : ' ');
  }
  out.close();
  if (!out) throw failure("cannot write " + file);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) throw bad_input("no scan", "slam_odometry SCAN [poses=FILE] [frames=N] [repeat=N] [option=value ...]");
  std::map<std::string, std::string> own{{"poses", ""}, {"frames", "1000000"}, {"repeat", "1"}};
  OptionSet options(option_table(static_cast<const slam::SlamOptions*>(nullptr)));
  options.set_text("loops", "none");
  options.set_text("refine_iterations", "0");
  options.set_text("dense_map", "false");
  options.set_text("trajectory_rate", "1000");
  for (int i = 2; i < count; ++i) {
    const std::string word = arguments[i];
    const auto equals = word.find('=');
    if (equals == std::string::npos) throw bad_input("argument '" + word + "'", "name=value");
    const auto name = word.substr(0, equals), value = word.substr(equals + 1);
    if (own.contains(name))
      own[name] = value;
    else
      options.set_text(name, value);
  }
  const FramesInMemory source(*io::open_frame_source(arguments[1]), std::stoul(own["frames"]));
  nlohmann::json out;
  for (int i = 0; i < std::stoi(own["repeat"]); ++i) {
    const double user_s = user_seconds();
    const auto start = std::chrono::steady_clock::now();
    const auto result = slam::run_slam(source, options.as<slam::SlamOptions>(), {});
    const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                 to_ms = 1000 / static_cast<double>(source.size());
    out["wall_ms"].push_back(wall_s * to_ms);
    out["user_ms"].push_back((user_seconds() - user_s) * to_ms);
    out["message"] = result.report.message;
    for (const auto& [name, value] : result.report.counts) out["counts"][name] = value;
    for (const auto& [name, m] : result.report.metrics) out["metrics"][name] = m.value;
    out["warnings"] = result.report.warnings;
    if (!own["poses"].empty()) write_poses(own["poses"], source, result.trajectory);
  }
  std::printf("%s\n", out.dump().c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "slam_odometry: %s\n", error.what());
  return 1;
}
