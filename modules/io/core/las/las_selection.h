// Point records within bounds, collected on their way into the columns.
#pragma once

#include <span>
#include <vector>

#include "io/core/clouds/cloud_bounds.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_info.h"

namespace bole::io::las {

class RecordSelection {
 public:
  RecordSelection(const CloudBounds& bounds, const LasInfo& info)
      : bounds_(with_edges(bounds, info.scale)),
        scale_(info.scale),
        offset_(info.offset),
        stride_(static_cast<std::size_t>(info.record_length)) {}

  // Appends those of `count` records that lie within the bounds.
  void collect(const std::uint8_t* records, std::size_t count, std::vector<std::uint8_t>& kept) const;

  // Decodes collected records behind the `placed` points that the builder has. Returns the number of points it has
  // then.
  std::uint64_t append(ColumnBuilder& builder, std::span<const std::vector<std::uint8_t>> kept, std::uint64_t placed,
                       IntegerBox& box) const;

 private:
  // Offset and step add up to a rounded coordinate: those on an edge are inside all the same.
  static CloudBounds with_edges(const CloudBounds& bounds, const Eigen::Vector3d& scale) {
    constexpr double rounding = 1e-3;  // of a step
    const Eigen::Vector3d margin = rounding * scale.cwiseAbs();
    return {bounds.min - margin, bounds.max + margin};
  }

  CloudBounds bounds_;
  Eigen::Vector3d scale_, offset_;
  std::size_t stride_;
};

}  // namespace bole::io::las
