// Poses of a folder of views beside the true ones: pose_accuracy FOLDER [no-board] [no-depth] [step=N] [max=N]
// [option=value ...]. Prints what the stage reports, the error of the poses after the best rigid motion (ATE), of
// neighbours, and the time.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "base/statistics.h"
#include "bench/rgbd/folder_views.h"
#include "bench/run_tool.h"
#include "rgbd/core/poses/estimate_poses.h"
#include "synthetic/trajectory_error.h"

namespace bole::bench {
namespace {

void print_report(const Report& report) {
  std::cout << report.message << "\n";
  for (const auto& [key, value] : report.counts) std::cout << fmt::format("  {} {}\n", key, value);
  for (const auto& [key, value] : report.metrics) std::cout << fmt::format("  {} {:.5g}\n", key, value.value);
  for (const auto& [key, value] : report.facts) std::cout << fmt::format("  {} {}\n", key, value);
  for (const auto& f : report.findings) std::cout << fmt::format("  ! {}: {}\n", f.code, f.text);
}

void print_errors(const Trajectory& found, const ViewSource& views) {
  const auto& given = views.given_poses();
  std::vector<Pose> truth;
  synthetic::PosePairs pairs;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto a = pose_of_view(found, views.time_s(i)), b = pose_of_view(given, views.time_s(i));
    if (!a || !b) continue;
    pairs.found.push_back(*a);
    pairs.truth.push_back(*b);
  }
  if (pairs.found.size() < 3) return;
  double scale = 1;
  const double ate = synthetic::ate(pairs, &scale);
  std::vector<double> shift, turn;
  for (std::size_t i = 1; i < pairs.found.size(); ++i) {
    const Pose gap =
        (pairs.truth[i - 1].inverse() * pairs.truth[i]).inverse() * (pairs.found[i - 1].inverse() * pairs.found[i]);
    shift.push_back(gap.translation().norm());
    turn.push_back(so3_log(Eigen::Quaterniond(gap.linear())).norm());
  }
  std::cout << fmt::format(
      "ATE {:.3f} mm; without alignment {:.3f} mm; scale {:.5f}; from view to view median {:.3f} mm "
      "{:.4f} deg\n",
      1e3 * ate, 1e3 * synthetic::place_rms(pairs.found, pairs.truth), scale, 1e3 * median(shift),
      57.29578 * median(turn));
}

int run(int argc, char** argv) {
  if (argc < 2)
    throw std::runtime_error("pose_accuracy FOLDER [no-board] [no-depth] [step=N] [max=N] [option=value ...]");
  FolderOptions folder;
  OptionSet options(rgbd::option_table(static_cast<const rgbd::PoseOptions*>(nullptr)));
  std::string out;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    const auto split = word.find('=');
    const std::string key = word.substr(0, split), value = split == std::string::npos ? "" : word.substr(split + 1);
    if (key == "no-board")
      folder.board = false;
    else if (key == "no-depth")
      folder.depth = false;
    else if (key == "step")
      folder.step = std::atoi(value.c_str());
    else if (key == "max")
      folder.max_views = std::atoi(value.c_str());
    else if (key == "out")
      out = value;
    else
      options.set_text(key, value);
  }
  const auto views = open_folder(argv[1], folder);
  Run run;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::string last;
  run.progress = [&](double fraction, std::string_view what) {
    if (what != last) std::cout << fmt::format("{:7.2f} s {:4.0f} % {}\n", seconds(), 100 * fraction, what);
    last = what;
  };
  const auto found = rgbd::estimate_poses(*views, nullptr, options.as<rgbd::PoseOptions>(), run);
  std::cout << fmt::format("{:7.2f} s\n", seconds());
  print_report(found.report);
  print_errors(found.poses, *views);
  if (out.empty()) return 0;
  std::ofstream file(out);
  for (const auto& p : found.poses.poses) {
    const Eigen::Quaterniond q(p.T_target_sensor.linear());
    const auto& t = p.T_target_sensor.translation();
    file << fmt::format("{:.6f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n", p.time_s, t.x(), t.y(), t.z(),
                        q.x(), q.y(), q.z(), q.w());
  }
  return 0;
}

}  // namespace
}  // namespace bole::bench

int main(int argc, char** argv) { return bole::run_tool(bole::bench::run, argc, argv); }
