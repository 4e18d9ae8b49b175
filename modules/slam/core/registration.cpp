#include "slam/core/registration.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace bole {
namespace {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Vector12d = Eigen::Matrix<double, 12, 1>;

constexpr double least_planarity = 0.25, least_linearity = 0.5;
constexpr std::size_t chunk_points = 128;  // fixed, so that sums do not depend on the number of threads

struct Sums {
  Matrix12d H = Matrix12d::Zero();  // blocks: begin, end
  Vector12d g = Vector12d::Zero();
  Matrix6d H_data = Matrix6d::Zero();  // every point at full weight on one pose
  double squared_m2 = 0;
  std::size_t matched = 0, inliers = 0;

  void operator+=(const Sums& o) {
    H += o.H, g += o.g, H_data += o.H_data;
    squared_m2 += o.squared_m2, matched += o.matched, inliers += o.inliers;
  }
};

// Shares of the begin and end unknowns in the pose at s.
std::pair<double, double> shares(MotionModel model, double s) {
  switch (model) {
    case MotionModel::rigid:
      return {0, 1};
    case MotionModel::end:
      return {0, s};
    case MotionModel::elastic:
      break;
  }
  return {1 - s, s};
}

void add_point(const FeaturePoint& p, bool line, const DistributionMap& map, const PoseGrid& poses, MotionModel motion, const MatchModel& model, Sums& sums) {
  const Eigen::Vector3d lever = poses.turned(p.position, p.s);
  const Eigen::Vector3d x = lever + poses.translation(p.s);
  const auto match = match_point(map, x, line, model);
  if (!match) return;
  ++sums.matched;
  if (match->inlier) {
    ++sums.inliers;
    sums.squared_m2 += match->squared;
  }
  Matrix6d H = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  add_pose_equations(lever, x - match->target, match->weight, H, g);
  sums.H_data += H;
  const auto [b, e] = shares(motion, p.s);
  if (b != 0) {
    sums.H.topLeftCorner<6, 6>() += b * b * H;
    sums.H.topRightCorner<6, 6>() += b * e * H;
    sums.g.head<6>() += b * g;
  }
  sums.H.bottomRightCorner<6, 6>() += e * e * H;
  sums.g.tail<6>() += e * g;
}

Sums sum_over_points(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& motion, MotionModel motion_model, const MatchModel& model, const Run& run) {
  const PoseGrid poses(motion);
  const std::size_t n = features.size(), edges = features.edges.size();
  std::vector<Sums> chunks((n + chunk_points - 1) / chunk_points);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size(), 1), [&](const tbb::blocked_range<std::size_t>& range) {
    if (run.cancelled()) return;
    for (std::size_t c = range.begin(); c < range.end(); ++c)
      for (std::size_t i = c * chunk_points; i < std::min(n, (c + 1) * chunk_points); ++i) {
        const bool line = i < edges;
        add_point(line ? features.edges[i] : features.planes[i - edges], line, line ? maps.edges : maps.planes, poses, motion_model, model, chunks[c]);
      }
  });
  run.check_cancel();
  Sums total;
  for (const auto& c : chunks) total += c;
  return total;
}

Vector6d pose_difference(const Pose& from, const Pose& to) {
  Vector6d d;
  d << so3_log(Eigen::Quaterniond(to.linear() * from.linear().transpose())), to.translation() - from.translation();
  return d;
}

Pose moved(const Pose& T, const Vector6d& turn_shift) {
  Pose out = T;
  out.linear() = so3_exp(turn_shift.head<3>()).toRotationMatrix() * T.linear();
  out.translation() += turn_shift.tail<3>();
  return out;
}

Vector6d inverse_variances(double sigma_rad, double sigma_m) {
  Vector6d w;
  w << Eigen::Vector3d::Constant(1 / (sigma_rad * sigma_rad)), Eigen::Vector3d::Constant(1 / (sigma_m * sigma_m));
  return w;
}

// Begin against its prediction, and (end - begin) against the predicted motion. With MotionModel::end the begin stands.
void add_priors(const FrameMotion& motion, const FrameMotion& predicted, const RegistrationSettings& settings, Sums& sums) {
  if (settings.model == MotionModel::rigid) return;
  const Vector6d wb = inverse_variances(settings.begin_sigma_rad, settings.begin_sigma_m), wm = inverse_variances(settings.motion_sigma_rad, settings.motion_sigma_m);
  const Vector6d eb = pose_difference(predicted.T_map_begin, motion.T_map_begin), ee = pose_difference(predicted.T_map_end, motion.T_map_end);
  const Vector6d em = ee - eb;
  sums.H.topLeftCorner<6, 6>() += (wb + wm).asDiagonal();
  sums.H.bottomRightCorner<6, 6>() += wm.asDiagonal();
  sums.H.topRightCorner<6, 6>() -= wm.asDiagonal();
  sums.g.head<6>() += wb.cwiseProduct(eb) - wm.cwiseProduct(em);
  sums.g.tail<6>() += wm.cwiseProduct(em);
}

