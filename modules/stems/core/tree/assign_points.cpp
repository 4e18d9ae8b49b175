#include "stems/core/tree/assign_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stems/core/tree/tree_axis.h"

namespace bole::stems {
namespace {

constexpr double lowest_point_m = 0.10;
constexpr double near_reach_m = 2.5;  // of what lies between ground and crowns

class AxisGrid {
 public:
  AxisGrid(const std::vector<TreeAxis>& axes, double reach) {
    constexpr double cell = 1.0;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const double sway = max_slope_above * tallest_m + 3;
    for (const auto& a : axes)
      low = low.cwiseMin(a.stem->breast_height.head<2>()), high = high.cwiseMax(a.stem->breast_height.head<2>());
    corner_ = low.array() - (reach + sway);
    cell_ = std::max(cell, (high - low).maxCoeff() / 2000);
    nx_ = static_cast<int>((high.x() + reach + sway - corner_.x()) / cell_) + 1,
    ny_ = static_cast<int>((high.y() + reach + sway - corner_.y()) / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
    for (std::uint32_t k = 0; k < axes.size(); ++k) {
      const double z = axes[k].stem->ground_z;
      const Eigen::Vector2d a = axes[k].at(z), b = axes[k].at(axes[k].bend_z), c = axes[k].at(z + tallest_m);
      const Eigen::Vector2d from = a.cwiseMin(b).cwiseMin(c).array() - reach,
                            to = a.cwiseMax(b).cwiseMax(c).array() + reach;
      for (int iy = clamp(from.y(), corner_.y(), ny_); iy <= clamp(to.y(), corner_.y(), ny_); ++iy)
        for (int ix = clamp(from.x(), corner_.x(), nx_); ix <= clamp(to.x(), corner_.x(), nx_); ++ix)
          cells_[index(ix, iy)].push_back(k);
    }
  }
  const std::vector<std::uint32_t>& near(double x, double y) const {
    static const std::vector<std::uint32_t> none;
    if (!(x >= corner_.x() && y >= corner_.y() && x < corner_.x() + nx_ * cell_ && y < corner_.y() + ny_ * cell_))
      return none;
    return cells_[index(clamp(x, corner_.x(), nx_), clamp(y, corner_.y(), ny_))];
  }

 private:
  int clamp(double v, double corner, int n) const {
    return static_cast<int>(std::clamp((v - corner) / cell_, 0.0, n - 1.0));
  }
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix);
  }
  Eigen::Vector2d corner_;
  double cell_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool is_bark(const Stem& s, const Eigen::Vector3d& p, double tolerance) {
  const Eigen::Vector3d q = p - s.breast_height;
  const double along = q.dot(s.direction), height = p.z() - s.ground_z;
  if (height < lowest_point_m || height > s.highest + 0.5) return false;
  return std::abs((q - along * s.direction).norm() - s.radius - s.taper * along) <= tolerance;
}

}  // namespace

PointLabels assign_points(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                          const Run& run) {
  PointLabels labels{std::vector<std::int32_t>(points.size(), 0), std::vector<std::uint8_t>(points.size(), 0)};
  if (stems.empty()) return labels;
  std::vector<TreeAxis> axes;
  double widest = 0;
  for (const auto& s : stems) axes.emplace_back(s), widest = std::max(widest, s.radius);
  const double farthest = std::max(0.3, std::min(near_reach_m, options.crown_radius));
  const AxisGrid grid(axes, farthest + widest);
  const auto& positions = points.positions();
  const auto& heights = points.values<float>(arrays::height_above_ground);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1 << 16), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) {
      if (!(heights[i] >= static_cast<float>(lowest_point_m)) || !positions[i].allFinite()) continue;
      const Eigen::Vector3d p = positions[i].template cast<double>();
      // Shrubs below are not the tree's: the reach opens from near the bark at the base to the crown radius.
      const double opened = std::clamp(static_cast<double>(heights[i]) / options.search_top, 0.0, 1.0);
      const double reach = 0.3 + (farthest - 0.3) * opened;
      double best = std::numeric_limits<double>::infinity();
      const Stem* owner = nullptr;
      for (const auto k : grid.near(p.x(), p.y())) {
        const double d = (p.head<2>() - axes[k].at(p.z())).norm() - axes[k].radius;
        if (d < best && d <= reach) best = d, owner = axes[k].stem;
      }
      if (!owner) continue;
      labels.tree_id[i] = owner->id;
      if (is_bark(*owner, p, options.bark_tolerance)) labels.stem[i] = 1;
    }
  });
  run.check_cancel();
  return labels;
}

}  // namespace bole::stems
