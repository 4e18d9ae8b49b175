#include "slam/core/odometry/registration.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "slam/core/odometry/point_matches.h"

namespace bole::slam {
namespace {

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Vector18d = Eigen::Matrix<double, 18, 1>;
using Matrix18d = Eigen::Matrix<double, 18, 18>;

constexpr double min_planarity = 0.25, min_linearity = 0.5;
constexpr std::size_t batch_points = 32;
constexpr std::size_t chunk_points = 256;  // fixed, so that sums do not depend on the number of threads

struct Sums {
  Matrix18d H = Matrix18d::Zero();  // blocks: begin, end, bend; those above the diagonal
  Vector18d g = Vector18d::Zero();
  Matrix6d H_data = Matrix6d::Zero();  // every point at full weight on one pose
  double squared_error = 0, weighted = 0;
  std::size_t matched = 0, inliers = 0;

  void operator+=(const Sums& o) {
    H += o.H;
    g += o.g;
    H_data += o.H_data;
    squared_error += o.squared_error;
    weighted += o.weighted;
    matched += o.matched;
    inliers += o.inliers;
  }
};

// Shares of the begin, end and bend unknowns in the pose at s.
std::array<double, 3> shares(const RegistrationSettings& settings, double s) {
  switch (settings.model) {
    case MotionModel::rigid:
      return {0, 1, 0};
    case MotionModel::end:
      return {0, s, 0};
    case MotionModel::elastic:
      break;
  }
  return {1 - s, s, settings.bend ? bend_share(s) : 0};
}

// Adds the equations of a pose to those of the unknowns that it is made of.
void add_shares(const std::array<double, 3>& share, const PoseEquations& e, Sums& sums) {
  for (int i = 0; i < 3; ++i) {
    const double of_row = share[static_cast<std::size_t>(i)];
    if (of_row == 0) continue;
    for (int j = i; j < 3; ++j)
      if (const double of_column = share[static_cast<std::size_t>(j)]; of_column != 0)
        sums.H.block<6, 6>(6 * i, 6 * j) += of_row * of_column * e.H;
    sums.g.segment<6>(6 * i) += of_row * e.g;
  }
}

// SPEC A7: the variance of a condition is A Q A^T, made of the model (the thickness that the target came with), of the
// point and, for de-skewing, of the points that make the surface. A surface through many points moves by a share of the
// scatter of each, so their sum is their variance times the leverage.
void add_prior_variance(const AdjustmentPriors& priors, const PoseGrid& poses, const FeaturePoint& p,
                        const Eigen::Vector3d& lever, const Eigen::Vector3d& x, Target& target) {
  Eigen::Vector3d axis = target.axis;
  if (target.kind == Target::Kind::line) {
    const Eigen::Vector3d error = x - target.mean, across = error - target.axis.dot(error) * target.axis;
    axis = across.norm() > 1e-6 ? Eigen::Vector3d(across.normalized()) : target.axis.unitOrthogonal();
  }
  const Eigen::Vector3d axis_in_sensor = poses.rotation(p.s).transpose() * axis;
  const double of_point =
      axis_in_sensor.dot(point_covariance(p.position.cast<double>(), priors.sensor) * axis_in_sensor);
  const double share = 1 - static_cast<double>(p.s);  // points are brought to the end of the frame
  target.variance += of_point + share * share * pose_variance(axis, lever, priors.motion_covariance);
  if (priors.reference_points)
    target.variance +=
        target.leverage * of_point + pose_variance(axis, x - priors.reference_position, priors.reference_covariance);
}

// Planes keep the turn about x and y and the shift along z, lines the others.
void keep_own_unknowns(bool line, PoseEquations& e) {
  Vector6d own;
  own << 1, 1, 0, 0, 0, 1;
  if (line) own = Vector6d::Ones() - own;
  e.H = (own.asDiagonal() * e.H * own.asDiagonal()).eval();
  e.g = e.g.cwiseProduct(own);
}

// Matching costs more than summing, so targets are kept for one iteration.
class FrameEquations {
 public:
  FrameEquations(const FeatureSet& features, const FeatureMaps& maps, const RegistrationSettings& settings)
      : features_(features),
        maps_(maps),
        settings_(settings),
        targets_(features.size()),
        met_(settings.points ? 0 : features.size()) {}