// The step that lessens the sum of squares; applies it to `motion` and returns it for begin and end.
Vector12d solve_and_move(const Sums& sums, MotionModel model, FrameMotion& motion) {
  Vector12d step = Vector12d::Zero();
  if (model == MotionModel::elastic) {
    Matrix12d H = sums.H;
    H.bottomLeftCorner<6, 6>() = H.topRightCorner<6, 6>().transpose();
    step = -H.ldlt().solve(sums.g);
    if (!step.allFinite()) return Vector12d::Constant(std::nan(""));
    motion.T_map_begin = moved(motion.T_map_begin, step.head<6>());
    motion.T_map_end = moved(motion.T_map_end, step.tail<6>());
    return step;
  }
  Matrix6d H = sums.H.bottomRightCorner<6, 6>();
  H.diagonal() += Vector6d::Constant(1e-9 * H.trace() + 1e-12);
  const Vector6d d = -H.ldlt().solve(sums.g.tail<6>());
  if (!d.allFinite()) return Vector12d::Constant(std::nan(""));
  step.tail<6>() = d;
  if (model == MotionModel::rigid) {
    // The begin is carried along about the end.
    const Pose T_end_begin = motion.T_map_end.inverse() * motion.T_map_begin;
    motion.T_map_end = moved(motion.T_map_end, d);
    motion.T_map_begin = motion.T_map_end * T_end_begin;
  } else {
    motion.T_map_end = moved(motion.T_map_end, d);
  }
  return step;
}

// Least over largest eigenvalue of the information on the shift with the turn eliminated: small where a direction is free.
double shift_conditioning(const Matrix6d& H) {
  const Eigen::Matrix3d turn = H.topLeftCorner<3, 3>() + 1e-9 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d shift = H.bottomRightCorner<3, 3>() - H.bottomLeftCorner<3, 3>() * turn.inverse() * H.topRightCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(shift);
  return solver.eigenvalues()[2] > 0 ? std::max(0.0, solver.eigenvalues()[0] / solver.eigenvalues()[2]) : 0;
}

}  // namespace

std::optional<Match> match_point(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line, const MatchModel& model) {
  std::optional<LocalSurface> surface;
  for (int level = model.first_level; level < DistributionMap::levels; ++level) {
    surface = map.surface(point_in_map, level);
    if (surface && (line ? surface->linearity() >= least_linearity : surface->planarity() >= least_planarity)) break;
    surface.reset();
  }
  if (!surface) return std::nullopt;

  // Errors across a plane or line; their variance is the thickness of the surface plus that of the range.
  const Eigen::Vector3d error = point_in_map - surface->mean;
  const auto& axes = surface->axes;
  const double thickness = line ? surface->deviations_m[1] : surface->deviations_m[0];
  const double variance = thickness * thickness + model.sigma_m * model.sigma_m;
  const Eigen::Matrix3d across = line ? Eigen::Matrix3d(Eigen::Matrix3d::Identity() - axes.col(2) * axes.col(2).transpose()) : Eigen::Matrix3d(axes.col(0) * axes.col(0).transpose());

  Match match;
  match.target = surface->mean;
  const double squared_m2 = error.dot(across * error);
  const double k2 = model.kernel * model.kernel;
  const double robust = k2 / (k2 + squared_m2 / variance);
  match.squared = squared_m2;
  match.inlier = squared_m2 < k2 * variance;
  match.weight = (robust * robust / variance) * across;
  return match;
}

void add_pose_equations(const Eigen::Vector3d& lever, const Eigen::Vector3d& error, const Eigen::Matrix3d& weight, Matrix6d& H, Vector6d& g) {
  Eigen::Matrix<double, 3, 6> J;
  J << -skew(lever), Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, 6, 3> Jw = J.transpose() * weight;
  H.noalias() += Jw * J;
  g.noalias() += Jw * error;
}

Registration register_frame(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& guess, const RegistrationSettings& settings, const Run& run) {
  Registration out;
  out.motion = guess;
  out.tried = features.size();
  MatchModel model{settings.sigma_m, settings.kernel_sigmas, 0};
  Sums sums;
  for (int round = 0; round < settings.rounds; ++round) {
    // Coarse levels and a wide kernel first: they reach farther and still know the surfaces.
    const int coarse = std::max(0, settings.coarse_rounds - round);
    model.first_level = std::min(coarse, 2);
    model.kernel = settings.kernel_sigmas * (1 + coarse);
    sums = sum_over_points(features, maps, out.motion, settings.model, model, run);
    out.rounds = round + 1;
    if (sums.matched < 12) break;
    add_priors(out.motion, guess, settings, sums);
    const Vector12d step = solve_and_move(sums, settings.model, out.motion);
    if (!step.allFinite()) break;
    const double turn = std::max(step.segment<3>(0).norm(), step.segment<3>(6).norm()), shift = std::max(step.segment<3>(3).norm(), step.segment<3>(9).norm());
    if (coarse == 0 && turn < settings.converged_rad && shift < settings.converged_m) {
      out.converged = true;
      break;
    }
  }
  out.matched = sums.matched;
  out.inliers = sums.inliers;
  out.overlap = out.tried ? static_cast<double>(sums.inliers) / static_cast<double>(out.tried) : 0;
  out.rms_m = sums.inliers ? std::sqrt(sums.squared_m2 / static_cast<double>(sums.inliers)) : 0;
  out.information = sums.H_data;
  out.conditioning = shift_conditioning(sums.H_data);
  return out;
}

}  // namespace bole
