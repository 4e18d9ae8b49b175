#include "render/charts/slice_panels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "render/charts/columns.h"

namespace bole::render {
namespace {

class StemGrid {
 public:
  StemGrid(const std::vector<Eigen::Vector2d>& centres, const std::vector<double>& reach)
      : centres_(centres), reach_(reach) {
    for (const double r : reach) cell_ = std::max(cell_, r);
    for (std::size_t i = 0; i < centres.size(); ++i)
      if (centres[i].allFinite()) cells_[key(cell(centres[i].x()), cell(centres[i].y()))].push_back(i);
  }

  template <class Visit>
  void near(const Eigen::Vector2d& p, Visit visit) const {
    const auto cx = cell(p.x()), cy = cell(p.y());
    for (std::int64_t x = cx - 1; x <= cx + 1; ++x)
      for (std::int64_t y = cy - 1; y <= cy + 1; ++y)
        if (const auto it = cells_.find(key(x, y)); it != cells_.end())
          for (const auto i : it->second)
            if ((centres_[i] - p).cwiseAbs().maxCoeff() <= reach_[i]) visit(i);
  }

 private:
  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
  }
  const std::vector<Eigen::Vector2d>& centres_;
  const std::vector<double>& reach_;
  double cell_ = 0.05;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace

double slice_reach_m(double dbh_m) { return 0.62 * dbh_m + 0.035; }

std::vector<SlicePanel> slice_panels(const Table& stems, const PointCloud& slice, int max_points) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = numbers_or_nan(stems, "dbh_cm"),
             lo = numbers_or_nan(stems, "dbh_lo_cm"), hi = numbers_or_nan(stems, "dbh_hi_cm");
  const auto quality = texts_or_empty(stems, "quality"), reasons = texts_or_empty(stems, "reasons");
  std::vector<SlicePanel> panels(stems.rows());
  std::vector<Eigen::Vector2d> centres;
  std::vector<double> reach;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i] = {stems.has("tree_id") ? stems.text("tree_id", i, 0) : std::to_string(i + 1),
                 quality[i],
                 reasons[i],
                 std::isfinite(dbh[i]) ? dbh[i] / 100 : 0.2,
                 lo[i] / 100,
                 hi[i] / 100,
                 0,
                 {}};
    centres.emplace_back(x[i], y[i]);
    reach.push_back(slice_reach_m(panels[i].dbh_m));
  }
  const StemGrid grid(centres, reach);
  const auto* passes = slice.has(arrays::pass) ? &slice.values<std::int32_t>(arrays::pass) : nullptr;
  for (std::size_t k = 0; k < slice.size(); ++k) {
    const Eigen::Vector2d p = slice.position(k).head<2>();
    grid.near(p, [&](std::size_t i) {
      panels[i].points.push_back({(p - centres[i]).cast<float>(), passes != nullptr ? (*passes)[k] : 0});
    });
  }
  for (auto& panel : panels) {
    panel.found = panel.points.size();
    const auto most = static_cast<std::size_t>(max_points);
    if (panel.found <= most) continue;
    for (std::size_t k = 0; k < most; ++k) panel.points[k] = panel.points[k * panel.found / most];
    panel.points.resize(most);
  }
  return panels;
}

}  // namespace bole::render
