#include "survey/core/georeference/track_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "base/statistics.h"
#include "survey/core/georeference/plan_fit.h"
#include "survey/core/georeference/track_noise.h"

namespace bole::survey {
namespace {

using Vector = TrackVector;
using Matrix = TrackMatrix;
using Row = TrackRow;
enum : Eigen::Index { turn = 0, shift = 1, clock_offset = 4, lever = 5 };

class TrackAdjustment {
 public:
  TrackAdjustment(const Trajectory& walk, const std::vector<TrackFix>& track, double offset, const TrackPrior& prior)
      : walk_(walk), track_(track), prior_(prior) {
    x_.setZero();
    x_(clock_offset) = offset;
    x_.segment<3>(lever) = prior.lever_sensor;
  }

  TrackFit solve() {
    begin();
    constexpr int iterations = 40;
    for (int k = 0; k < iterations; ++k) {
      const auto rows = linearised();
      weigh(rows);
      const Vector step = normal_matrix(rows).ldlt().solve(right_side(rows));
      x_ += step;
      x_(turn) = wrapped(x_(turn));
      if (step.cwiseAbs().maxCoeff() < 1e-7) break;
    }
    return result(weigh_lasting_errors());
  }

 private:
  // A pose within the walk; the ends are held.
  Pose pose_at(double time_s) const {
    return walk_.at(std::clamp(time_s, walk_.poses.front().time_s, walk_.poses.back().time_s), 0);
  }
  bool walked_at(double time_s) const {
    return time_s >= walk_.poses.front().time_s && time_s <= walk_.poses.back().time_s;
  }
  Eigen::Vector3d antenna_at(double time_s) const { return pose_at(time_s) * Eigen::Vector3d(x_.segment<3>(lever)); }

  // Start of turn and shift, for the offset found by shape.
  void begin() {
    std::vector<PlanPair> pairs;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double heights = 0;
    int with_height = 0;
    for (const auto& fix : track_) {
      const double t = fix.time_s + x_(clock_offset);
      if (!walked_at(t)) continue;
      const Eigen::Vector3d p = antenna_at(t);
      pairs.push_back({p.head<2>(), fix.global.head<2>(), fix.sd_m});
      sum += p;
      if (std::isfinite(fix.global.z())) {
        heights += fix.global.z() - p.z();
        ++with_height;
      }
    }
    constexpr std::size_t min_fixes_to_fit = 20;
    if (pairs.size() < min_fixes_to_fit)
      throw bad_input(fmt::format("{} fixes of the track lie within the time of the walk", pairs.size()),
                      fmt::format("at least {}", min_fixes_to_fit), "Check the clocks, or set clock_offset");
    centre_ = sum / static_cast<double>(pairs.size());
    const auto fit = fit_plan(pairs);
    x_(turn) = fit.turn_rad;
    base_global_.head<2>() = fit.to_global(centre_.head<2>());
    base_global_.z() = with_height > 0 ? heights / with_height + centre_.z() : 0;
    x_.segment<3>(shift).setZero();
    any_height_ = with_height > 0;
  }

  std::vector<Row> linearised() const {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(x_(turn), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    std::vector<Row> rows;
    for (const auto& fix : track_) {
      const double t = fix.time_s + x_(clock_offset);
      if (!walked_at(t)) continue;
      const Eigen::Vector3d local = antenna_at(t) - centre_;
      const Eigen::Vector3d turned = R * local;
      Row row;
      row.time_s = t;
      row.has_height = std::isfinite(fix.global.z());
      row.sd_m = fix.sd_m;
      row.residual = fix.global - base_global_ - x_.segment<3>(shift) - turned;
      row.jacobian.col(turn) = Eigen::Vector3d(-turned.y(), turned.x(), 0);
      row.jacobian.middleCols<3>(shift) = Eigen::Matrix3d::Identity();
      row.jacobian.col(clock_offset) =
          R * (antenna_at(t + half_step_s_) - antenna_at(t - half_step_s_)) / (2 * half_step_s_);
      row.jacobian.middleCols<3>(lever) = R * pose_at(t).linear();
      if (!row.has_height) {
        row.residual.z() = 0;
        row.jacobian.row(2).setZero();
      }
      rows.push_back(row);
    }
    return rows;
  }

  // Cauchy weights, and the size of the errors.
  void weigh(const std::vector<Row>& rows) {
    std::vector<double> sizes;
    for (const auto& r : rows) sizes.push_back(r.residual.head<2>().norm() / r.sd_m);
    // The median length of a plane normal deviate is 1.1774 standard deviations.
    unit_ = std::max(median(sizes) / 1.1774, 1e-6);
    constexpr double tuning = 2.385;  // 95 % efficiency on normal errors
    weights_.clear();
    for (const double size : sizes) {
      const double u = size / (tuning * unit_);
      weights_.push_back(1 / (1 + u * u));
    }
  }

  double information(std::size_t i, const Row& row) const {
    return weights_[i] / (unit_ * unit_ * row.sd_m * row.sd_m);
  }
  Eigen::Vector3d axis_weights(std::size_t i, const Row& row) const {
    const double w = information(i, row);
    return {w, w, row.has_height ? w / (track_height_factor * track_height_factor) : 0};
  }

  Matrix normal_matrix(const std::vector<Row>& rows) const {
    Matrix n = Matrix::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i)
      n += rows[i].jacobian.transpose() * axis_weights(i, rows[i]).asDiagonal() * rows[i].jacobian;
    const double known = 1 / (prior_.lever_sd_m * prior_.lever_sd_m);
    for (Eigen::Index k = 0; k < 3; ++k) n(lever + k, lever + k) += known;
    // Without heights nothing else holds the third part of the shift.
    if (!any_height_) n(shift + 2, shift + 2) += 1;
    return n;
  }
  Vector right_side(const std::vector<Row>& rows) const {
    Vector b = Vector::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i)
      b += rows[i].jacobian.transpose() * axis_weights(i, rows[i]).asDiagonal() * rows[i].residual;
    const double known = 1 / (prior_.lever_sd_m * prior_.lever_sd_m);
    b.segment<3>(lever) += known * (prior_.lever_sensor - x_.segment<3>(lever));
    return b;
  }

