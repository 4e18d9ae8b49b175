// Point records from the columns of a cloud: the reverse of las_columns.h.
#pragma once

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

class RecordEncoder {
 public:
  // `legacy`: formats 1 and 3, else 6 to 8. `gps_time`: the times of the cloud are GPS time; those of another clock go
  // into extra bytes, since the field would declare them as GPS time.
  RecordEncoder(const PointCloud& cloud, const Grid& grid, bool legacy, bool extra_bytes, bool gps_time);

  int point_format() const { return format_; }
  std::size_t record_length() const { return record_length_; }
  const Grid& grid() const { return grid_; }
  const std::vector<ExtraDimension>& dimensions() const { return dimensions_; }

  // Records of the points [first, first + count) into zeroed memory. Throws Error{bad_input} for coordinates that are
  // not finite or off the grid's reach.
  void encode(std::size_t first, std::size_t count, std::uint8_t* records);

  unsigned return_number(const std::uint8_t* record) const {
    return record[field::returns] & (layout_.extended ? 15U : 7U);
  }

  // Values that did not fit their field, one line per column.
  std::vector<std::string> warnings() const;

 private:
  void encode_positions(std::size_t first, std::size_t count, std::uint8_t* records) const;
  void encode_returns(std::size_t first, std::size_t count, std::uint8_t* records);
  void encode_flags(std::size_t first, std::size_t count, std::uint8_t* records);
  void encode_extra(std::size_t first, std::size_t count, std::uint8_t* records) const;
  double held(std::string_view name, double value, double low, double high);
  template <class T>
  void encode_field(const char* name, std::size_t place, std::size_t first, std::size_t count, std::uint8_t* records,
                    double per_unit = 1, double low = 0, double high = 0);

  const PointCloud& cloud_;
  Grid grid_;
  bool legacy_;
  bool gps_time_;
  int format_ = 6;
  PointLayout layout_;
  std::size_t record_length_ = 0;
  std::vector<ExtraDimension> dimensions_;
  std::map<std::string, std::size_t, std::less<>> held_;     // clamped values, by column
  std::map<std::string, std::size_t, std::less<>> rounded_;  // values that lost a fraction, by column
};

}  // namespace bole::io::las
