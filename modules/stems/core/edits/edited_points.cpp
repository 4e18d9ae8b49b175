#include "stems/core/edits/edited_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/arrays.h"

namespace bole::stems {
namespace {

constexpr std::size_t top_points = 5;  // a tree is as high as so many of its points

PointLabels labels_of(const PointCloud& points) {
  return {points.values<std::int32_t>(arrays::tree_id), points.has(arrays::stem)
                                                            ? points.values<std::uint8_t>(arrays::stem)
                                                            : std::vector<std::uint8_t>(points.size(), 0)};
}

bool has_id(const std::vector<TreePlace>& trees, std::int32_t id) {
  return std::ranges::any_of(trees, [&](const TreePlace& tree) { return tree.id == id; });
}

// Height above ground that top_points points of the tree reach; NaN for fewer.
double height_of_points(const PointCloud& points, const PointLabels& labels, std::int32_t id) {
  if (!points.has(arrays::height_above_ground)) return std::nan("");
  const auto& all = points.values<float>(arrays::height_above_ground);
  std::vector<float> heights;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (labels.tree_id[i] == id && std::isfinite(all[i])) heights.push_back(all[i]);
  if (heights.size() < top_points) return std::nan("");
  std::ranges::nth_element(heights, heights.begin() + (top_points - 1), std::greater<>());
  return static_cast<double>(heights[top_points - 1]);
}

void set_heights(const PointCloud& points, const PointLabels& labels, const std::vector<GivenPoints>& given,
                 const std::vector<TreePlace>& measured, TableRows& stems) {
  for (std::size_t row = 0; row < stems.size(); ++row) {
    const auto id = static_cast<std::int32_t>(stems.integer(row, "tree_id"));
    const bool gets = std::ranges::any_of(given, [&](const GivenPoints& g) { return g.tree == id && g.points > 0; });
    if (!gets || has_id(measured, id) || stems.integer(row, "height_seen") != 0) continue;
    const double height_m = height_of_points(points, labels, id);
    if (std::isnan(height_m)) continue;
    stems.want_numbers("height_m");
    stems.set(row, "height_m", height_m);
    stems.set(row, "height_lower_bound_m", height_m);
    stems.set(row, "height_seen", std::int64_t{1});
    stems.set(row, "top", "of points given by hand");
  }
}

// Why an edit changes nothing; empty where it does, or where its tree is gone by another edit.
std::string conflict_of(const PointEdit& edit, std::int64_t held, const GivenPoints& given,
                        const std::vector<TreePlace>& measured, const std::vector<TreePlace>& now) {
  if (held == 0) return "no point lies in its selection";
  const auto missing = [&](const Eigen::Vector2d& at) -> std::string {
    if (tree_at(now, at) || tree_at(measured, at)) return {};
    return fmt::format("no tree for certain within {:g} m of ({:.2f}, {:.2f}): add it, or make the edit again",
                       tree_reach_m, at.x(), at.y());
  };
  if (edit.gives_class()) return {};
  if (edit.action == PointEdit::Action::to_tree)
    if (auto why = missing(edit.tree); !why.empty()) return why;
  if (edit.only_tree)
    if (auto why = missing(*edit.only_tree); !why.empty()) return why;
  return given.tree && given.points == 0 ? "no point of its selection meets its condition" : "";
}

void put_in_log(const Table& table, std::size_t i, const GivenPoints& given, const std::string& conflict,
                TableRows& log) {
  const auto row = log.add();
  log.set(row, "edit", table.integers("edit")[i]);
  log.set(row, "tree_id", std::int64_t{given.tree.value_or(0)});
  log.set(row, "x_m", table.numbers("x_m")[i]);
  log.set(row, "y_m", table.numbers("y_m")[i]);
  for (const char* text : {"action", "author", "time", "reason"}) log.set(row, text, table.texts(text)[i]);
  log.set(row, "outcome", std::string(conflict.empty() ? "applied" : "conflict"));
  const auto points = given.tree ? given.points : table.integers("points")[i];
  log.set(row, "message", conflict.empty() ? fmt::format("{} points", points) : conflict);
}

}  // namespace

std::vector<TreePlace> places_of(const TableRows& stems) {
  std::vector<TreePlace> out;
  for (std::size_t row = 0; row < stems.size(); ++row)
    out.push_back({static_cast<std::int32_t>(stems.integer(row, "tree_id")),
                   {stems.number(row, "x_m"), stems.number(row, "y_m")}});
  return out;
}

PointCloud give_edited_points(const PointCloud& points, const Table& point_edits,
                              const std::vector<TreePlace>& measured, TableRows& stems, TableRows& log, Report& report,
                              const Run& run) {
  const auto edits = point_edits_in(point_edits);
  if (edits.empty()) return points;
  const auto now = places_of(stems);
  auto labels = labels_of(points);
  const auto given = give_points(points, edits, now, labels, run);
  set_heights(points, labels, given, measured, stems);
  const auto held = point_edits.integers("points");
  std::int64_t conflicts = 0;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto conflict = conflict_of(edits[i], held[i], given[i], measured, now);
    put_in_log(point_edits, i, given[i], conflict, log);
    if (conflict.empty()) continue;
    ++conflicts;
    report.warn(
        fmt::format("edit {} of points ({}) is not applied: {}", i + 1, action_name(edits[i].action), conflict));
  }
  report.counts["point_edits"] = static_cast<std::int64_t>(edits.size());
  report.counts["point_conflicts"] = conflicts;
  PointCloud out = points;
  out.set_column(arrays::tree_id, std::move(labels.tree_id));
  if (points.has(arrays::stem)) out.set_column(arrays::stem, std::move(labels.stem));
  return out;
}

}  // namespace bole::stems
