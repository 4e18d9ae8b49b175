// Point records turned into the columns of a cloud.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "cloud/point_cloud.h"
#include "io/core/las_extra_bytes.h"
#include "io/core/las_format.h"

namespace bole::las {

// Integer bounding box of coordinates; empty until something was added.
struct IntegerBox {
  std::array<std::int32_t, 3> min{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max(),
                                  std::numeric_limits<std::int32_t>::max()};
  std::array<std::int32_t, 3> max{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min(),
                                  std::numeric_limits<std::int32_t>::min()};
  bool empty() const { return min[0] > max[0]; }
  void add(const IntegerBox& other);
};

class ColumnBuilder {
 public:
  ColumnBuilder(int point_format, int record_length, std::vector<ExtraDimension> dimensions);

  // Room for `count` points; what was decoded stays.
  void resize(std::size_t count);
  std::size_t size() const { return positions_.size(); }

  // Decodes records into the places [first, first + count) and returns their bounding box. Different places may be
  // filled from different threads.
  IntegerBox decode(const std::uint8_t* records, std::size_t count, std::size_t first);

  // The cloud, its origin near the middle of `box` on the grid of the coordinates. Columns that hold nothing but zeros
  // are left out. `*exact` says whether float32 offsets give every coordinate back.
  PointCloud finish(const IntegerBox& box, const Eigen::Vector3d& scale, const Eigen::Vector3d& offset, bool* exact);

 private:
  void finish_flags(PointCloud& cloud);
  void finish_extra(PointCloud& cloud);

  PointLayout layout_;
  std::size_t stride_;
  // Integer coordinates in the bits of the floats, so that the offsets can take their place without a second array.
  PointCloud::Positions positions_;
  std::vector<float> intensity_, scan_angle_;
  std::vector<double> time_;
  std::vector<std::uint8_t> return_number_, number_of_returns_, classification_, user_data_, flags_;
  std::vector<std::uint16_t> point_source_id_, red_, green_, blue_, near_infrared_;
  std::vector<ExtraDimension> dimensions_;
  std::vector<Column> extra_;
};

}  // namespace bole::las
