#include "survey/core/georeference/track_noise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace bole::survey {
namespace {

// A row with its residual as the last column.
using Whole = Eigen::Matrix<double, track_unknowns + 1, 1>;
using RowSums = Eigen::Matrix<double, track_unknowns + 1, track_unknowns + 1>;

struct Process {
  double time_constant_s = 1, white_share = 0;
};

// RowSums of products of rows that were made independent, in units of the errors' variance.
struct WhiteSums {
  RowSums plan = RowSums::Zero(), heights = RowSums::Zero();
  double log_variance = 0;  // of the plan: log determinant of the correlation
  double observations = 0;  // of the plan
};

// One axis, fix after fix: the lasting part is predicted from those before (Kalman filter), what is new is independent.
class AxisFilter {
 public:
  explicit AxisFilter(const Process& process) : p_(process), variance_(1 - process.white_share) {}

  // Adds the innovation of `row` to `sums`; returns the logarithm of its variance.
  double add(const Whole& row, double time_s, RowSums& sums) {
    if (began_) {
      const double keep = std::exp(-std::max(0.0, time_s - last_s_) / p_.time_constant_s);
      mean_ *= keep;
      variance_ = keep * keep * variance_ + (1 - keep * keep) * (1 - p_.white_share);
    }
    began_ = true;
    last_s_ = time_s;
    constexpr double least = 1e-9;  // fixes at the same time
    const double innovation_variance = std::max(variance_ + p_.white_share, least);
    const Whole innovation = row - mean_;
    const double gain = variance_ / innovation_variance;
    mean_ += gain * innovation;
    variance_ *= 1 - gain;
    sums.noalias() += innovation * innovation.transpose() / innovation_variance;
    return std::log(innovation_variance);
  }

 private:
  Process p_;
  Whole mean_ = Whole::Zero();
  double variance_;
  double last_s_ = 0;
  bool began_ = false;
};

WhiteSums white_sums(const std::vector<TrackRow>& rows, const Process& process) {
  WhiteSums sums;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    AxisFilter filter(process);
    const bool height = axis == 2;
    for (const auto& r : rows) {
      if (!r.used || (height && !r.has_height)) continue;
      Whole row;
      row << r.jacobian.row(axis).transpose(), r.residual(axis);
      row /= r.sd_m * (height ? track_height_factor : 1);
      const double log_variance = filter.add(row, r.time_s, height ? sums.heights : sums.plan);
      if (height) continue;
      sums.log_variance += log_variance;
      ++sums.observations;
    }
  }
  return sums;
}

// The unknowns where size and duration of the errors are known, and how well they explain the residuals.
struct Answer {
  TrackVector step;
  TrackMatrix covariance;
  double log_likelihood = 0;
};

Answer answer_of(const WhiteSums& sums, double sd_m, const TrackPriorInformation& prior) {
  constexpr int n = track_unknowns;
  const double w = 1 / (sd_m * sd_m);
  const TrackMatrix known = prior.weight.asDiagonal();
  const TrackVector pull = prior.weight.cwiseProduct(prior.residual);
  const auto solve = [&](const RowSums& all) {
    const TrackMatrix normal = w * all.topLeftCorner<n, n>() + known;
    return std::pair(Eigen::LDLT<TrackMatrix>(normal), TrackVector(w * all.topRightCorner<n, 1>() + pull));
  };
  const auto [plan, plan_side] = solve(sums.plan);
  Answer answer;
  const double log_determinant = plan.vectorD().array().max(1e-300).log().sum();
  answer.log_likelihood = -0.5 * (sums.observations * 2 * std::log(sd_m) + sums.log_variance + log_determinant +
                                  w * sums.plan(n, n) - plan_side.dot(plan.solve(plan_side)));
  const auto [all, side] = solve(sums.plan + sums.heights);
  answer.step = all.solve(side);
  answer.covariance = all.solve(TrackMatrix::Identity());
  return answer;
}

std::vector<double> log_steps(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from * std::pow(to / from, i / (count - 1.0)));
  return values;
}

std::vector<Process> processes(const std::vector<TrackRow>& rows) {
  const double span_s = std::max(1e-3, rows.back().time_s - rows.front().time_s);
  const double step_s = span_s / static_cast<double>(rows.size());
  // What lasts longer than half of the walk cannot be told from a shift of the whole track.
  constexpr double shortest = 0.3, longest = 0.5;
  constexpr int constants = 16;
  std::vector<Process> all;
  for (const double t : log_steps(shortest * step_s, longest * span_s, constants))
    for (const double white : {0.0, 0.05, 0.15, 0.35, 0.6, 0.85}) all.push_back({t, white});
  return all;
}

}  // namespace

TrackEstimate estimate_with_lasting_errors(const std::vector<TrackRow>& rows, const TrackPriorInformation& prior,
                                           double usual_sd_m) {
  struct Candidate {
    Process process;
    double sd_m;
    double independent;  // fixes per independent one
    Answer answer;
  };
  std::vector<Candidate> candidates;
  double best = -1e300;
  constexpr double smallest = 0.5, largest = 3;
  constexpr int sizes = 18;
  for (const auto& process : processes(rows)) {
    const auto sums = white_sums(rows, process);
    // The column of the easting is 1 in every row of the first axis.
    const double ratio = sums.observations / 2 / std::max(1e-12, sums.plan(1, 1));
    for (const double sd_m : log_steps(smallest * usual_sd_m, largest * usual_sd_m, sizes)) {
      candidates.push_back({process, sd_m, ratio, answer_of(sums, sd_m, prior)});
      best = std::max(best, candidates.back().answer.log_likelihood);
    }
  }
  TrackEstimate mean;
  double total = 0;
  for (auto& c : candidates) total += c.answer.log_likelihood = std::exp(c.answer.log_likelihood - best);
  mean.fixes_per_independent = 0;
  for (const auto& c : candidates) {
    const double share = c.answer.log_likelihood / total;
    mean.step += share * c.answer.step;
    mean.sd_m += share * c.sd_m;
    mean.time_constant_s += share * c.process.time_constant_s;
    mean.white_share += share * c.process.white_share;
    mean.fixes_per_independent += share * c.independent;
  }
  for (const auto& c : candidates) {
    const TrackVector off = c.answer.step - mean.step;
    mean.covariance += c.answer.log_likelihood / total * (c.answer.covariance + off * off.transpose());
  }
  return mean;
}

}  // namespace bole::survey
