#include "ground/core/terrain.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground/core/ground_band.h"

namespace bole::ground {
namespace {

constexpr std::size_t max_points_per_cell = 60;
constexpr std::size_t min_neighbour_points = 8;  // of the neighbours, for a cell that has none itself

// Points of a cell near the rough surface.
struct NearGround {
  float x, y, height;
};

class TerrainFitter {
 public:
  TerrainFitter(const PointCloud& cloud, const PointGrid& grid, const std::vector<float>& prior,
                const GroundScales& scales)
      : cloud_(cloud), grid_(grid), shape_(grid.shape()), prior_(prior), scales_(scales) {}

  // Fits rows [first, last) of cells.
  void fit_rows(int first, int last, std::vector<float>& height, std::vector<float>& sigma) const {
    const int low = std::max(0, first - 1), high = std::min(shape_.ny, last + 1);
    std::vector<std::vector<NearGround>> near(static_cast<std::size_t>(high - low) *
                                              static_cast<std::size_t>(shape_.nx));
    for (int iy = low; iy < high; ++iy)
      for (int ix = 0; ix < shape_.nx; ++ix) collect(ix, iy, near[local(ix, iy - low)]);
    std::vector<BandPoint> window;
    for (int iy = first; iy < last; ++iy)
      for (int ix = 0; ix < shape_.nx; ++ix) {
        const auto cell = shape_.index(ix, iy);
        if (std::isnan(prior_[cell])) continue;
        gather(ix, iy, low, high, near, window);
        const bool own = !near[local(ix, iy - low)].empty();
        if (window.empty() || (!own && !surrounded(window))) continue;
        const auto fit = fit_ground_band(window, scales_.band);
        if (fit.height > scales_.roughness) continue;  // only leaves, stones or bark are seen here
        height[cell] = prior_[cell] + static_cast<float>(fit.height);
        sigma[cell] = static_cast<float>(fit.sigma);
      }
  }

 private:
  std::size_t local(int ix, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(shape_.nx) + static_cast<std::size_t>(ix);
  }

  // The gradient of the rough surface in a cell, zero where a neighbour is missing.
  Eigen::Vector2f gradient(int ix, int iy) const {
    const auto slope = [&](int dx, int dy) {
      const bool after = shape_.contains(ix + dx, iy + dy), before = shape_.contains(ix - dx, iy - dy);
      const float a = before ? prior_[shape_.index(ix - dx, iy - dy)] : prior_[shape_.index(ix, iy)];
      const float b = after ? prior_[shape_.index(ix + dx, iy + dy)] : prior_[shape_.index(ix, iy)];
      const float g =
          (b - a) / static_cast<float>(shape_.cell_m * (static_cast<int>(after) + static_cast<int>(before)));
      return std::isfinite(g) ? g : 0.0F;
    };
    return {slope(1, 0), slope(0, 1)};
  }

  // Points within the band; of many an even choice over their heights, which keeps their distribution.
  void collect(int ix, int iy, std::vector<NearGround>& out) const {
    const auto cell = shape_.index(ix, iy);
    if (std::isnan(prior_[cell])) return;
    const Eigen::Vector2f centre = shape_.centre(ix, iy).cast<float>(), slope = gradient(ix, iy);
    const auto band = static_cast<float>(scales_.band);
    const auto& positions = cloud_.positions();
    // The points of a cell are in the order of their heights: those that can be near are read alone.
    const float half = static_cast<float>(shape_.cell_m) * slope.cwiseAbs().sum(), rounding = 1e-3F;
    const auto points = grid_.points(cell);
    const auto height = [&](std::uint32_t i) { return positions[i].z(); };
    for (auto it = std::ranges::lower_bound(points, prior_[cell] - half - band - rounding, {}, height);
         it != points.end(); ++it) {
      const auto& p = positions[*it];
      if (p.z() > prior_[cell] + half + band + rounding) break;
      const float surface = prior_[cell] + slope.dot(p.head<2>() - centre);
      if (std::abs(p.z() - surface) <= band) out.push_back({p.x(), p.y(), p.z()});
    }
    if (out.size() <= max_points_per_cell) return;
    for (std::size_t k = 0; k < max_points_per_cell; ++k)
      out[k] = out[(2 * k + 1) * out.size() / (2 * max_points_per_cell)];
    out.resize(max_points_per_cell);
  }

  void gather(int ix, int iy, int low, int high, const std::vector<std::vector<NearGround>>& near,
              std::vector<BandPoint>& window) const {
    window.clear();
    const Eigen::Vector2f centre = shape_.centre(ix, iy).cast<float>(), slope = gradient(ix, iy);
    const float base = prior_[shape_.index(ix, iy)], band = static_cast<float>(scales_.band);
    for (int jy = std::max(low, iy - 1); jy <= std::min(high - 1, iy + 1); ++jy)
      for (int jx = std::max(0, ix - 1); jx <= std::min(shape_.nx - 1, ix + 1); ++jx)
        for (const auto& p : near[local(jx, jy - low)]) {
          const float dx = p.x - centre.x(), dy = p.y - centre.y(),
                      h = p.height - base - slope.x() * dx - slope.y() * dy;
          if (std::abs(h) <= band) window.push_back({dx, dy, h});
        }
  }

  // Whether the neighbours' points lie on several sides, so that the fit interpolates.
  bool surrounded(const std::vector<BandPoint>& window) const {
    if (window.size() < min_neighbour_points) return false;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& p : window) mean += Eigen::Vector2d(static_cast<double>(p.dx), static_cast<double>(p.dy));
    return (mean / static_cast<double>(window.size())).norm() < 0.4 * shape_.cell_m;
  }

  const PointCloud& cloud_;
  const PointGrid& grid_;
  const GridShape& shape_;
  const std::vector<float>& prior_;
  const GroundScales& scales_;
};

}  // namespace

TerrainFit fit_terrain(const PointCloud& cloud, const PointGrid& grid, const std::vector<float>& prior,
                       const GroundScales& scales, const Run& run) {
  const auto& shape = grid.shape();
  TerrainFit out;
  out.height.assign(shape.cells(), std::numeric_limits<float>::quiet_NaN());
  std::vector<float> sigma(shape.cells(), 0);
  const TerrainFitter fitter(cloud, grid, prior, scales);
  tbb::parallel_for(tbb::blocked_range<int>(0, shape.ny, 8), [&](const auto& range) {
    run.check_cancel();
    fitter.fit_rows(range.begin(), range.end(), out.height, sigma);
  });
  for (std::size_t c = 0; c < shape.cells(); ++c)
    if (!std::isnan(out.height[c])) ++out.cells, out.mean_sigma_m += static_cast<double>(sigma[c]);
  if (out.cells > 0) out.mean_sigma_m /= static_cast<double>(out.cells);
  return out;
}

}  // namespace bole::ground
