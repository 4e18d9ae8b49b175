#include "render/maps/stem_map_content.h"

#include <algorithm>
#include <limits>

#include "render/charts/columns.h"

namespace bole::render {
namespace {

void take_stems(const Table& table, StemMapContent& content) {
  const auto x = table.numbers("x_m"), y = table.numbers("y_m"), dbh = numbers_or_nan(table, "dbh_cm");
  const auto quality = texts_or_empty(table, "quality");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    content.stems.push_back({{x[i], y[i]},
                             std::isfinite(dbh[i]) ? dbh[i] / 100 : 0.1,
                             table.has("tree_id") ? table.text("tree_id", i, 0) : std::to_string(i + 1),
                             quality[i],
                             quality_color(quality[i])});
  }
}

void take_matches(const Table& table, StemMapContent& content) {
  content.compared = true;
  const auto kind = texts_or_empty(table, "kind");
  const auto x = numbers_or_nan(table, "x_m"), y = numbers_or_nan(table, "y_m"),
             ref_x = numbers_or_nan(table, "ref_x_m"), ref_y = numbers_or_nan(table, "ref_y_m");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (kind[i] == "missed" && std::isfinite(ref_x[i]) && std::isfinite(ref_y[i]))
      content.missed.push_back({{ref_x[i], ref_y[i]}, table.has("ref_id") ? table.text("ref_id", i, 0) : ""});
    if (kind[i] != "false") continue;
    for (auto& stem : content.stems)
      if ((stem.at - Eigen::Vector2d(x[i], y[i])).norm() < 1e-3) stem.is_false = true;
  }
}

// A path with a point at most every `step_m`.
std::vector<Eigen::Vector2d> thinned_path(const Trajectory& trajectory, double step_m) {
  std::vector<Eigen::Vector2d> path;
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector2d p = pose.T_target_sensor.translation().head<2>();
    if (path.empty() || (p - path.back()).norm() >= step_m) path.push_back(p);
  }
  return path;
}

}  // namespace

StemMapContent stem_map_content(const StemMapData& data) {
  StemMapContent content;
  content.north_known = data.north_known;
  content.outline = data.area.outline();
  if (data.stems != nullptr) take_stems(*data.stems, content);
  if (data.matches != nullptr) take_matches(*data.matches, content);
  if (data.trajectory != nullptr) content.path = thinned_path(*data.trajectory, 0.05);
  if (data.targets != nullptr) {
    const auto x = data.targets->numbers("x_m"), y = data.targets->numbers("y_m");
    const auto name = texts_or_empty(*data.targets, "name");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (std::isfinite(x[i]) && std::isfinite(y[i])) content.targets.push_back({{x[i], y[i]}, name[i]});
  }
  return content;
}

Frame stem_map_frame(const StemMapContent& content, const Eigen::Vector2d& corner, double width_mm) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lo(inf, inf), hi(-inf, -inf);
  const auto include = [&](const Eigen::Vector2d& p) { lo = lo.cwiseMin(p), hi = hi.cwiseMax(p); };
  for (const auto& p : content.outline) include(p);
  if (content.outline.empty())
    for (const auto& s : content.stems) include(s.at);
  for (const auto& m : content.missed) include(m.at);
  for (const auto& m : content.targets) include(m.at);
  if (content.stems.empty() && content.outline.empty())
    for (const auto& p : content.path) include(p);
  if (!(lo.x() <= hi.x())) lo = {-1, -1}, hi = {1, 1};
  const double pad = (content.outline.empty() ? 0.03 : 0.06) * std::max((hi - lo).maxCoeff(), 2.0) + 0.3;
  lo.array() -= pad;
  hi.array() += pad;
  // A long strip is widened, so that the sheet keeps a readable shape.
  const double min_height = 0.3 * (hi.x() - lo.x()), max_height = 1.35 * (hi.x() - lo.x());
  const double middle = (lo.y() + hi.y()) / 2;
  if (hi.y() - lo.y() < min_height) lo.y() = middle - min_height / 2, hi.y() = middle + min_height / 2;
  if (hi.y() - lo.y() > max_height) {
    const double half = (hi.y() - lo.y()) / 1.35 / 2, x = (lo.x() + hi.x()) / 2;
    lo.x() = x - half;
    hi.x() = x + half;
  }
  const double h = width_mm * (hi.y() - lo.y()) / (hi.x() - lo.x());
  return {{corner.x(), corner.y(), corner.x() + width_mm, corner.y() + h}, {lo.x(), hi.x()}, {lo.y(), hi.y()}};
}

}  // namespace bole::render
