#include "cloud/point_cloud.h"

#include <cmath>

#include "base/option.h"
#include "cloud/axes_choice.h"
#include "cloud/large_cloud.h"

namespace bole {
inline namespace cloud {

std::size_t column_size(const Column& column) {
  return std::visit([](const auto& v) { return v.size(); }, column);
}

ArrayType column_type(const Column& column) { return static_cast<ArrayType>(column.index()); }

double column_value(const Column& column, std::size_t i) {
  return std::visit([i](const auto& v) { return static_cast<double>(v[i]); }, column);
}

Column make_column(ArrayType type, std::size_t size) {
  switch (type) {
    case ArrayType::uint8:
      return std::vector<std::uint8_t>(size);
    case ArrayType::uint16:
      return std::vector<std::uint16_t>(size);
    case ArrayType::int32:
      return std::vector<std::int32_t>(size);
    case ArrayType::float32:
      return std::vector<float>(size);
    case ArrayType::float64:
      break;
  }
  return std::vector<double>(size);
}

std::string_view axes_name(Axes axes) { return choice_name(axes); }

Axes axes_from_name(std::string_view name) {
  constexpr auto names = choice_names(Axes{});
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<Axes>(i);
  throw bad_input("axes '" + std::string(name) + "'", "unknown, sensor, map, plot or global");
}

const Column& PointCloud::column(std::string_view name) const {
  const auto it = columns_.find(name);
  if (it != columns_.end()) return *it->second;
  std::string list;
  for (const auto& [n, c] : columns_) list += (list.empty() ? "" : ", ") + n;
  throw bad_input("the cloud has no array '" + std::string(name) + "'", "one of that name",
                  "It has: " + (list.empty() ? "none" : list));
}

void PointCloud::set_column(std::string_view name, Column column) {
  share_column(name, std::make_shared<const Column>(std::move(column)));
}

void PointCloud::share_column(std::string_view name, std::shared_ptr<const Column> column) {
  if (column_size(*column) != size())
    throw failure("array '" + std::string(name) + "' has " + std::to_string(column_size(*column)) + " values",
                  std::to_string(size()) + ", one per point");
  columns_.insert_or_assign(std::string(name), std::move(column));
}

void PointCloud::remove_column(std::string_view name) {
  const auto it = columns_.find(name);
  if (it != columns_.end()) columns_.erase(it);
}

PointCloud PointCloud::subset(const std::vector<std::uint32_t>& indices) const {
  PointCloud out;
  out.origin = origin, out.axes = axes, out.crs_wkt = crs_wkt, out.scale = scale, out.facts = facts;
  Positions kept;
  kept.reserve(indices.size());
  for (const auto i : indices) kept.push_back((*positions_)[i]);
  out.set_positions(std::move(kept));
  for (const auto& [name, column] : columns_) {
    out.set_column(name, std::visit(
                             [&](const auto& values) -> Column {
                               std::decay_t<decltype(values)> picked;
                               picked.reserve(indices.size());
                               for (const auto i : indices) picked.push_back(values[i]);
                               return picked;
                             },
                             *column));
    leave_memory(*column, 0, size());  // a few points from everywhere bring in all of a column that lies on file
  }
  return out;
}

Eigen::Vector3d exact_position(const PointCloud& cloud, std::size_t i) {
  Eigen::Vector3d out = cloud.position(i);
  for (int k = 0; k < 3; ++k) {
    const double step = cloud.scale[k];
    if (step > 0) out[k] = cloud.origin[k] + std::round(static_cast<double>(cloud.positions()[i][k]) / step) * step;
  }
  return out;
}

}  // namespace cloud
}  // namespace bole
