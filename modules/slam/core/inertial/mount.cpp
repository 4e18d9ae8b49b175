#include "slam/core/inertial/mount.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/option.h"

namespace bole::slam {
namespace {

constexpr double max_offset_s = 0.5, coarse_step_s = 0.01, fine_step_s = 0.002;
constexpr std::size_t min_frames = 30, min_checked_frames = 15;
constexpr double max_turn_sigma_rad = radians(1.5), max_lever_sigma = 0.05;
constexpr double lever_prior = 0.3, accelerometer_prior = 0.3, gravity_prior = 12;
// A frame that was registered alone lags: its prior is the motion of the frame before it. Measured on simulated
// walks: 2 ms for frames of 0.1 s.
constexpr double frame_lag = 0.02;
// Rates that fit this badly are not of the same motion.
constexpr double min_correlation = 0.8;

// Mean rates over frames in the axes of both instruments.
struct Pairs {
  Eigen::Matrix3Xd sensor, unit;
};

// The integral of the rates up to a time, so that a mean over any span costs two look-ups.
class RateIntegral {
 public:
  explicit RateIntegral(const std::vector<InertialSample>& samples) : samples_(samples), sum_(samples.size()) {
    for (std::size_t i = 0; i < samples.size(); ++i)
      sum_[i] =
          i == 0
              ? Eigen::Vector3d::Zero()
              : Eigen::Vector3d(sum_[i - 1] + 0.5 * (samples[i].time_s - samples[i - 1].time_s) *
                                                  (samples[i].angular_rate_rad_s + samples[i - 1].angular_rate_rad_s));
  }
  Eigen::Vector3d mean(double begin_s, double end_s) const { return (at(end_s) - at(begin_s)) / (end_s - begin_s); }