  // At `motion`. Matches again from `first_level` up, or keeps the targets when that is negative.
  Sums sums(const FrameMotion& motion, int first_level, double kernel, const Run& run) {
    const PoseGrid poses(motion);
    const std::size_t n = targets_.size();
    std::vector<Sums> chunks((n + chunk_points - 1) / chunk_points);
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
      const std::size_t end = std::min(n, (c + 1) * chunk_points);
      for (std::size_t i = c * chunk_points; i < end && !run.cancelled(); i += batch_points) {
        const std::size_t end_of_batch = std::min(end, i + batch_points);
        if (first_level >= 0 && !settings_.points) call_for_surfaces(i, end_of_batch, poses, first_level);
        for (std::size_t k = i; k < end_of_batch; ++k) add_point(k, poses, first_level, kernel, chunks[c]);
      }
    });
    run.check_cancel();
    Sums total;
    for (const auto& c : chunks) total += c;
    return total;
  }

  std::vector<MetSurface> take_met() { return std::move(met_); }

 private:
  bool is_line(std::size_t i) const { return i < features_.edges.size(); }
  const FeaturePoint& point(std::size_t i) const {
    return is_line(i) ? features_.edges[i] : features_.planes[i - features_.edges.size()];
  }

  // Points [begin, end) are about to be matched.
  void call_for_surfaces(std::size_t begin, std::size_t end, const PoseGrid& poses, int first_level) const {
    std::array<HalfCell, batch_points> places;
    for (std::size_t i = begin; i < end;) {
      const bool line = is_line(i);
      const auto& map = line ? maps_.edges : maps_.planes;
      std::size_t searched = 0;
      for (; i < end && is_line(i) == line; ++i) {
        const HalfCell place = map.half_cell(poses.in_map(point(i).position, point(i).s));
        if (!met_[i].knows(place, first_level)) places[searched++] = place;
      }
      map.call_for({places.data(), searched}, first_level);
    }
  }

  void add_point(std::size_t i, const PoseGrid& poses, int first_level, double kernel, Sums& sums) {
    const bool line = is_line(i);
    const FeaturePoint& p = point(i);
    const Eigen::Vector3d lever = poses.turned(p.position, p.s);
    const Eigen::Vector3d x = lever + poses.translation(p.s);
    const Target& target = targets_[i];
    if (first_level >= 0) match(i, line, p, poses, lever, x, first_level);
    if (target.kind == Target::Kind::none) return;

    const double variance = settings_.equal ? settings_.sigma * settings_.sigma : target.variance;
    auto e = settings_.plain ? condition_equations(target, x, lever, kernel, 1 / variance)
                             : pose_equations(target, x, lever, kernel);
    ++sums.matched;
    if (e.inlier) {
      ++sums.inliers;
      sums.squared_error += e.squared_error;
      sums.weighted += e.squared_error / variance;
    }
    if (settings_.two_step) keep_own_unknowns(line, e);
    sums.H_data += e.H;
    add_shares(shares(settings_, p.s), e, sums);
  }

  void match(std::size_t i, bool line, const FeaturePoint& p, const PoseGrid& poses, const Eigen::Vector3d& lever,
             const Eigen::Vector3d& x, int first_level) {
    const auto& priors = settings_.priors;
    Target& target = targets_[i];
    if (!settings_.points) {
      const auto& map = line ? maps_.edges : maps_.planes;
      const auto& surface = met_[i].find(map, map.half_cell(x), line, first_level);
      target = surface ? as_target(*surface, line, priors ? 0 : settings_.sigma) : Target{};
      if (priors && target.kind != Target::Kind::none) add_prior_variance(*priors, poses, p, lever, x, target);
      return;
    }
    Eigen::Matrix3d of_point = Eigen::Matrix3d::Zero();
    if (priors) {
      const Eigen::Matrix3d& R = poses.rotation(p.s);
      of_point = R * point_covariance(p.position.cast<double>(), priors->sensor) * R.transpose();
    }
    target = settings_.points->target(x, line, priors ? &of_point : nullptr, settings_.sigma * settings_.sigma);
  }

  const FeatureSet& features_;
  const FeatureMaps& maps_;
  const RegistrationSettings& settings_;
  std::vector<Target> targets_;
  std::vector<MetSurface> met_;
};

