#include "slam/core/map/refine.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "slam/core/map/banded_system.h"
#include "slam/core/map/cell_targets.h"

namespace bole::slam {
namespace {

// Sums over the points of one frame: for each piece of the path that it touches, equations on the four nodes of that
// piece.
struct PieceSums {
  std::ptrdiff_t first = 0;
  std::array<std::array<Matrix6d, 4>, 4> H;  // upper: [a][b], b >= a
  std::array<Vector6d, 4> g;
  explicit PieceSums(std::ptrdiff_t first_node) : first(first_node) {
    for (auto& row : H) row.fill(Matrix6d::Zero());
    g.fill(Vector6d::Zero());
  }
};
struct FrameSums {
  std::vector<PieceSums> pieces;
  double squared_error = 0;
  std::size_t inliers = 0;
};

PoseGrid grid_over(const Path& path, const FrameSample& frame) {
  return PoseGrid([&](double s) { return path.at(frame.begin_s + s * (frame.end_s - frame.begin_s)); });
}

// The map of all frames, and where each of their points lies in it.
struct FramesMap {
  explicit FramesMap(double cell_size) : maps(cell_size) {}

  struct Part {
    DistributionMap::CellNumbers cells;  // of all points
    std::vector<std::size_t> first;      // of each frame among them
  };
  FeatureMaps maps;
  Part edges, planes;

  void build(const Path& path, const std::vector<FrameSample>& frames, const Run& run) {
    maps.clear();
    add(path, frames, &FeatureSet::edges, maps.edges, edges, run);
    add(path, frames, &FeatureSet::planes, maps.planes, planes, run);
  }

 private:
  static void add(const Path& path, const std::vector<FrameSample>& frames, std::vector<FeaturePoint> FeatureSet::*kind,
                  DistributionMap& map, Part& part, const Run& run) {
    for (auto& numbers : part.cells) numbers.clear();
    part.first.clear();
    std::size_t count = 0;
    std::vector<Eigen::Vector3d> points;
    constexpr std::size_t batch = 1 << 16;
    const auto hand_over = [&] {
      map.insert(points, {}, &part.cells);
      points.clear();
    };
    for (const auto& frame : frames) {
      run.check_cancel();
      part.first.push_back(count);
      const auto& of_frame = frame.features.*kind;
      count += of_frame.size();
      if (of_frame.empty()) continue;
      const auto poses = grid_over(path, frame);
      for (const auto& p : of_frame) points.push_back(poses.in_map(p.position, p.s));
      if (points.size() >= batch) hand_over();
    }
    hand_over();
  }
};

void add_to_frame(const Path& path, const FrameSample& frame, const PoseGrid& poses, const FeaturePoint& p,
                  std::size_t index, const DistributionMap::CellNumbers& cells, const CellTargets& targets,
                  const RefineSettings& settings, FrameSums& sums) {
  const Eigen::Vector3d lever = poses.turned(p.position, p.s);
  const Eigen::Vector3d x = lever + poses.translation(p.s);
  const auto target = targets.of(index, x, cells);
  if (target.kind == Target::Kind::none) return;
  const auto e = pose_equations(target, x, lever, settings.kernel_sigmas);
  if (e.inlier) {
    ++sums.inliers;
    sums.squared_error += e.squared_error;
  }

  const auto influence = path.influence(frame.begin_s + static_cast<double>(p.s) * (frame.end_s - frame.begin_s));
  auto piece = std::ranges::find(sums.pieces, influence.first, &PieceSums::first);
  if (piece == sums.pieces.end()) piece = sums.pieces.insert(sums.pieces.end(), PieceSums(influence.first));
  for (std::size_t a = 0; a < 4; ++a) {
    piece->g[a] += influence.weight[a] * e.g;
    for (std::size_t b = a; b < 4; ++b) piece->H[a][b] += influence.weight[a] * influence.weight[b] * e.H;
  }
}

void add_to_system(const FrameSums& sums, BandedSystem& system) {
  const auto n = static_cast<std::ptrdiff_t>(system.nodes());
  for (const auto& piece : sums.pieces)
    for (std::ptrdiff_t a = 0; a < 4; ++a) {
      const auto i = piece.first + a;
      if (i < 0 || i >= n) continue;
      system.gradient(static_cast<std::size_t>(i)) += piece.g[static_cast<std::size_t>(a)];
      for (std::ptrdiff_t b = a; b < 4 && piece.first + b < n; ++b)
        system.block(static_cast<std::size_t>(i), static_cast<std::size_t>(b - a)) +=
            piece.H[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }
}

// The path is smooth: velocities of neighbouring pieces differ by what a walking person can do. This holds nodes where
// there is no frame.
void add_smoothness(const Path& path, const RefineSettings& settings, BandedSystem& system) {
  const auto& nodes = path.nodes();
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const double before = nodes[i].time_s - nodes[i - 1].time_s, after = nodes[i + 1].time_s - nodes[i].time_s,
                 mean = 0.5 * (before + after);
    const Pose &A = nodes[i - 1].T_target_sensor, &B = nodes[i].T_target_sensor, &C = nodes[i + 1].T_target_sensor;
    Vector6d error;
    error << so3_log(Eigen::Quaterniond(C.linear() * B.linear().transpose())) / after -
                 so3_log(Eigen::Quaterniond(B.linear() * A.linear().transpose())) / before,
        (C.translation() - B.translation()) / after - (B.translation() - A.translation()) / before;
    Vector6d w;
    w << Eigen::Vector3d::Constant(std::pow(settings.angular_acceleration_sigma * mean, -2)),
        Eigen::Vector3d::Constant(std::pow(settings.acceleration_sigma * mean, -2));
    const std::array<double, 3> share{1 / before, -1 / before - 1 / after, 1 / after};
    for (std::size_t a = 0; a < 3; ++a) {
      system.gradient(i - 1 + a) += share[a] * w.cwiseProduct(error);
      for (std::size_t b = a; b < 3; ++b) system.block(i - 1 + a, b - a) += (share[a] * share[b] * w).asDiagonal();
    }
  }
}

Path with_nodes_every(const Path& path, double spacing_s) {
  std::vector<StampedPose> nodes;
  for (std::size_t i = 0; i + 1 < path.nodes().size(); ++i) {
    const double a = path.nodes()[i].time_s, b = path.nodes()[i + 1].time_s;
    const auto pieces = std::max(1L, std::lround((b - a) / spacing_s));
    for (long k = 0; k < pieces; ++k) {
      const double t = a + (b - a) * static_cast<double>(k) / static_cast<double>(pieces);
      nodes.push_back({t, path.at(t)});
    }
  }
  nodes.push_back(path.nodes().back());
  return Path(std::move(nodes));
}

// Why the steps of an iteration are not credible; empty when they are. Odometry and loops are right to decimetres, or
// they were refused.
std::string objection(const std::vector<Vector6d>& steps) {
  constexpr double max_step = 1;
  if (steps.empty()) return "it has no solution";
  double largest = 0;
  for (const auto& step : steps) largest = std::max(largest, step.tail<3>().norm());
  if (largest <= max_step) return {};
  return "it would move the path by " + number_text(std::round(largest * 10) / 10) + " m";
}

// Returns the root mean square displacement.
double move_nodes(Path& path, const std::vector<Vector6d>& steps) {
  double squared = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Pose T = path.nodes()[i].T_target_sensor;
    T.linear() = so3_exp(steps[i].head<3>()).toRotationMatrix() * T.linear();
    T.translation() += steps[i].tail<3>();
    path.set_pose(i, T);
    squared += steps[i].tail<3>().squaredNorm();
  }
  path.update_velocities();
  return std::sqrt(squared / static_cast<double>(steps.size()));
}

}  // namespace