 private:
  Eigen::Vector3d at(double time_s) const {
    auto next = std::ranges::upper_bound(samples_, time_s, {}, &InertialSample::time_s);
    next = std::clamp(next, samples_.begin() + 1, samples_.end() - 1);
    const auto i = static_cast<std::size_t>(next - samples_.begin());
    const auto &a = samples_[i - 1], &b = samples_[i];
    const double T = b.time_s - a.time_s, u = std::clamp((time_s - a.time_s) / T, 0.0, 1.0);
    return sum_[i - 1] + T * (u * a.angular_rate_rad_s + 0.5 * u * u * (b.angular_rate_rad_s - a.angular_rate_rad_s));
  }
  const std::vector<InertialSample>& samples_;
  std::vector<Eigen::Vector3d> sum_;
};

Eigen::Vector3d sensor_rate(const TimedMotion& f) {
  return so3_log(Eigen::Quaterniond(f.motion.T_map_begin.linear().transpose() * f.motion.T_map_end.linear())) /
         (f.end_s - f.begin_s);
}

struct Fit {
  Eigen::Matrix3d R_sensor_imu = Eigen::Matrix3d::Identity();
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  double residual2 = 0, signal2 = 0;  // sums of squares
  // What both instruments saw turn, in squared rates: noise is not in it, since theirs have nothing in common.
  Eigen::Matrix3d shared = Eigen::Matrix3d::Zero();  // axes of the sensor
};

// sensor = R (unit - bias), both centred.
Fit fit_turn(const Pairs& pairs) {
  const Eigen::Vector3d mean_sensor = pairs.sensor.rowwise().mean(), mean_unit = pairs.unit.rowwise().mean();
  const Eigen::Matrix3Xd s = pairs.sensor.colwise() - mean_sensor, u = pairs.unit.colwise() - mean_unit;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(s * u.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  Fit out;
  out.R_sensor_imu = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  out.bias = mean_unit - out.R_sensor_imu.transpose() * mean_sensor;
  out.residual2 = (s - out.R_sensor_imu * u).squaredNorm();
  out.signal2 = s.squaredNorm();
  const Eigen::Vector3d strength = svd.singularValues().cwiseProduct(signs).cwiseMax(0);
  out.shared = svd.matrixU() * strength.asDiagonal() * svd.matrixU().transpose();
  return out;
}

Pairs pairs_at(const RateIntegral& integral, const std::vector<TimedMotion>& frames, double offset_s) {
  Pairs pairs;
  pairs.sensor.resize(3, static_cast<Eigen::Index>(frames.size()));
  pairs.unit.resize(3, static_cast<Eigen::Index>(frames.size()));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    pairs.sensor.col(column) = sensor_rate(frames[k]);
    pairs.unit.col(column) = integral.mean(frames[k].begin_s + offset_s, frames[k].end_s + offset_s);
  }
  return pairs;
}

double best_offset(const RateIntegral& integral, const std::vector<TimedMotion>& frames) {
  const auto residual = [&](double offset_s) { return fit_turn(pairs_at(integral, frames, offset_s)).residual2; };
  double best = 0, least = residual(0);
  const auto search = [&](double centre, double reach, double step) {
    for (double d = -reach; d <= reach + 1e-9; d += step)
      if (const double r = residual(centre + d); r < least) least = r, best = centre + d;
  };
  search(0, max_offset_s, coarse_step_s);
  search(best, coarse_step_s, fine_step_s);
  const double before = residual(best - fine_step_s), after = residual(best + fine_step_s),
               curve = before - 2 * least + after;
  return curve > 0 ? best + 0.5 * fine_step_s * (before - after) / curve : best;
}

// Standard deviations of turn and offset by their normal equations; the errors of frames are about independent. Where
// nothing turns, both instruments show noise. So the information about the turn is what they saw in common, and not the
// sum of squares of either, which grows with every frame at rest.
void judge_turn(const RateIntegral& integral, const std::vector<TimedMotion>& frames, const Fit& fit, Mount& out) {
  const Pairs here = pairs_at(integral, frames, out.time_offset_s),
              later = pairs_at(integral, frames, out.time_offset_s + fine_step_s);
  const Eigen::Vector3d mean = here.unit.rowwise().mean();
  Eigen::Vector3d turn_clock = Eigen::Vector3d::Zero();
  double clock = 1e-12;
  for (Eigen::Index k = 0; k < here.unit.cols(); ++k) {
    const Eigen::Vector3d by_clock = fit.R_sensor_imu * (later.unit.col(k) - here.unit.col(k)) / fine_step_s;
    turn_clock += skew(fit.R_sensor_imu * (here.unit.col(k) - mean)).transpose() * by_clock;
    clock += by_clock.squaredNorm();
  }
  const Eigen::Matrix3d turn = fit.shared.trace() * Eigen::Matrix3d::Identity() - fit.shared,
                        without_clock = turn - turn_clock * turn_clock.transpose() / clock;
  const double variance = fit.residual2 / std::max(1.0, 3.0 * static_cast<double>(frames.size()) - 7);
  const double weakest =
      std::max(1e-12, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(without_clock).eigenvalues()[0]);
  out.turn_sigma_rad = std::min(std::numbers::pi, std::sqrt(variance / weakest));
  const double rest = clock - turn_clock.dot((turn + 1e-12 * Eigen::Matrix3d::Identity()).ldlt().solve(turn_clock));
  const double frame_s = frames.front().end_s - frames.front().begin_s;
  out.time_sigma_s = std::hypot(std::sqrt(variance / std::max(rest, 1e-12)), frame_lag * frame_s);
}

// Changes of velocity between frames that follow each other: the places of the unit are p + R l. Unknowns: lever arm,
// gravity (map axes), bias of the accelerometer.
void find_lever(const InertialMeasurements& data, const std::vector<TimedMotion>& frames, Mount& out) {
  constexpr double max_join_s = 0.05;
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  using Vector9 = Eigen::Matrix<double, 9, 1>;
  std::vector<std::pair<Eigen::Matrix<double, 3, 9>, Eigen::Vector3d>> equations;
  const Eigen::Matrix3d R_si = out.T_sensor_imu.linear();
  const InertialBias bias{out.bias.gyroscope, Eigen::Vector3d::Zero()};
  for (std::size_t k = 2; k < frames.size(); ++k) {
    const auto &f0 = frames[k - 2], &f1 = frames[k - 1], &f2 = frames[k];
    if (f1.begin_s - f0.end_s > max_join_s || f2.begin_s - f1.end_s > max_join_s) continue;
    if (!data.cover(f0.begin_s, f2.begin_s)) continue;
    const Preintegration a = data.integrate(f0.begin_s, f1.begin_s, bias, {}),
                         b = data.integrate(f1.begin_s, f2.begin_s, bias, {});
    const Pose &A = f0.motion.T_map_begin, &B = f1.motion.T_map_begin, &C = f2.motion.T_map_begin;
    const double T0 = a.duration_s, T1 = b.duration_s;
    const Eigen::Matrix3d R0 = A.linear() * R_si, R1 = B.linear() * R_si;
    Eigen::Matrix<double, 3, 9> J;
    J << (C.linear() - B.linear()) / T1 - (B.linear() - A.linear()) / T0,
        -0.5 * (T0 + T1) * Eigen::Matrix3d::Identity(),
        -R0 * (a.velocity_by_accelerometer - a.shift_by_accelerometer / T0) - R1 * b.shift_by_accelerometer / T1;
    const Eigen::Vector3d e = (C.translation() - B.translation()) / T1 - (B.translation() - A.translation()) / T0 -
                              R0 * (a.velocity - a.shift / T0) - R1 * b.shift / T1;
    equations.emplace_back(J, e);
  }
  out.lever_sigma = lever_prior;
  if (equations.size() < min_frames) return;
  Vector9 x = Vector9::Zero();
  double sigma = 0.05;
  Matrix9 N;
  for (int round = 0; round < 4; ++round) {  // with weights by the last residuals
    Vector9 prior;
    prior << Eigen::Vector3d::Constant(lever_prior), Eigen::Vector3d::Constant(gravity_prior),
        Eigen::Vector3d::Constant(accelerometer_prior);
    N = prior.cwiseAbs2().cwiseInverse().asDiagonal();
    Vector9 g = Vector9::Zero();
    for (const auto& [J, e] : equations) {
      const double r2 = (e + J * x).squaredNorm() / (sigma * sigma), w = round == 0 ? 1 : 1 / (1 + r2 / 9);
      N += w / (sigma * sigma) * J.transpose() * J;
      g -= w / (sigma * sigma) * J.transpose() * e;
    }
    x = N.ldlt().solve(g);
    double sum = 0;
    for (const auto& [J, e] : equations) sum += std::min((e + J * x).squaredNorm(), 9 * 3 * sigma * sigma);
    sigma = std::sqrt(sum / (3.0 * static_cast<double>(equations.size())));
  }
  const Matrix9 C = N.inverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(C.topLeftCorner<3, 3>()));
  out.lever_sigma = std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
  out.lever_known = out.lever_sigma < max_lever_sigma;
  out.bias.accelerometer = x.tail<3>();
  if (out.lever_known) out.T_sensor_imu.translation() = x.head<3>();
}

}  // namespace

