#include "stems/core/shared/drawn_mean.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {

SharedMean bounded_mean(const std::vector<SharedEvidence>& stems, double between, double shared, double weak) {
  std::vector<double> values, doubts;
  for (const auto& e : stems) values.push_back(e.value), doubts.push_back(e.doubt);
  const double common = std::hypot(shared, doubts.empty() ? 0 : upper_median(doubts));
  SharedMean out{values.empty() ? 0 : upper_median(values), weak};
  for (int round = 0; round < 10; ++round) {
    double weight = 1 / (weak * weak), moment = 0;
    for (const auto& e : stems) {
      const double v = e.sd * e.sd + between * between;
      const double w = tukey_weight((e.value - out.mean) / std::sqrt(v)) / v;
      weight += w, moment += w * e.value;
    }
    out = {moment / weight, std::sqrt(1 / weight + common * common)};
  }
  return out;
}

SharedMean drawn_to_zero(const SharedMean& likelihood, double expected) {
  constexpr int steps = 2000;
  constexpr double freedom = 3;
  const auto [mean, sd] = likelihood;
  const double reach = std::abs(mean) + 6 * sd;
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = reach * (2.0 * i / steps - 1), u = x / expected;
    const double w =
        std::exp(-0.5 * (x - mean) * (x - mean) / (sd * sd)) * std::pow(1 + u * u / freedom, -(freedom + 1) / 2);
    sum += w, first += w * x, second += w * x * x;
  }
  const double drawn = first / sum;
  return {drawn, std::sqrt(std::max(0.0, second / sum - drawn * drawn))};
}

}  // namespace bole::stems
