#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "cloud/stem_axes.h"
#include "cloud/table_columns.h"
#include "survey/core/check/stem_measures.h"
#include "survey/core/post_centre.h"

namespace bole::survey {
namespace {

constexpr double stem_low_m = 0.3, stem_high_m = 5, max_lean = 20 * rad_per_deg;
constexpr double slab_low_m = 1.0, slab_high_m = 1.6, slab_reach_m = 0.4, max_radius_m = 0.6;
constexpr double explained_m = 0.35;  // beside the bark of a stem of the table: its fork, its branch, its other half
constexpr std::size_t points_between_checks = std::size_t{1} << 20, min_points = 40;

// The points of the region between two heights, with the height in the place of z, so that slopes do no harm.
PointCloud standing_points(const CheckInputs& in, const CheckGrid& grid, const std::vector<float>& heights,
                           const Run& run) {
  PointCloud::Positions kept;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i % points_between_checks == 0) run.check_cancel();
    if (!(heights[i] > stem_low_m && heights[i] < stem_high_m)) continue;
    const Eigen::Vector2d p = in.points->position(i).head<2>() - grid.centre;
    if (grid.index(p + grid.centre))
      kept.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), heights[i]);
  }
  return PointCloud(std::move(kept));
}

// Of every stem of the table, rejected ones too: a person who rejected one has seen it.
bool explained(const Table& stems, const Eigen::Vector2d& at) {
  const auto x = numbers_or_nan(stems, "x_m"), y = numbers_or_nan(stems, "y_m"), dbh = numbers_or_nan(stems, "dbh_cm");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double radius = std::isfinite(dbh[i]) ? dbh[i] / 200 : 0.1;
    if ((Eigen::Vector2d(x[i], y[i]) - at).norm() < radius + explained_m) return true;
  }
  return false;
}

}  // namespace

std::vector<MissedStem> missed_stems(const CheckInputs& in, const CheckGrid& grid, const std::vector<float>& heights,
                                     double min_dbh_cm, const Run& run) {
  std::vector<MissedStem> missed;
  if (in.stems == nullptr || in.points == nullptr || heights.empty()) return missed;
  const auto standing = standing_points(in, grid, heights, run);
  if (standing.empty()) return missed;
  constexpr double breast_height_m = 1.3, below_m = 1.0, above_m = 2.0;
  for (const auto& axis : find_stem_axes(thinned(standing, run), Eigen::Vector3d::UnitZ(), max_lean, run)) {
    const double half = axis.length_m / 2 * axis.direction.z();
    if (axis.middle.z() - half > below_m || axis.middle.z() + half < above_m) continue;
    const Eigen::Vector3d breast =
        axis.middle + (breast_height_m - axis.middle.z()) / axis.direction.z() * axis.direction;
    const Eigen::Vector2d guess = breast.head<2>() + grid.centre;
    const auto cell = grid.index(guess);
    if (!cell || !grid.cells[*cell].inside || explained(*in.stems, guess)) continue;
    std::vector<Eigen::Vector2d> slab;
    for (const auto& p : standing.positions())
      if (p.z() > slab_low_m && p.z() < slab_high_m)
        if (const Eigen::Vector2d q = p.head<2>().cast<double>(); (q - breast.head<2>()).norm() < slab_reach_m)
          slab.push_back(q);
    if (slab.size() < min_points) continue;
    const auto fit = fit_post(slab, {}, max_radius_m);
    if (!fit.valid || 200 * fit.radius_m < min_dbh_cm) continue;
    const Eigen::Vector2d at = fit.centre + grid.centre;
    if ((at - guess).norm() > slab_reach_m || explained(*in.stems, at)) continue;
    missed.push_back({at, 200 * fit.radius_m});
  }
  return missed;
}

}  // namespace bole::survey
