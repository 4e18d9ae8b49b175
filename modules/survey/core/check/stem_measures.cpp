#include "survey/core/check/stem_measures.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/no_number.h"
#include "base/statistics.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"

namespace bole::survey {
namespace {

constexpr double low_m = 0.9, high_m = 1.7, reach_m = 0.25, wall_reach_m = 0.10;
constexpr std::size_t min_wall_points = 30, min_pass_points = 50, max_stem_points = 20000;
constexpr std::size_t check_every = std::size_t{1} << 20;
constexpr double usual_radius_m = 0.1;

struct BarkPoint {
  Eigen::Vector2d from_axis;
  std::int32_t pass = 0;
};

// The axis of a stem of a known radius from the points of one pass: Gauss-Newton with Tukey's weights. Where the pass
// saw one side only, nothing tells where the axis lies across it, and a weak tie to the table's place decides.
struct PassAxis {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  // per point: the share of the points that see each direction
};

PassAxis pass_axis(const std::vector<Eigen::Vector2d>& points, double radius_m) {
  constexpr double tie = 0.02, cut_m = 0.12;
  PassAxis axis;
  for (int iteration = 0; iteration < 15; ++iteration) {
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    double sum = 0;
    // A wide gate first, so that a pass that is displaced by some decimetres is not taken for something else.
    const double cut = iteration < 5 ? reach_m : cut_m;
    for (const auto& p : points) {
      const Eigen::Vector2d d = p - axis.shift;
      const double distance = d.norm();
      if (distance < 1e-6) continue;
      const double r = distance - radius_m, u = r / cut;
      if (std::abs(u) >= 1) continue;
      const double w = (1 - u * u) * (1 - u * u);
      const Eigen::Vector2d n = d / distance;
      a += w * n * n.transpose();
      b += w * r * n;
      sum += w;
    }
    if (sum <= 0) return axis;
    axis.information = a / sum;
    a += tie * sum * Eigen::Matrix2d::Identity();
    b -= tie * sum * axis.shift;
    const Eigen::Vector2d step = a.ldlt().solve(b);
    axis.shift += step;
    if (step.norm() < 1e-5) break;
  }
  return axis;
}

// The distance between two axes along the directions that both passes saw.
double distance_between(const PassAxis& a, const PassAxis& b) {
  const Eigen::Matrix2d both = a.information * b.information;
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(both, Eigen::ComputeFullV);
  const Eigen::Vector2d d = b.shift - a.shift;
  double squared = 0;
  constexpr double well_seen = 0.04;  // of 0.25 for points all round in both
  for (int k = 0; k < 2; ++k)
    if (svd.singularValues()[k] > well_seen) squared += std::pow(svd.matrixV().col(k).dot(d), 2);
  return std::sqrt(squared);
}

double wall_of(const std::vector<BarkPoint>& points, double radius_m) {
  std::vector<Eigen::Vector2d> all;
  for (const auto& p : points) all.push_back(p.from_axis);
  const auto axis = pass_axis(all, radius_m);
  std::vector<double> residuals;
  for (const auto& p : all)
    if (const double r = (p - axis.shift).norm() - radius_m; std::abs(r) < wall_reach_m) residuals.push_back(r);
  if (residuals.size() < min_wall_points) return no_number;
  const double middle = median(residuals);
  for (double& r : residuals) r = std::abs(r - middle);
  constexpr double normal = 1.4826;  // standard deviations in a median absolute deviation
  return 100 * normal * median(residuals);
}

void measure_passes(const std::vector<BarkPoint>& points, double radius_m, StemMeasure& stem) {
  std::map<std::int32_t, std::vector<Eigen::Vector2d>> by_pass;
  for (const auto& p : points)
    if (std::abs(p.from_axis.norm() - radius_m) < reach_m) by_pass[p.pass].push_back(p.from_axis);
  std::vector<PassAxis> axes;
  for (const auto& [pass, of_pass] : by_pass) {
    if (of_pass.size() < min_pass_points) continue;
    stem.passes.insert(pass);
    axes.push_back(pass_axis(of_pass, radius_m));
  }
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t j = i + 1; j < axes.size(); ++j)
      stem.pass_spread_cm = std::fmax(stem.pass_spread_cm, 100 * distance_between(axes[i], axes[j]));
}

}  // namespace

std::vector<StemMeasure> measure_stems(const CheckInputs& in, const CheckGrid& grid, const std::vector<float>& heights,
                                       const std::vector<std::int32_t>& passes, const Run& run) {
  std::vector<StemMeasure> stems;
  if (in.stems == nullptr) return stems;
  const auto x = in.stems->numbers("x_m"), y = in.stems->numbers("y_m"), dbh = numbers_or_nan(*in.stems, "dbh_cm");
  std::vector<std::vector<std::size_t>> near(grid.cells.size());
  for (const auto row : kept_rows(*in.stems)) {
    const Eigen::Vector2d at(x[row], y[row]);
    if (!at.allFinite() || !grid.index(at)) continue;
    StemMeasure stem{.row = row,
                     .at = at,
                     .dbh_cm = dbh[row],
                     .points = 0,
                     .wall_cm = no_number,
                     .pass_spread_cm = no_number,
                     .passes = {}};
    const double radius = std::isfinite(dbh[row]) ? dbh[row] / 200 : usual_radius_m, reach = radius + reach_m;
    std::set<std::size_t> cells;
    const int steps = static_cast<int>(std::ceil(2 * reach / grid.cell_m)) + 1;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j)
        if (const auto c = grid.index(at + reach * Eigen::Vector2d(2.0 * i / steps - 1, 2.0 * j / steps - 1)))
          cells.insert(*c);
    for (const auto c : cells) near[c].push_back(stems.size());
    stems.push_back(std::move(stem));
  }
  if (in.points == nullptr || heights.empty()) return stems;
  std::vector<std::vector<BarkPoint>> bark(stems.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i % check_every == 0) run.check_cancel();
    if (!(heights[i] > low_m && heights[i] < high_m)) continue;
    const Eigen::Vector2d p = in.points->position(i).head<2>();
    const auto c = grid.index(p);
    if (!c) continue;
    for (const auto s : near[*c]) {
      const Eigen::Vector2d d = p - stems[s].at;
      const double radius = std::isfinite(stems[s].dbh_cm) ? stems[s].dbh_cm / 200 : usual_radius_m;
      if (d.norm() < radius + reach_m && bark[s].size() < max_stem_points)
        bark[s].push_back({d, passes.empty() ? 0 : passes[i]});
    }
  }
  for (std::size_t s = 0; s < stems.size(); ++s) {
    run.check_cancel();
    const double radius = std::isfinite(stems[s].dbh_cm) ? stems[s].dbh_cm / 200 : usual_radius_m;
    stems[s].points = static_cast<std::size_t>(std::ranges::count_if(
        bark[s], [&](const BarkPoint& p) { return std::abs(p.from_axis.norm() - radius) < wall_reach_m; }));
    if (!std::isfinite(stems[s].dbh_cm)) continue;
    stems[s].wall_cm = wall_of(bark[s], radius);
    if (!passes.empty()) measure_passes(bark[s], radius, stems[s]);
  }
  return stems;
}

}  // namespace bole::survey
