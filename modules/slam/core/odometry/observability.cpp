#include "slam/core/odometry/observability.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace bole::slam {
namespace {

// Neighbouring points of a scan line share errors, and a cell is seldom filled evenly: at most this many points of a
// cell count as independent observations of its tilt.
constexpr double max_independent_points = 8;
// Spurious planes are few but heavily weighted, so groups of points vote by their median.
constexpr std::size_t max_groups = 15, group_points = 40;
constexpr int min_lines = 4;              // one scan line that bends around a corner looks like a plane across it
constexpr double min_scatter = 0.002;     // no surface is smoother
constexpr double max_scatter_sigmas = 5;  // a thicker surface is neither plane nor line

// Covariance of the unit vector that the surface gives: its normal, or its direction.
Eigen::Matrix3d tilt_covariance(const LocalSurface& s, bool line) {
  const double n = std::min<double>(s.points, max_independent_points);
  const auto& d = s.deviations;
  const auto variance = [&](int of, int against) {
    const double scatter = std::max(d[of], min_scatter), extent = std::max(d[against], scatter);
    return scatter * scatter / (n * extent * extent);
  };
  const auto outer = [&](int k) -> Eigen::Matrix3d { return s.axes.col(k) * s.axes.col(k).transpose(); };
  if (!line) return variance(0, 1) * outer(1) + variance(0, 2) * outer(2);
  // Only the part across the line counts. A tilt lets a share of the part along it pass for across.
  return (variance(0, 2) + variance(1, 2)) * outer(2);
}

// A point and the surface that it lies on.
struct Witness {
  LocalSurface surface;
  Eigen::Vector3d in_map, lever;
  bool line = false;
};

std::optional<Witness> witness(const FeaturePoint& p, bool line, const DistributionMap& map, const PoseGrid& poses,
                               const RegistrationSettings& settings, MetSurface& met) {
  const Eigen::Vector3d lever = poses.turned(p.position, p.s), x = lever + poses.translation(p.s);
  const auto& surface = met.find(map, map.half_cell(x), line, 0, min_lines);
  if (!surface || surface->deviations[line ? 1 : 0] > max_scatter_sigmas * settings.sigma) return std::nullopt;
  const auto e = pose_equations(as_target(*surface, line, settings.sigma), x, lever, settings.kernel_sigmas);
  if (!e.inlier) return std::nullopt;
  return Witness{*surface, x, lever, line};
}

// A plane tells of shifts along its normal, a line of those across it.
void judge_spread(const std::vector<Witness>& witnesses, Observability& out) {
  constexpr std::size_t enough = 30;
  Eigen::Matrix2d faced = Eigen::Matrix2d::Zero();
  for (const auto& w : witnesses) {
    const Eigen::Vector3d axis = w.surface.axes.col(w.line ? 2 : 0);
    const Eigen::Matrix3d along = axis * axis.transpose();
    const Eigen::Matrix3d told = w.line ? Eigen::Matrix3d(Eigen::Matrix3d::Identity() - along) : along;
    faced += told.topLeftCorner<2, 2>();
  }
  if (witnesses.size() < enough) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(faced);
  if (!(solver.eigenvalues()[1] > 0)) return;
  out.spread = std::max(0.0, solver.eigenvalues()[0]) / solver.eigenvalues()[1];
  out.unfaced_axis = solver.eigenvectors().col(0);
}

std::string vector_text(const Eigen::Vector3d& v) {
  std::string text;
  for (const double part : v) {
    std::array<char, 16> digits;  // printf would write the decimal point of the system's language
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), part, std::chars_format::fixed, 2).ptr;
    text += (text.empty() ? "(" : ", ") + std::string(digits.data(), end);
  }
  return text + ")";
}

struct Information {
  Matrix6d signal = Matrix6d::Zero(), noise = Matrix6d::Zero();
  std::size_t points = 0;

  void operator+=(const Information& o) {
    signal += o.signal;
    noise += o.noise;
    points += o.points;
  }
};

void add(const Witness& w, const RegistrationSettings& settings, Information& to) {
  const auto e =
      pose_equations(as_target(w.surface, w.line, settings.sigma), w.in_map, w.lever, settings.kernel_sigmas);
  Eigen::Matrix<double, 3, 6> J;
  J << -skew(w.lever), Eigen::Matrix3d::Identity();
  to.signal += e.H;
  to.noise += e.weight * J.transpose() * tilt_covariance(w.surface, w.line) * J;
  ++to.points;
}

Observability weakest_of(const Information& sums) {
  Observability out;
  if (sums.points < 12 || !(sums.noise.trace() > 0)) return out;
  const Matrix6d noise = sums.noise + 1e-9 * sums.noise.trace() * Matrix6d::Identity();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(sums.signal, noise);
  if (solver.info() != Eigen::Success) return out;
  out.weakest = std::max(0.0, solver.eigenvalues()[0]);
  out.motion = solver.eigenvectors().col(0).normalized();
  out.strengths = solver.eigenvalues();
  out.motions = solver.eigenvectors();
  out.noise = noise;
  return out;
}

}  // namespace

// Eigenvectors V of the pair have V^T noise V = I, so what a motion x has of them is V^T noise x.
std::optional<Matrix6d> Observability::determined(double least) const {
  if (!strengths) return Matrix6d::Zero();
  Matrix6d P = Matrix6d::Identity();
  bool all = true;
  for (int k = 0; k < 6; ++k) {
    if ((*strengths)[k] >= least) continue;
    all = false;
    P -= motions.col(k) * motions.col(k).transpose() * noise;
  }
  if (all) return std::nullopt;
  return P;
}

std::string Observability::motion_text() const {
  const Eigen::Vector3d turn = motion.head<3>(), shift = motion.tail<3>();
  const bool turns = turn.norm() * 5 > shift.norm();  // at a lever of 5 m
  return (turns ? "a turn about " : "a shift along ") + vector_text((turns ? turn : shift).normalized());
}

Observability observability(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& motion,
                            const RegistrationSettings& settings, const Run& run, std::vector<MetSurface> met) {
  const PoseGrid poses(motion);
  met.resize(features.size());
  const std::size_t edges = features.edges.size();
  std::vector<std::optional<Witness>> asked(features.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, asked.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i) {
                        const bool line = i < edges;
                        const FeaturePoint& p = line ? features.edges[i] : features.planes[i - edges];
                        asked[i] = witness(p, line, line ? maps.edges : maps.planes, poses, settings, met[i]);
                      }
                    });
  run.check_cancel();
  std::vector<Witness> witnesses;
  for (const auto& w : asked)
    if (w) witnesses.push_back(*w);
  const std::size_t used = witnesses.size();
  std::array<Information, max_groups> dealt;
  tbb::parallel_for(std::size_t{0}, max_groups, [&](std::size_t g) {
    for (std::size_t i = g; i < used; i += max_groups) add(witnesses[i], settings, dealt[g]);
  });
  const std::size_t groups = std::clamp(used / group_points, std::size_t{1}, max_groups);
  std::vector<Observability> found(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    Information sum;
    for (std::size_t d = g; d < max_groups; d += groups) sum += dealt[d];
    found[g] = weakest_of(sum);
  }
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(groups / 2);
  std::ranges::nth_element(found, middle, {}, &Observability::weakest);
  judge_spread(witnesses, *middle);
  return *middle;
}

}  // namespace bole::slam