  // From the robust solution to that which allows for errors that last. Gross errors take no part.
  TrackEstimate weigh_lasting_errors() {
    TrackEstimate estimate;
    constexpr int iterations = 10;
    for (int k = 0; k < iterations; ++k) {
      auto rows = linearised();
      weigh(rows);
      constexpr double gross = 4.5;  // standard deviations
      for (auto& r : rows) r.used = r.residual.head<2>().norm() <= gross * unit_ * r.sd_m;
      estimate = estimate_with_lasting_errors(rows, prior_information(), unit_);
      x_ += estimate.step;
      x_(turn) = wrapped(x_(turn));
      if (k >= 3 && estimate.step.cwiseAbs().maxCoeff() < 1e-4) break;
      if (k >= 3) continue;
      // The slope over what is not known of the clocks: at a sudden turn that over an instant is too steep, and the
      // offset would seem better known than it is.
      constexpr double min_half_step_s = 0.05, max_half_step_s = 0.5, times = 3;
      half_step_s_ = std::clamp(times * std::sqrt(estimate.covariance(clock_offset, clock_offset)), min_half_step_s,
                                max_half_step_s);
    }
    return estimate;
  }

  TrackPriorInformation prior_information() const {
    TrackPriorInformation known;
    known.weight.segment<3>(lever).setConstant(1 / (prior_.lever_sd_m * prior_.lever_sd_m));
    known.residual.segment<3>(lever) = prior_.lever_sensor - x_.segment<3>(lever);
    // The plan says nothing of the height, and without heights nothing does: a metre keeps the equations regular.
    known.weight(shift + 2) = 1e-6;
    if (!any_height_) known.weight(shift + 2) = 1;
    return known;
  }

  TrackFit result(const TrackEstimate& estimate) {
    const auto rows = linearised();
    weigh(rows);
    const Matrix& covariance = estimate.covariance;
    const auto se = [&](Eigen::Index k) { return std::sqrt(covariance(k, k)); };
    TrackFit fit;
    fit.turn_rad = x_(turn);
    fit.centre_local = centre_;
    fit.centre_global = base_global_ + x_.segment<3>(shift);
    fit.heights = any_height_;
    fit.clock_offset_s = x_(clock_offset);
    fit.lever_sensor = x_.segment<3>(lever);
    fit.turn_se_rad = se(turn);
    fit.shift_se_m = std::sqrt((covariance(shift, shift) + covariance(shift + 1, shift + 1)) / 2);
    fit.height_se_m = se(shift + 2);
    fit.clock_offset_se_s = se(clock_offset);
    fit.lever_se_m = {se(lever), se(lever + 1), se(lever + 2)};
    fit.fixes_per_independent = estimate.fixes_per_independent;
    fit.fixes = rows.size();
    std::vector<double> distances;
    for (const auto& r : rows) distances.push_back(r.residual.head<2>().norm());
    fit.residual_m = median(distances) / 1.1774;
    constexpr double hardly = 0.15;  // beyond 5.7 standard deviations
    fit.outliers = static_cast<double>(std::ranges::count_if(weights_, [](double w) { return w < hardly; })) /
                   static_cast<double>(weights_.size());
    for (const auto& pose : walk_.poses)
      fit.extent_m = std::max(fit.extent_m, (pose.T_target_sensor.translation() - centre_).head<2>().norm());
    return fit;
  }

  const Trajectory& walk_;
  const std::vector<TrackFix>& track_;
  const TrackPrior& prior_;
  Vector x_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero(), base_global_ = Eigen::Vector3d::Zero();
  std::vector<double> weights_;
  double unit_ = 1, half_step_s_ = 0.05;
  bool any_height_ = false;
};

}  // namespace

TrackFit fit_track(const Trajectory& walk, const std::vector<TrackFix>& track, double clock_offset_s,
                   const TrackPrior& prior) {
  return TrackAdjustment(walk, track, clock_offset_s, prior).solve();
}

}  // namespace bole::survey
