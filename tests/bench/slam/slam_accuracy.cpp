// slam_accuracy [scan=FOLDER] [first=N] [frames=N] [table=FILE.csv] [out=FILE.tum] [option=value ...]
// Runs the SLAM engine on a simulated recording (FOLDER of `bole simulate`: walk.pcap or frames, trajectory.tum,
// trees.csv), or a stretch of it, or, without one, on a synthetic plot, and prints the trajectory error, the time per
// frame, and how thick and how wide the trunks are in the map. `table` gets what the odometry found for each frame.
#include <sys/resource.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "evaluation/core/evaluate_loops.h"
#include "slam/core/map/tum_poses.h"
#include "slam/core/slam.h"
#include "stem_truth.h"
#include "synthetic/scan_world.h"
#ifdef BOLE_HAS_IO
#include "io/core/scans/frame_source.h"
#include "io/core/tables/table_file.h"
#endif

namespace {

using namespace bole;

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

struct TrajectoryErrors {
  double ate_m = 0, worst_m = 0, turn_deg = 0, step_size = 0, end_m = 0;
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
  for (std::size_t i = 0; i < E.size(); ++i) {
    e.col(static_cast<Eigen::Index>(i)) = E[i].translation();
    g.col(static_cast<Eigen::Index>(i)) = G[i].translation();
  }
  const Pose A(Eigen::umeyama(e, g, false));
  TrajectoryErrors out;
  for (std::size_t i = 0; i < E.size(); ++i) {
    const Pose aligned = A * E[i];
    const double d = (aligned.translation() - G[i].translation()).norm();
    out.ate_m += d * d;
    out.worst_m = std::max(out.worst_m, d);
    out.turn_deg += std::pow(Eigen::AngleAxisd(aligned.linear().transpose() * G[i].linear()).angle() * 57.29578, 2);
    if (i > 0)
      out.step_size +=
          (((E[i - 1].inverse() * E[i]).inverse() * (G[i - 1].inverse() * G[i])).translation()).squaredNorm();
  }
  const Pose drift = (E.front().inverse() * E.back()).inverse() * (G.front().inverse() * G.back());
  const auto n = static_cast<double>(E.size());
  out.ate_m = std::sqrt(out.ate_m / n);
  out.turn_deg = std::sqrt(out.turn_deg / n);
  out.step_size = std::sqrt(out.step_size / n);
  out.end_m = drift.translation().norm();
  return out;
}

void write_tum(const std::string& file, const Trajectory& path) {
  std::ofstream out(file);
  out.precision(10);
  for (const auto& p : path.poses) {
    const Eigen::Quaterniond q(p.T_target_sensor.linear());
    const Eigen::Vector3d t = p.T_target_sensor.translation();
    out << std::fixed << p.time_s << ' ' << t.x() << ' ' << t.y() << ' ' << t.z() << ' ' << q.x() << ' ' << q.y() << ' '
        << q.z() << ' ' << q.w() << '\n';
  }
}

Pose aligned(const Trajectory& estimate, const Trajectory& truth) {
  Eigen::Matrix3Xd e(3, estimate.poses.size()), g(3, estimate.poses.size());
  Eigen::Index n = 0;
  for (const auto& p : estimate.poses) {
    if (p.time_s < truth.poses.front().time_s || p.time_s > truth.poses.back().time_s) continue;
    e.col(n) = p.T_target_sensor.translation();
    g.col(n) = truth.at(p.time_s).translation();
    ++n;
  }
  return Pose(Eigen::umeyama(e.leftCols(n), g.leftCols(n), false));
}

#ifdef BOLE_HAS_IO
class Stretch : public FrameSource {
 public:
  Stretch(std::shared_ptr<const FrameSource> all, std::size_t first, std::size_t max_frames)
      : all_(std::move(all)), first_(std::min(first, all_->size())), max_frames_(max_frames) {}
  std::size_t size() const override { return std::min(max_frames_, all_->size() - first_); }
  void read(std::size_t index, ScanFrame& frame) const override { all_->read(first_ + index, frame); }
  double frame_time_s(std::size_t index) const override { return all_->frame_time_s(first_ + index); }
  int rings() const override { return all_->rings(); }
  ScanPattern pattern() const override { return all_->pattern(); }
  const InertialRecord* inertial() const override { return all_->inertial(); }
  std::vector<double> ring_elevations_rad() const override { return all_->ring_elevations_rad(); }
  std::string sensor_model() const override { return all_->sensor_model(); }
  std::string description() const override { return all_->description(); }
  std::string locator() const override { return all_->locator(); }