Matrix12d of_begin_and_end(const Matrix18d& H) {
  Matrix12d out = H.topLeftCorner<12, 12>();
  out.bottomLeftCorner<6, 6>() = out.topRightCorner<6, 6>().transpose();
  return out;
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

Vector6d inverse_variances(double sigma_rad, double sigma) {
  Vector6d w;
  w << Eigen::Vector3d::Constant(1 / (sigma_rad * sigma_rad)), Eigen::Vector3d::Constant(1 / (sigma * sigma));
  return w;
}

Matrix6d begin_information(const RegistrationSettings& settings) {
  const Vector6d w = inverse_variances(settings.begin_sigma_rad, settings.begin_sigma);
  if (settings.begin_covariance.isZero()) return w.asDiagonal();
  const Matrix6d covariance = settings.begin_covariance + Matrix6d(w.cwiseInverse().asDiagonal());
  return covariance.inverse();
}

// Of elastic frames: begin against its prediction, (end - begin) against the predicted motion, and the bend against
// none.
void add_priors(const FrameMotion& motion, const Vector6d& bend, const FrameMotion& predicted,
                const RegistrationSettings& settings, Sums& sums) {
  if (settings.model != MotionModel::elastic) return;
  if (settings.bend) {
    const Vector6d w = inverse_variances(settings.bend->sigma_rad, settings.bend->sigma);
    sums.H.bottomRightCorner<6, 6>() += w.asDiagonal();
    sums.g.tail<6>() += w.cwiseProduct(bend);
  }
  if (settings.joint_information) {
    Vector12d error;
    error << pose_difference(predicted.T_map_begin, motion.T_map_begin),
        pose_difference(predicted.T_map_end, motion.T_map_end);
    sums.H.topLeftCorner<12, 12>() += *settings.joint_information;
    sums.g.head<12>() += *settings.joint_information * error;
    return;
  }
  const Vector6d wm = inverse_variances(settings.motion_sigma_rad, settings.motion_sigma);
  const Matrix6d wb = begin_information(settings);
  const Vector6d eb = pose_difference(predicted.T_map_begin, motion.T_map_begin),
                 ee = pose_difference(predicted.T_map_end, motion.T_map_end);
  const Vector6d em = ee - eb;
  sums.H.topLeftCorner<6, 6>() += wb + Matrix6d(wm.asDiagonal());
  sums.H.block<6, 6>(6, 6) += wm.asDiagonal();
  sums.H.block<6, 6>(0, 6) -= wm.asDiagonal();
  sums.g.head<6>() += wb * eb - wm.cwiseProduct(em);
  sums.g.segment<6>(6) += wm.cwiseProduct(em);
}

// Takes out what the points seem to tell about motions that they do not determine.
void keep_determined(const Matrix6d& P, Sums& sums) {
  for (const int row : {0, 6}) {
    for (const int column : {0, 6})
      sums.H.block<6, 6>(row, column) = (P.transpose() * sums.H.block<6, 6>(row, column) * P).eval();
    sums.g.segment<6>(row) = (P.transpose() * sums.g.segment<6>(row)).eval();
  }
  sums.H_data = (P.transpose() * sums.H_data * P).eval();
}

// The least squares step of an elastic frame; without a bend the last six are 0.
Vector18d elastic_step(const Sums& sums, bool with_bend) {
  Vector18d step = Vector18d::Zero();
  if (with_bend)
    step = -Matrix18d(sums.H.selfadjointView<Eigen::Upper>()).ldlt().solve(sums.g);
  else
    step.head<12>() = -of_begin_and_end(sums.H).ldlt().solve(sums.g.head<12>());
  return step;
}

// The step that reduces the sum of squares. Applies it to `motion` and `bend`, and returns it.
Vector18d solve_and_move(const Sums& sums, const RegistrationSettings& settings, FrameMotion& motion, Vector6d& bend) {
  Vector18d step = Vector18d::Zero();
  if (settings.model == MotionModel::elastic) {
    step = elastic_step(sums, settings.bend.has_value());
    if (!step.allFinite()) return Vector18d::Constant(std::nan(""));
    motion.T_map_begin = moved(motion.T_map_begin, step.head<6>());
    motion.T_map_end = moved(motion.T_map_end, step.segment<6>(6));
    bend += step.tail<6>();
    if (settings.bend) motion = bent_motion(motion.T_map_begin, motion.T_map_end, bend);
    return step;
  }
  Matrix6d H = sums.H.block<6, 6>(6, 6);
  H.diagonal() += Vector6d::Constant(1e-9 * H.trace() + 1e-12);
  const Vector6d d = -H.ldlt().solve(sums.g.segment<6>(6));
  if (!d.allFinite()) return Vector18d::Constant(std::nan(""));
  step.segment<6>(6) = d;
  if (settings.model == MotionModel::rigid) {
    // The begin moves rigidly with the end.
    const Pose T_end_begin = motion.T_map_end.inverse() * motion.T_map_begin;
    motion.T_map_end = moved(motion.T_map_end, d);
    motion.T_map_begin = motion.T_map_end * T_end_begin;
  } else {
    motion.T_map_end = moved(motion.T_map_end, d);
  }
  return step;
}

// Of the end of a frame, with begin and bend unknown too.
Matrix6d end_covariance(const Sums& sums) {
  const Matrix18d H = sums.H.selfadjointView<Eigen::Upper>();
  return H.inverse().block<6, 6>(6, 6);
}

// The largest turn and the largest shift of a step.
std::pair<double, double> size_of(const Vector18d& step) {
  double turn = 0, shift = 0;
  for (int i = 0; i < 18; i += 6) {
    turn = std::max(turn, step.segment<3>(i).norm());
    shift = std::max(shift, step.segment<3>(i + 3).norm());
  }
  return {turn, shift};
}

// Smallest over largest eigenvalue of the information on the shift with the turn eliminated: small where a direction is
// open.
double shift_conditioning(const Matrix6d& H) {
  const Eigen::Matrix3d turn = H.topLeftCorner<3, 3>() + 1e-9 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d shift =
      H.bottomRightCorner<3, 3>() - H.bottomLeftCorner<3, 3>() * turn.inverse() * H.topRightCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(shift);
  return solver.eigenvalues()[2] > 0 ? std::max(0.0, solver.eigenvalues()[0] / solver.eigenvalues()[2]) : 0;
}

}  // namespace

