#include "stems/core/edits/plot_numbers.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/arrays.h"

namespace bole::stems {

NewIds plot_first_ids(const Table& stems, const CountingRule& rule) {
  const auto* ids = std::get_if<std::vector<std::int64_t>>(stems.find("tree_id"));
  if (ids == nullptr) return {};
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  std::vector<std::tuple<int, double, double, std::int64_t>> order;
  for (std::size_t i = 0; i < ids->size(); ++i) {
    const Eigen::Vector2d at(x[i], y[i]);
    const int group = rule.counts(at, dbh[i]) ? 0 : rule.area.contains(at) ? 1 : 2;
    order.emplace_back(group, -y[i], x[i], (*ids)[i]);
  }
  std::ranges::sort(order);
  NewIds all;
  bool changed = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto old_id = std::get<3>(order[i]), new_id = static_cast<std::int64_t>(i) + 1;
    if (!all.emplace(old_id, new_id).second) return {};  // two stems of one id: nobody could tell their points apart
    changed = changed || old_id != new_id;
  }
  return changed ? all : NewIds{};
}

Table renumbered(const Table& table, const NewIds& ids) {
  const auto* column = table.find("tree_id");
  if (ids.empty() || column == nullptr || !std::holds_alternative<std::vector<std::int64_t>>(*column)) return table;
  auto values = std::get<std::vector<std::int64_t>>(*column);
  for (auto& v : values)
    if (const auto it = ids.find(v); it != ids.end()) v = it->second;
  Table out = table;
  out.set("tree_id", std::move(values));
  return out;
}

PointCloud renumbered(const PointCloud& points, const NewIds& ids, const Run& run) {
  if (ids.empty() || !points.has(arrays::tree_id)) return points;
  std::int32_t largest = 0;
  for (const auto& [from, to] : ids) largest = std::max(largest, static_cast<std::int32_t>(from));
  std::vector<std::int32_t> new_id(static_cast<std::size_t>(largest) + 1);
  for (std::size_t i = 0; i < new_id.size(); ++i) {
    const auto it = ids.find(static_cast<std::int64_t>(i));
    new_id[i] = it == ids.end() ? static_cast<std::int32_t>(i) : static_cast<std::int32_t>(it->second);
  }
  auto labels = points.values<std::int32_t>(arrays::tree_id);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, labels.size(), 100'000), [&](const auto& range) {
    if (run.cancelled()) return;
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (labels[i] > 0 && labels[i] <= largest) labels[i] = new_id[static_cast<std::size_t>(labels[i])];
  });
  run.check_cancel();
  PointCloud out = points;
  out.set_column(arrays::tree_id, std::move(labels));
  return out;
}

}  // namespace bole::stems
