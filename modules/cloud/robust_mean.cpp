#include "cloud/robust_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"

namespace bole {
inline namespace cloud {

RobustMean robust_mean(const std::vector<Eigen::VectorXd>& samples, const std::vector<double>& weights,
                       double min_sigma) {
  const auto dims = samples.front().size();
  RobustMean out;
  out.mean.resize(dims);
  for (Eigen::Index k = 0; k < dims; ++k) {
    std::vector<double> axis;
    for (const auto& s : samples) axis.push_back(s(k));
    out.mean(k) = upper_median(std::move(axis));
  }
  constexpr int iterations = 20;
  for (int it = 0; it < iterations; ++it) {
    std::vector<double> distances;
    for (const auto& s : samples) distances.push_back((s - out.mean).norm());
    // The median distance of a normal sample is 0.674, 1.177, 1.538 sigma in one, two, three dimensions.
    const double per_sigma = dims == 1 ? 0.674 : dims == 2 ? 1.177 : 1.538;
    out.sigma = std::max(min_sigma, upper_median(std::vector(distances)) / per_sigma);
    const double cut = 4.685 * out.sigma;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(dims);
    double total = 0, squares = 0, scatter = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double u = distances[i] / cut;
      if (u >= 1) continue;
      const double w = (weights.empty() ? 1.0 : weights[i]) * (1 - u * u) * (1 - u * u);
      sum += w * samples[i], total += w, squares += w * w, scatter += w * distances[i] * distances[i];
    }
    if (!(total > 0)) break;
    const Eigen::VectorXd next = sum / total;
    const double step = (next - out.mean).norm();
    out.mean = next;
    out.effective_count = total * total / squares;
    out.standard_error =
        std::sqrt(scatter / total / static_cast<double>(dims) / std::max(1.0, out.effective_count - 1));
    if (step < 1e-9) break;
  }
  return out;
}

}  // namespace cloud
}  // namespace bole