RefineResult refine_path(const Path& initial, const std::vector<FrameSample>& frames, const RefineSettings& settings,
                         const Run& run, InertialTerms* inertial) {
  RefineResult out{with_nodes_every(initial, settings.node_spacing_s), {}, {}, {}};
  FramesMap map(settings.cell_size);
  constexpr std::size_t batch = 64;  // frames between checks of the cancel flag
  for (int iteration = 0; iteration < settings.iterations && !run.asked_to_finish(); ++iteration) {
    const Run part = run.part(static_cast<double>(iteration) / settings.iterations,
                              static_cast<double>(iteration + 1) / settings.iterations);
    map.build(out.path, frames, part);
    const CellTargets edges(map.maps.edges, true, settings.sigma, part),
        planes(map.maps.planes, false, settings.sigma, part);
    const auto sums_of = [&](std::size_t k) {
      FrameSums sums;
      const auto poses = grid_over(out.path, frames[k]);
      const auto add = [&](const std::vector<FeaturePoint>& points, const FramesMap::Part& where,
                           const CellTargets& targets) {
        for (std::size_t i = 0; i < points.size(); ++i)
          add_to_frame(out.path, frames[k], poses, points[i], where.first[k] + i, where.cells, targets, settings, sums);
      };
      add(frames[k].features.edges, map.edges, edges);
      add(frames[k].features.planes, map.planes, planes);
      return sums;
    };
    BandedSystem system(out.path.nodes().size(), inertial ? inertial->unknowns() : 0);
    double squared_error = 0;
    std::size_t inliers = 0;
    for (std::size_t begin = 0; begin < frames.size(); begin += batch) {
      const std::size_t end = std::min(begin + batch, frames.size());
      std::vector<FrameSums> sums(end - begin);
      tbb::parallel_for(begin, end, [&](std::size_t k) {
        if (!run.cancelled()) sums[k - begin] = sums_of(k);
      });
      part.check_cancel();
      part.report(static_cast<double>(end) / static_cast<double>(frames.size()), "adjusting the path");
      for (const auto& s : sums) {
        add_to_system(s, system);
        squared_error += s.squared_error;
        inliers += s.inliers;
      }
    }
    add_smoothness(out.path, settings, system);
    if (inertial) inertial->add(out.path, system);
    // The first pose fixes the map.
    system.block(0, 0).diagonal().array() += 1e10;

    const Eigen::Index judged = inertial ? static_cast<Eigen::Index>(inertial->judged()) : 0;
    Eigen::VectorXd border;
    Eigen::MatrixXd covariance(judged, judged);
    const auto steps = system.solve(border, &covariance);
    if (out.stopped = objection(steps); !out.stopped.empty()) break;
    if (inertial) inertial->move(border, covariance);
    out.step_size.push_back(move_nodes(out.path, steps));
    out.rms.push_back(inliers ? std::sqrt(squared_error / static_cast<double>(inliers)) : 0);
  }
  return out;
}

}  // namespace bole::slam