 private:
  std::shared_ptr<const FrameSource> all_;
  std::size_t first_, max_frames_;
};

std::shared_ptr<const FrameSource> recording(const std::string& folder) {
  const std::string capture = folder + "/walk.pcap";
  return io::open_frame_source(std::filesystem::exists(capture) ? capture : folder + "/frames");
}

// A circle through the breast-height points of each tree (algebraic start, Tukey weights), held against its girth.
void print_trees(const PointCloud& map, const Table& trees, const Pose& T_world_map) {
  const auto x = trees.numbers("x_m"), y = trees.numbers("y_m"), z = trees.numbers("z_m"),
             dbh = trees.numbers("dbh_cm"), inside = trees.numbers("in_plot");
  double squared = 0, sum = 0, wall = 0, dx2 = 0;
  int fitted = 0, asked = 0;
  std::vector<Eigen::Vector3d> slice;
  for (std::size_t i = 0; i < map.size(); ++i) slice.push_back(T_world_map * map.position(i));
  for (std::size_t t = 0; t < x.size(); ++t) {
    if (inside[t] == 0) continue;
    ++asked;
    Eigen::Vector3d circle(x[t], y[t], dbh[t] / 200);  // centre and radius
    std::vector<Eigen::Vector2d> points;
    for (const auto& p : slice)
      if (std::abs(p.z() - z[t] - 1.3) < 0.1 && std::abs((p.head<2>() - circle.head<2>()).norm() - circle.z()) < 0.15)
        points.push_back(p.head<2>());
    if (points.size() < 50) continue;
    double scale = 0.05;
    for (int round = 0; round < 30; ++round) {
      Eigen::Matrix3d H = Eigen::Matrix3d::Identity() * 1e-9;
      Eigen::Vector3d g = Eigen::Vector3d::Zero();
      std::vector<double> size;
      for (const auto& p : points) {
        const Eigen::Vector2d d = p - circle.head<2>();
        const double r = d.norm() - circle.z(), u = r / (4.685 * scale),
                     w = std::abs(u) < 1 ? std::pow(1 - u * u, 2) : 0;
        const Eigen::Vector3d J(-d.x() / d.norm(), -d.y() / d.norm(), -1);
        H += w * J * J.transpose();
        g += w * r * J;
        size.push_back(std::abs(r));
      }
      circle -= H.ldlt().solve(g);
      std::nth_element(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2), size.end());
      scale = std::max(0.003, 1.4826 * size[size.size() / 2]);
    }
    const double error_cm = 200 * circle.z() - dbh[t];
    if (std::abs(error_cm) > 15) continue;
    ++fitted;
    squared += error_cm * error_cm;
    sum += error_cm;
    wall += 100 * scale;
    dx2 += (circle.head<2>() - Eigen::Vector2d(x[t], y[t])).squaredNorm();
  }
  std::printf(
      "trees fitted %d of %d: plain circle DBH bias %+.2f cm, RMSE %.2f cm, wall %.2f cm (robust SD), position %.1f "
      "cm\n",
      fitted, asked, sum / fitted, std::sqrt(squared / fitted), wall / fitted, 100 * std::sqrt(dx2 / fitted));
}

// What all returns, not thinned, say along their rays with the true and with the estimated path.
void print_rays(const FrameSource& source, const Table& trees, const Trajectory& truth, const Trajectory& estimate,
                const Pose& T_world_map) {
  const auto stems = true_stems(trees);
  const auto within = [](const Trajectory& path, double t) {
    return t >= path.poses.front().time_s && t <= path.poses.back().time_s;
  };
  const auto both = [&](double t) { return within(truth, t) && within(estimate, t); };
  const auto with_truth = stem_returns(
      source, source.size(), [&](double t) { return both(t) ? std::optional(truth.at(t)) : std::nullopt; }, stems);
  const auto with_estimate = stem_returns(
      source, source.size(),
      [&](double t) { return both(t) ? std::optional(T_world_map * estimate.at(t)) : std::nullopt; }, stems);
  for (const auto* returns : {&with_truth, &with_estimate}) {
    const auto w = wall_figures(*returns, stems.size());
    std::printf("%s path: residual along the ray %+.2f mm, %+.2f mm about own centres (%.1f mm off), wall %.1f mm\n",
                returns == &with_truth ? "true" : "estimated", w.along_mm, w.own_along_mm, w.own_sd_mm, w.wall_mm);
  }
}
#endif

