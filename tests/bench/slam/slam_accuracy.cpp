// slam_accuracy [pcap=FILE truth=FILE.tum] [frames=N] [option=value ...]
// Runs the SLAM engine on a recording with known trajectory (or on a synthetic plot) and prints the trajectory error, the time per
// frame, and how thick the trunks of the synthetic plot are in the map.
#include <sys/resource.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cstdio>
#include <map>

#include "slam/core/slam.h"
#include "slam/core/tum_poses.h"
#include "synthetic/scan_world.h"
#ifdef BOLE_HAS_IO
#include "io/core/frame_sources.h"
#endif

namespace {

using namespace bole;

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

struct TrajectoryErrors {
  double ate_m = 0, worst_m = 0, turn_deg = 0, step_m = 0, end_m = 0;
};

// After the best rigid alignment of positions (Umeyama without scale).
TrajectoryErrors compare(const Trajectory& estimate, const Trajectory& truth) {
  std::vector<Pose> E, G;
  for (std::size_t i = 0; i < estimate.poses.size(); i += 5) {
    const auto& p = estimate.poses[i];
    if (p.time_s < truth.poses.front().time_s || p.time_s > truth.poses.back().time_s) continue;
    E.push_back(p.T_target_sensor);
    G.push_back(truth.at(p.time_s));
  }
  Eigen::Matrix3Xd e(3, E.size()), g(3, G.size());
  for (std::size_t i = 0; i < E.size(); ++i) e.col(static_cast<Eigen::Index>(i)) = E[i].translation(), g.col(static_cast<Eigen::Index>(i)) = G[i].translation();
  const Pose A(Eigen::umeyama(e, g, false));
  TrajectoryErrors out;
  for (std::size_t i = 0; i < E.size(); ++i) {
    const Pose aligned = A * E[i];
    const double d = (aligned.translation() - G[i].translation()).norm();
    out.ate_m += d * d;
    out.worst_m = std::max(out.worst_m, d);
    out.turn_deg += std::pow(Eigen::AngleAxisd(aligned.linear().transpose() * G[i].linear()).angle() * 57.29578, 2);
    if (i > 0) out.step_m += (((E[i - 1].inverse() * E[i]).inverse() * (G[i - 1].inverse() * G[i])).translation()).squaredNorm();
  }
  const Pose drift = (E.front().inverse() * E.back()).inverse() * (G.front().inverse() * G.back());
  const auto n = static_cast<double>(E.size());
  out.ate_m = std::sqrt(out.ate_m / n), out.turn_deg = std::sqrt(out.turn_deg / n), out.step_m = std::sqrt(out.step_m / n), out.end_m = drift.translation().norm();
  return out;
}

// Radial residuals of map points about the trunks of the synthetic plot: 1.4826 MAD about the median, over heights of 0.5 to 3 m.
void print_walls(const PointCloud& map, const synthetic::World& world, const Pose& T_world_map) {
  std::vector<double> thickness, bias;
  std::vector<std::vector<double>> residuals(world.cylinders.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Eigen::Vector3d x = T_world_map * map.position(i);
    for (std::size_t c = 0; c < world.cylinders.size(); ++c) {
      const auto& trunk = world.cylinders[c];
      const Eigen::Vector3d o = x - trunk.base;
      const double h = o.dot(trunk.axis);
      if (h < 0.7 || h > 3.2) continue;
      const double r = (o - h * trunk.axis).norm() - trunk.radius;
      if (std::abs(r) < 0.12) residuals[c].push_back(r);
    }
  }
  for (auto& r : residuals) {
    if (r.size() < 200) continue;
    const auto median = [](std::vector<double>& v) {
      std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
      return v[v.size() / 2];
    };
    const double m = median(r);
    for (auto& x : r) x = std::abs(x - m);
    bias.push_back(m);
    thickness.push_back(1.4826 * median(r));
  }
  if (thickness.empty()) return;
  double t = 0, b = 0;
  for (std::size_t i = 0; i < thickness.size(); ++i) t += thickness[i], b += bias[i];
  std::printf("trunks %zu: wall %.2f cm (robust SD), median radial offset %+.2f cm\n", thickness.size(), 100 * t / static_cast<double>(thickness.size()), 100 * b / static_cast<double>(bias.size()));
}

}  // namespace

int main(int count, char** arguments) try {
  std::map<std::string, std::string> own{{"pcap", ""}, {"truth", ""}, {"frames", "200"}, {"noise", "0.02"}, {"gait", "1"}, {"half", "16"}, {"radius", "8"}};
  OptionSet options(option_table(static_cast<const SlamOptions*>(nullptr)));
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto equals = word.find('=');
    if (equals == std::string::npos) throw bad_input("argument '" + word + "'", "name=value");
    const auto name = word.substr(0, equals), value = word.substr(equals + 1);
    if (own.contains(name))
      own[name] = value;
    else
      options.set_text(name, value);
  }

  std::shared_ptr<const FrameSource> source;
  Trajectory truth;
  const synthetic::World world = synthetic::trunks(std::stod(own["half"]), 4);
  if (own["pcap"].empty()) {
    auto sensor = synthetic::SpinningSensor::vlp32c(900);
    sensor.range_noise_m = std::stod(own["noise"]);
    const double gait = std::stod(own["gait"]), radius = std::stod(own["radius"]);
    auto scan = std::make_shared<synthetic::SyntheticScan>(
        world, sensor, [=](double t) { return synthetic::walk_on_circle(t, radius, 1.0, gait); }, std::stoul(own["frames"]));
    truth = scan->true_trajectory(200);
    source = scan;
  } else {
#ifdef BOLE_HAS_IO
    source = open_accuracy_source(own["pcap"]);
    truth.poses = read_tum_poses(own["truth"]);
#else
    throw bad_input("this program was built without the readers", "module io");
#endif
  }

  const double before_s = user_seconds();
  const auto result = run_slam(*source, options.as<SlamOptions>(), {});
  const double user_s = user_seconds() - before_s;
  const auto e = compare(result.trajectory, truth);
  std::printf("%s\n", result.report.message.c_str());
  for (const auto& w : result.report.warnings) std::printf("warning: %s\n", w.c_str());
  for (const auto& [name, value] : result.report.counts) std::printf("%s %lld  ", name.c_str(), static_cast<long long>(value));
  std::printf("\n");
  for (const auto& [name, m] : result.report.metrics) std::printf("%s %.4g %s  ", name.c_str(), m.value, std::string(unit_symbol(m.unit)).c_str());
  std::printf("\nATE RMSE %.2f cm, worst %.2f cm, turn %.3f deg, RPE over 0.1 s %.2f cm, end drift %.2f cm over %.1f m, user %.1f ms/frame\n", 100 * e.ate_m, 100 * e.worst_m, e.turn_deg, 100 * e.step_m, 100 * e.end_m,
              truth.length_m(), 1000 * user_s / static_cast<double>(source->size()));
  if (own["pcap"].empty()) {
    // The map hangs on the first pose: align by all positions for the walls.
    Eigen::Matrix3Xd est(3, result.trajectory.poses.size()), ref(3, result.trajectory.poses.size());
    Eigen::Index n = 0;
    for (const auto& p : result.trajectory.poses) {
      if (p.time_s > truth.poses.back().time_s) continue;
      est.col(n) = p.T_target_sensor.translation(), ref.col(n) = truth.at(p.time_s).translation();
      ++n;
    }
    print_walls(result.points, world, Pose(Eigen::umeyama(est.leftCols(n), ref.leftCols(n), false)));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "slam_accuracy: %s\n", error.what());
  return 1;
}