bool is_distinct(const LocalSurface& surface, bool line) {
  return line ? surface.linearity() >= min_linearity : surface.planarity() >= min_planarity;
}

std::optional<LocalSurface> find_surface(const DistributionMap& map, const HalfCell& place, bool line, int first_level,
                                         int min_lines, int end_level) {
  for (int level = first_level; level < end_level; ++level) {
    auto surface = map.surface(place, level);
    if (surface && surface->lines >= min_lines && is_distinct(*surface, line)) return surface;
  }
  return std::nullopt;
}

// Levels that were searched and had none still have none, also where more lines are asked for.
const std::optional<LocalSurface>& MetSurface::find(const DistributionMap& map, const HalfCell& place, bool line,
                                                    int first_level, int min_lines) {
  if (place != place_ || first_level > first_level_ || min_lines < min_lines_) {
    surface_ = find_surface(map, place, line, first_level, min_lines);
  } else {
    const auto finer = find_surface(map, place, line, first_level, min_lines, first_level_);
    if (finer)
      surface_ = finer;
    else if (surface_ && surface_->lines < min_lines)
      surface_ = find_surface(map, place, line, surface_->level + 1, min_lines);
  }
  place_ = place;
  first_level_ = first_level;
  min_lines_ = min_lines;
  return surface_;
}

Target as_target(const LocalSurface& surface, bool line, double sigma) {
  // Points are spread roughly evenly around the place: one share for the mean and one for each tilt.
  const double leverage = (line ? 2.0 : 3.0) / std::max(surface.points, 3);
  const double thickness = surface.deviations[line ? 1 : 0];
  Target target;
  target.mean = surface.mean;
  target.axis = surface.axes.col(line ? 2 : 0);
  target.variance = std::max(thickness * thickness, 1e-6) + sigma * sigma;
  target.leverage = leverage;
  target.kind = line ? Target::Kind::line : Target::Kind::plane;
  return target;
}

Target find_target(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line, int first_level,
                   double sigma) {
  const auto surface = find_surface(map, map.half_cell(point_in_map), line, first_level);
  return surface ? as_target(*surface, line, sigma) : Target{};
}

