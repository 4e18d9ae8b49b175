#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/statistics.h"
#include "plant/core/separate/find_pot.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_cells = 12;
constexpr std::size_t min_cells_of_curve = 60;
constexpr double tukey = 4.685;

// z of the densest height among the cells: the middle of the shortest window that holds a third of them.
double mode_of(std::vector<double> z) {
  std::ranges::sort(z);
  const std::size_t span = std::max<std::size_t>(2, z.size() / 3);
  std::size_t best = 0;
  for (std::size_t i = 0; i + span < z.size(); ++i)
    if (z[i + span] - z[i] < z[best + span] - z[best]) best = i;
  return median({z.begin() + static_cast<std::ptrdiff_t>(best),
                 z.begin() + static_cast<std::ptrdiff_t>(std::min(best + span + 1, z.size()))});
}

struct Fit {
  Eigen::Vector4d x = Eigen::Vector4d::Zero();  // height, slope x, slope y, curvature
  double sigma = 0;
  double weight = 0;
};

Eigen::Vector4d row_of(const Eigen::Vector2d& d, double radius, bool curved) {
  return {1, d.x() / radius, d.y() / radius, curved ? d.squaredNorm() / (radius * radius) : 0};
}

Fit fit_cells(const Points3& cells, const Eigen::Vector2d& centre, double radius, bool curved, double height,
              double tolerance) {
  Fit fit;
  fit.x[0] = height;
  double scale = tolerance;
  for (int round = 0; round < 30; ++round) {
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    std::vector<double> sizes;
    double squares = 0;
    fit.weight = 0;
    for (const auto& c : cells) {
      const Eigen::Vector4d row = row_of(c.head<2>() - centre, radius, curved);
      const double off = c.z() - row.dot(fit.x), u = off / (tukey * scale);
      if (std::abs(u) >= 1) continue;
      const double w = (1 - u * u) * (1 - u * u);
      a += w * row * row.transpose();
      b += w * off * row;
      fit.weight += w;
      squares += w * off * off;
      sizes.push_back(std::abs(off));
    }
    if (sizes.size() < 6) return fit;
    if (!curved) a(3, 3) = 1;
    // A weak prior: soil in a pot is level within about 20 degrees.
    const double prior = 1e-3 * fit.weight;
    a(1, 1) += prior;
    a(2, 2) += prior;
    fit.x += a.ldlt().solve(b);
    fit.sigma = std::sqrt(squares / fit.weight);
    scale = std::max(1.4826 * median(std::move(sizes)), tolerance / 20);
  }
  return fit;
}

}  // namespace

std::optional<FoundSoil> find_soil(const Points3& level, const Eigen::Vector2d& centre, double radius, double bottom,
                                   double top, double tolerance) {
  const double cell = radius / 14;
  std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> by_cell;
  for (const auto& p : level) {
    const Eigen::Vector2d d = p.head<2>() - centre;
    if (d.squaredNorm() > radius * radius || p.z() < bottom || p.z() > top) continue;
    const auto part = [&](double v) { return static_cast<std::uint64_t>(std::floor(v / cell) + 1000); };
    by_cell[part(d.x()) << 32 | part(d.y())].push_back(p);
  }
  std::vector<std::pair<std::uint64_t, Eigen::Vector3d>> sorted;
  for (auto& [key, points] : by_cell) {
    // The lower quarter of a cell: what grows over the soil is above it, what is below it is noise.
    std::ranges::sort(points, {}, [](const auto& p) { return p.z(); });
    const std::size_t n = std::max<std::size_t>(1, points.size() / 2);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) mean += points[i];
    // Of a flat cell the lower half would lie too low: its median stands for it.
    const auto& middle = points[points.size() / 2];
    const bool flat = points.back().z() - points.front().z() < tolerance;
    mean /= static_cast<double>(n);
    if (flat) mean.z() = middle.z();
    sorted.emplace_back(key, mean);
  }
  std::ranges::sort(sorted, {}, &std::pair<std::uint64_t, Eigen::Vector3d>::first);
  Points3 cells;
  std::vector<double> heights;
  for (const auto& [key, p] : sorted) {
    cells.push_back(p);
    heights.push_back(p.z());
  }
  if (cells.size() < min_cells) return std::nullopt;
  const double start = mode_of(heights);
  Fit fit = fit_cells(cells, centre, radius, false, start, tolerance);
  if (fit.weight < min_cells || fit.weight < 0.15 * static_cast<double>(cells.size())) return std::nullopt;
  if (cells.size() >= min_cells_of_curve) {
    const Fit curved = fit_cells(cells, centre, radius, true, fit.x[0], std::max(3 * fit.sigma, tolerance / 10));
    if (curved.weight >= 0.8 * fit.weight && curved.sigma < 0.9 * fit.sigma) fit = curved;
  }
  FoundSoil soil;
  soil.centre = centre;
  soil.height = fit.x[0];
  soil.slope = fit.x.segment<2>(1) / radius;
  soil.curvature = fit.x[3] / (radius * radius);
  soil.sigma = fit.sigma;
  soil.cell = cell;
  soil.cells = static_cast<std::size_t>(fit.weight);
  return soil;
}

}  // namespace bole::plant