Mount estimate_mount(const InertialRecord& record, const std::vector<TimedMotion>& all,
                     std::optional<double> time_offset_s) {
  Mount out;
  out.time_offset_s = time_offset_s.value_or(0);
  const double reach_s = time_offset_s ? std::abs(*time_offset_s) : max_offset_s + fine_step_s;
  std::vector<TimedMotion> frames;
  const InertialMeasurements stamped(record);
  for (const auto& f : all)
    if (f.end_s - f.begin_s > 0.01 && stamped.cover(f.begin_s - reach_s, f.end_s + reach_s)) frames.push_back(f);
  out.frames = frames.size();
  if (frames.size() < min_frames) {
    out.unknown = std::to_string(frames.size()) + " frames have measurements of the unit; " +
                  std::to_string(min_frames) + " are needed";
    return out;
  }
  const RateIntegral integral(record.samples);
  if (!time_offset_s) out.time_offset_s = best_offset(integral, frames);
  const Fit fit = fit_turn(pairs_at(integral, frames, out.time_offset_s));
  out.T_sensor_imu.linear() = fit.R_sensor_imu;
  out.bias.gyroscope = fit.bias;
  judge_turn(integral, frames, fit, out);
  const double share = 1 - fit.residual2 / std::max(fit.signal2, 1e-12);
  if (out.turn_sigma_rad > max_turn_sigma_rad)
    out.unknown = "the walk turns too little about some axis: the mount is known only to " +
                  number_text(std::round(10 * degrees(out.turn_sigma_rad)) / 10) + " deg";
  else if (share < min_correlation)
    out.unknown = "the rates of the unit explain only " + number_text(std::round(100 * share)) +
                  " % of the turns of the scanner: is it of this recording, and in rad/s?";
  if (out.unknown.empty()) find_lever(InertialMeasurements(record, out.time_offset_s), frames, out);
  return out;
}

MountCheck check_mount(const InertialRecord& record, const std::vector<TimedMotion>& all, double time_offset_s) {
  constexpr double same_size = 0.3, same_size_rad_s = radians(8), max_sigma_rad = radians(5);
  MountCheck out;
  if (!record.T_sensor_imu || record.samples.size() < 2) return out;
  const RateIntegral integral(record.samples);
  const InertialMeasurements stamped(record);
  std::vector<TimedMotion> frames;
  for (const auto& f : all) {
    if (f.end_s - f.begin_s < 0.01 || !stamped.cover(f.begin_s + time_offset_s, f.end_s + time_offset_s)) continue;
    const double seen = sensor_rate(f).norm(),
                 measured = integral.mean(f.begin_s + time_offset_s, f.end_s + time_offset_s).norm();
    if (std::abs(seen - measured) < same_size_rad_s + same_size * measured) frames.push_back(f);
  }
  if (frames.size() < min_checked_frames) return out;
  const Fit fit = fit_turn(pairs_at(integral, frames, time_offset_s));
  Mount shown;
  shown.time_offset_s = time_offset_s;
  judge_turn(integral, frames, fit, shown);
  out.sigma_rad = shown.turn_sigma_rad;
  out.judged = out.sigma_rad < max_sigma_rad && fit.residual2 < (1 - min_correlation) * fit.signal2;
  out.off_rad = Eigen::AngleAxisd(record.T_sensor_imu->linear().transpose() * fit.R_sensor_imu).angle();
  return out;
}

}  // namespace bole::slam