namespace {

// The squared distance from the target, and whether it is within `kernel` standard deviations.
PoseEquations measured(const Target& target, const Eigen::Vector3d& error, double kernel) {
  PoseEquations out;
  const double along = target.axis.dot(error);
  const bool line = target.kind == Target::Kind::line;
  out.squared_error = line ? std::max(0.0, error.squaredNorm() - along * along) : along * along;
  out.inlier = out.squared_error < kernel * kernel * target.variance;
  return out;
}

// Newton's equations of the squared distance with out.weight. Those of a line have the curvature across the distance as
// well. With the derivative of the distance alone, steps towards lines would be up to twice as long as they should be,
// and the iteration would go to and fro for ever.
void set_equations(const Target& target, const Eigen::Vector3d& error, const Eigen::Vector3d& lever,
                   PoseEquations& out) {
  if (target.kind != Target::Kind::line) {
    Vector6d a;
    a << lever.cross(target.axis), target.axis;
    out.H.noalias() = out.weight * a * a.transpose();
    out.g = out.weight * target.axis.dot(error) * a;
    return;
  }
  Eigen::Matrix<double, 3, 6> J;
  J << -skew(lever), Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - target.axis * target.axis.transpose();
  const Eigen::Matrix<double, 6, 3> Jw = out.weight * J.transpose() * across;
  out.H.noalias() = Jw * J;
  out.g.noalias() = Jw * error;
}

}  // namespace

PoseEquations pose_equations(const Target& target, const Eigen::Vector3d& point_in_map, const Eigen::Vector3d& lever,
                             double kernel) {
  const Eigen::Vector3d error = point_in_map - target.mean;
  auto out = measured(target, error, kernel);
  const double k2 = kernel * kernel, robust = k2 / (k2 + out.squared_error / target.variance);
  out.weight = robust * robust / target.variance;
  set_equations(target, error, lever, out);
  return out;
}

PoseEquations condition_equations(const Target& target, const Eigen::Vector3d& point_in_map,
                                  const Eigen::Vector3d& lever, double kernel, double weight) {
  const Eigen::Vector3d error = point_in_map - target.mean;
  auto out = measured(target, error, kernel);
  if (!out.inlier) return out;
  out.weight = weight;
  set_equations(target, error, lever, out);
  return out;
}

Registration register_frame(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& guess,
                            const RegistrationSettings& settings, const Run& run) {
  Registration out;
  out.motion = guess;
  out.tried = features.size();
  FrameEquations equations(features, maps, settings);
  Sums sums;
  Vector6d bend = Vector6d::Zero();  // of the middle, map axes
  for (int i = 0; i < settings.iterations; ++i) {
    // Coarse levels and a wide kernel come first: they reach farther.
    const int coarse = std::max(0, settings.coarse_iterations - i);
    const bool match = coarse > 0 || (i - settings.coarse_iterations) % 2 == 0 || i == 0;
    sums = equations.sums(out.motion, match ? std::min(coarse, 3) : -1,
                          settings.kernel_sigmas * (1 + std::min(coarse, 4)), run);
    out.iterations = i + 1;
    if (sums.matched < 12) break;
    if (settings.determined) keep_determined(*settings.determined, sums);
    out.begin_end_information = of_begin_and_end(sums.H);
    add_priors(out.motion, bend, guess, settings, sums);
    if (settings.bend) out.end_covariance = end_covariance(sums);
    const Vector18d step = solve_and_move(sums, settings, out.motion, bend);
    if (!step.allFinite()) break;
    const auto [turn, shift] = size_of(step);
    if (coarse == 0 && turn < settings.converged_turn_rad && shift < settings.converged_shift) {
      out.converged = true;
      break;
    }
  }
  out.met = equations.take_met();
  out.matched = sums.matched;
  out.inliers = sums.inliers;
  out.overlap = out.tried ? static_cast<double>(sums.inliers) / static_cast<double>(out.tried) : 0;
  out.rms = sums.inliers ? std::sqrt(sums.squared_error / static_cast<double>(sums.inliers)) : 0;
  out.information = sums.H_data;
  out.conditioning = shift_conditioning(sums.H_data);
  if (sums.inliers > 6) {
    out.sigma0 = std::sqrt(sums.weighted / static_cast<double>(sums.inliers - 6));
    // With the begin fixed a point tells the less about the end, the earlier it was measured.
    const Matrix6d N = settings.model == MotionModel::end
                           ? Matrix6d(out.begin_end_information.bottomRightCorner<6, 6>())
                           : sums.H_data;
    const Matrix6d H = N + 1e-9 * N.trace() * Matrix6d::Identity();
    out.covariance = out.sigma0 * out.sigma0 * H.inverse();
  }
  return out;
}

}  // namespace bole::slam
