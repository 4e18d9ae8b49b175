// A point cloud: float32 offsets from one double-precision origin, and named per-point columns.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/arrays.h"
#include "base/error.h"
#include "cloud/facts.h"

namespace bole {
inline namespace cloud {

// The types of ArrayType, in its order.
using Column = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<std::int32_t>,
                            std::vector<float>, std::vector<double>>;

std::size_t column_size(const Column& column);
ArrayType column_type(const Column& column);
double column_value(const Column& column, std::size_t i);
Column make_column(ArrayType type, std::size_t size);

// Which axes the coordinates are in.
//   sensor: x forward at azimuth 0, y left, z up.     map: where the SLAM started, z roughly up.
//   plot: x east, y north, z up, origin at the plot centre on the ground.     global: projected coordinates of a CRS.
//   unknown: as the file has it.
enum class Axes { unknown, sensor, map, plot, global };
std::string_view axes_name(Axes axes);
Axes axes_from_name(std::string_view name);  // throws Error{bad_input}

// Copies are cheap: positions and columns are shared between copies and never changed once shared, so a stage that adds
// a column to a cloud of 20 M points does not copy the points.
class PointCloud {
 public:
  using Positions = std::vector<Eigen::Vector3f>;

  PointCloud() : positions_(std::make_shared<const Positions>()) {}
  explicit PointCloud(Positions positions, const Eigen::Vector3d& cloud_origin = Eigen::Vector3d::Zero())
      : origin(cloud_origin), positions_(std::make_shared<const Positions>(std::move(positions))) {}

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // coordinate = origin + offset, metres
  Axes axes = Axes::unknown;
  std::string crs_wkt;                              // of Axes::global; empty when not known
  Eigen::Vector3d scale = Eigen::Vector3d::Zero();  // LAS coordinate quantum of the source, metres; zero when none

  Facts facts;  // what is known of the data as a whole

  std::size_t size() const { return positions_->size(); }
  bool empty() const { return positions_->empty(); }
  const Positions& positions() const { return *positions_; }  // offsets from `origin`
  Eigen::Vector3d position(std::size_t i) const { return origin + (*positions_)[i].cast<double>(); }
  void set_positions(Positions positions) { positions_ = std::make_shared<const Positions>(std::move(positions)); }
  void share_positions(std::shared_ptr<const Positions> positions) { positions_ = std::move(positions); }
  const std::shared_ptr<const Positions>& shared_positions() const { return positions_; }

  const std::map<std::string, std::shared_ptr<const Column>, std::less<>>& columns() const { return columns_; }
  bool has(std::string_view name) const { return columns_.find(name) != columns_.end(); }
  bool has(const ArrayInfo& info) const { return has(info.name); }

  // The column, or Error{bad_input} that lists what there is.
  const Column& column(std::string_view name) const;

  // The values of a column of a known type: cloud.values<float>(arrays::range). Throws when absent or of another type.
  template <class T>
  const std::vector<T>& values(std::string_view name) const {
    if (const auto* v = std::get_if<std::vector<T>>(&column(name))) return *v;
    throw bad_input(
        "array '" + std::string(name) + "' has type " + std::string(array_type_name(column_type(column(name)))),
        "another type");
  }
  template <class T>
  const std::vector<T>& values(const ArrayInfo& info) const {
    return values<T>(info.name);
  }

  // Throws Error{failed} when the length differs from size().
  void set_column(std::string_view name, Column column);
  void set_column(const ArrayInfo& info, Column column) { set_column(info.name, std::move(column)); }
  void share_column(std::string_view name, std::shared_ptr<const Column> column);
  void remove_column(std::string_view name);

  // The points of `indices` in that order, with all columns.
  PointCloud subset(const std::vector<std::uint32_t>& indices) const;

 private:
  std::shared_ptr<const Positions> positions_;
  std::map<std::string, std::shared_ptr<const Column>, std::less<>> columns_;
};

// The coordinate that the source file holds for a point: its offset rounded to the grid of `scale`. position() where
// the cloud has no grid. Exact up to 2^23 steps from the origin, where a float32 offset still tells neighbouring steps
// apart.
Eigen::Vector3d exact_position(const PointCloud& cloud, std::size_t i);

}  // namespace cloud
}  // namespace bole
