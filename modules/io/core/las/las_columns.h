// Point records turned into the columns of a cloud.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "base/file_pages.h"
#include "cloud/point_cloud.h"
#include "io/core/las/las_extra_bytes.h"
#include "io/core/las/las_format.h"

namespace bole::io::las {

// Integer bounding box of coordinates; empty until something was added.
struct IntegerBox {
  std::array<std::int32_t, 3> min{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max(),
                                  std::numeric_limits<std::int32_t>::max()};
  std::array<std::int32_t, 3> max{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min(),
                                  std::numeric_limits<std::int32_t>::min()};
  bool empty() const { return min[0] > max[0]; }
  void add(const IntegerBox& other);
};

// The origin of a cloud with these coordinates along an axis, in steps of its grid: a whole number of metres near the
// middle where the grid has one, so that coordinates print as they should.
std::int32_t grid_middle(std::int32_t low, std::int32_t high, double scale, double offset);

// A float32 has 24 bits: up to so many steps from the origin the nearest step is the right one.
inline constexpr std::int64_t max_exact_steps = std::int64_t{1} << 23;

// Where columns lie (cloud/large_cloud.h).
struct ColumnRoom {
  std::size_t max_bytes = std::numeric_limits<std::size_t>::max();  // in memory; with more of them they lie on file
  std::vector<std::filesystem::path> folders{};
};

class ColumnBuilder {
 public:
  ColumnBuilder(int point_format, int record_length, std::vector<ExtraDimension> dimensions);

  // Before the first point.
  void set_room(ColumnRoom room) { room_ = std::move(room); }

  // Reserves the columns of `count` points, on file from the start where the room says so.
  void expect(std::size_t count);

  // For points that are chosen from so many: how many they are is known once they are read.
  void expect_at_most(std::size_t count) { max_points_ = count; }

  // Grows to `count` points and keeps those that were decoded. Columns that outgrow their room move to a file, later to
  // larger ones, one after the other and without being in memory as a whole.
  void resize(std::size_t count);
  std::size_t size() const { return positions_.size(); }

  // Bytes of columns that should lie on file and for which no folder has room.
  std::size_t without_room() const { return without_room_; }

  // Releases the memory of the points [first, first + count) as far as their columns lie on file. Coordinates stay.
  void leave(std::size_t first, std::size_t count);

  // Decodes records into the points [first, first + count) and returns their bounding box. Threads may fill different
  // points at the same time.
  IntegerBox decode(const std::uint8_t* records, std::size_t count, std::size_t first);

  // The cloud. Its origin is near the middle of `box`, on the grid of the coordinates, or `origin` where that is on the
  // grid and near enough. Columns of zeros are left out. `*exact`: float32 offsets give every coordinate back.
  PointCloud finish(const IntegerBox& box, const Eigen::Vector3d& scale, const Eigen::Vector3d& offset, bool* exact,
                    const Run& run = {}, const std::optional<Eigen::Vector3d>& origin = std::nullopt);

 private:
  template <class F>
  void for_each_column(F&& f);
  std::size_t bytes_of(std::size_t count);
  template <class T>
  void lay_out(std::vector<T>& values, std::size_t capacity);
  void grow_on_file(std::size_t capacity);
  void reserve_positions(std::size_t capacity);
  template <class T>
  FilePages pages_of(const std::vector<T>& values);
  template <class T>
  void set(PointCloud& cloud, std::string_view name, std::vector<T>& values);
  template <class T>
  void set_unless_zero(PointCloud& cloud, const ArrayInfo& info, std::vector<T>& values);
  void finish_colours(PointCloud& cloud);
  void finish_flags(PointCloud& cloud);
  void finish_extra(PointCloud& cloud, const Run& run);
  void finish_sensor_axis(PointCloud& cloud, std::size_t dimension, int axis, const Run& run);

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
  std::size_t expected_ = 0, max_points_ = 0;
  ColumnRoom room_;
  bool on_file_ = false;
  std::size_t without_room_ = 0;
  std::map<const void*, FilePages> pages_;  // by the first value of the column that lies on them; gone before it
};

}  // namespace bole::io::las