// Radial residuals of map points about the trunks of the synthetic plot: 1.4826 MAD about the median, over heights of
// 0.5 to 3 m.
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
  for (std::size_t i = 0; i < thickness.size(); ++i) {
    t += thickness[i];
    b += bias[i];
  }
  std::printf("trunks %zu: wall %.2f cm (robust SD), median radial offset %+.2f cm\n", thickness.size(),
              100 * t / static_cast<double>(thickness.size()), 100 * b / static_cast<double>(bias.size()));
}

void print_loops(const Table& loops, const Trajectory& truth) {
  evaluation::EvaluationOptions options;
  for (const double radius : {3.0, 5.0}) {
    options.loop_radius_m = radius;
    const auto e = evaluation::evaluate_loops(loops, truth, options);
    const auto values = e.summary.numbers("value");
    std::printf("loops within %.0f m: %zu right, %zu wrong, recall %.0f %%\n", radius, e.right, e.wrong, values.back());
  }
}

}  // namespace

int main(int count, char** arguments) try {
  std::map<std::string, std::string> own{{"scan", ""},  {"frames", "200"}, {"noise", "0.02"},
                                         {"gait", "1"}, {"half", "16"},    {"radius", "8"},
                                         {"table", ""}, {"out", ""},       {"first", "0"}};
  OptionSet options(option_table(static_cast<const slam::SlamOptions*>(nullptr)));
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
  if (own["scan"].empty()) {
    auto sensor = synthetic::SpinningSensor::vlp32c(900);
    sensor.range_noise_m = std::stod(own["noise"]);
    const double gait = std::stod(own["gait"]), radius = std::stod(own["radius"]);
    auto scan = std::make_shared<synthetic::SyntheticScan>(
        world, sensor, [=](double t) { return synthetic::walk_on_circle(t, radius, 1.0, gait); },
        std::stoul(own["frames"]));
    truth = scan->true_trajectory(200);
    source = scan;
  } else {
#ifdef BOLE_HAS_IO
    source = std::make_shared<Stretch>(recording(own["scan"]), std::stoul(own["first"]), std::stoul(own["frames"]));
    truth.poses = slam::read_tum_poses(own["scan"] + "/trajectory.tum");
#else
    throw bad_input("this program was built without the readers", "module io");
#endif
  }

  const double before_s = user_seconds();
  const auto result = slam::run_slam(*source, options.as<slam::SlamOptions>(), {});
  const double user_s = user_seconds() - before_s;
  const auto e = compare(result.trajectory, truth);
  if (!own["out"].empty()) write_tum(own["out"], result.trajectory);
  std::printf("%s\n", result.report.message.c_str());
  for (const auto& w : result.report.warnings) std::printf("warning: %s\n", w.c_str());
  for (const auto& [name, value] : result.report.counts)
    std::printf("%s %lld  ", name.c_str(), static_cast<long long>(value));
  std::printf("\n");
  for (const auto& [name, m] : result.report.metrics)
    std::printf("%s %.4g %s  ", name.c_str(), m.value, std::string(unit_symbol(m.unit)).c_str());
  std::printf(
      "\nATE RMSE %.2f cm, worst %.2f cm, turn %.3f deg, RPE over 0.1 s %.2f cm, end drift %.2f cm over %.1f m, user "
      "%.1f ms/frame\n",
      100 * e.ate_m, 100 * e.worst_m, e.turn_deg, 100 * e.step_size, 100 * e.end_m, truth.length_m(),
      1000 * user_s / static_cast<double>(source->size()));
  print_loops(result.loops, truth);
#ifdef BOLE_HAS_IO
  if (!own["table"].empty()) io::write_table(own["table"], result.odometry);
#endif
  const Pose T_world_map = aligned(result.trajectory, truth);
  if (own["scan"].empty()) print_walls(result.points, world, T_world_map);
#ifdef BOLE_HAS_IO
  else {
    const auto trees = io::read_table(own["scan"] + "/trees.csv");
    print_trees(result.points, trees, T_world_map);
    print_rays(*source, trees, truth, result.trajectory, T_world_map);
  }
#endif
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "slam_accuracy: %s\n", error.what());
  return 1;
}
