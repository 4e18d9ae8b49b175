// Point records from the columns of a cloud: the reverse of las_columns.h.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "io/core/las/las_extra_bytes.h"
#include "io/core/las/las_format.h"

namespace bole::io::las {

// coordinate = integer * scale + offset.
struct Grid {
  Eigen::Vector3d scale = Eigen::Vector3d::Constant(0.001), offset = Eigen::Vector3d::Zero();
};

// The grid of the cloud (or one of `scale_m`) with a whole number of kilometres or metres as the offset where the grid
// allows one.
Grid choose_grid(const PointCloud& cloud, double scale_m);

// How the records of a file lie in memory.
struct RecordForm {
  int point_format = 6;
  std::size_t record_length = 30;
  Grid grid;
  bool gps_time = true;  // whether the field of the time holds GPS times

  unsigned return_number(const std::uint8_t* record) const {
    return record[field::returns] & (point_layout(point_format).extended ? 15U : 7U);
  }
  bool holds_time() const { return gps_time && point_layout(point_format).time >= 0; }
  double time(const std::uint8_t* record) const {
    return las::load<double>(record + static_cast<std::size_t>(point_layout(point_format).time));
  }
};

// Points of a cloud that follow one another, or that a list puts in another order.
struct PointList {
  std::size_t first = 0, count = 0;
  const std::uint32_t* order = nullptr;
  std::size_t operator[](std::size_t i) const { return order == nullptr ? first + i : order[first + i]; }
};

// What the fields of a record could not hold.
struct RecordLosses {
  std::map<std::string, std::size_t, std::less<>> held;     // clamped values, by column
  std::map<std::string, std::size_t, std::less<>> rounded;  // values that lost a fraction, by column
  void add(const RecordLosses& other);
};

class RecordEncoder {
 public:
  // `legacy`: formats 1 and 3, else 6 to 8. `gps_time`: the times of the cloud are GPS time; those of another clock go
  // into extra bytes, since the field would declare them as GPS time.
  RecordEncoder(const PointCloud& cloud, const Grid& grid, bool legacy, bool extra_bytes, bool gps_time);

  int point_format() const { return format_; }
  std::size_t record_length() const { return record_length_; }
  const Grid& grid() const { return grid_; }
  const std::vector<ExtraDimension>& dimensions() const { return dimensions_; }

  // Records of the points into zeroed memory; several threads may do so at once. Throws Error{bad_input} for
  // coordinates that are not finite or off the grid's reach.
  void encode(const PointList& points, std::uint8_t* records, RecordLosses& losses) const;

  // The place of a point on the grid. Throws as encode().
  std::array<std::int32_t, 3> steps(std::size_t point) const;

  RecordForm form() const { return {format_, record_length_, grid_, gps_time_}; }

  // Columns without a place in the file and values that did not fit their field, one line per column.
  std::vector<std::string> warnings(const RecordLosses& losses) const;

 private:
  void encode_returns(const PointList& points, std::uint8_t* records, RecordLosses& losses) const;
  void encode_flags(const PointList& points, std::uint8_t* records, RecordLosses& losses) const;
  void encode_extra(const PointList& points, std::uint8_t* records) const;
  template <class T>
  void encode_field(const char* name, std::size_t place, const PointList& points, std::uint8_t* records,
                    RecordLosses& losses, double per_unit = 1, double low = 0, double high = 0) const;
  void place_origin();

  const PointCloud& cloud_;
  Grid grid_;
  bool legacy_;
  bool gps_time_;
  int format_ = 6;
  PointLayout layout_;
  std::size_t record_length_ = 0;
  std::vector<ExtraDimension> dimensions_;
  std::vector<std::string> left_out_;  // columns
  std::array<double, 3> origin_steps_{};
  std::array<bool, 3> on_grid_{};
};

}  // namespace bole::io::las
