// The output map: all returns, de-skewed with the final path and thinned evenly, with the history of each point.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/scan_frame.h"
#include "slam/core/map/view_column.h"
#include "slam/core/odometry/motion.h"

namespace bole::slam {

struct DenseMapSettings {
  double min_range = 0.8, max_range = 25;
  double voxel = 0.015;      // width of the columns across the view (view_column.h)
  int points_per_voxel = 1;  // of each pass and direction of view
  std::size_t max_points = 20'000'000;
  std::size_t expected_points = 0;  // expected number of returns, for the size of the filter; 0: unknown
};

// Thins with a counting filter of fixed size instead of a set of columns: two hashed counters per column and pass, of
// which the lower one counts. The memory does not grow with the walk. A column that shares both counters with others
// loses points (1 in 100 when the filter is 10 % full). When max_points is reached, every second point is dropped, and
// so are those added later.
class DenseMapBuilder {
 public:
  explicit DenseMapBuilder(const DenseMapSettings& settings);

  // `poses` gives the poses over the frame (grid over start_time_s .. end_time_s).
  void add(const ScanFrame& frame, const PoseGrid& poses, std::int32_t pass, std::int32_t keyframe);

  std::size_t size() const { return positions_.size(); }
  std::size_t offered() const { return offered_; }
  // How often the map was halved.
  int halvings() const { return halvings_; }
  // The cloud in map axes with time, range, ring, intensity, pass, keyframe and sensor_x/y/z. Leaves the builder empty.
  PointCloud take();

 private:
  std::uint64_t column_of(const Eigen::Vector3f& position, const Eigen::Vector3f& sensor, std::int32_t pass) const;
  bool admit(std::uint64_t column);
  bool survives(std::uint64_t serial) const;
  void halve();

  const DenseMapSettings settings_;
  const ViewColumns columns_;
  std::vector<std::uint8_t> counters_;
  PointCloud::Positions positions_;
  std::vector<double> time_;
  std::vector<float> range_, intensity_, sensor_x_, sensor_y_, sensor_z_;
  std::vector<std::uint16_t> ring_;
  std::vector<std::int32_t> pass_, keyframe_;
  std::vector<Eigen::Vector3f> in_map_, sensor_;  // of the current frame
  std::vector<std::uint64_t> column_;
  std::vector<std::uint8_t> usable_;
  std::uint64_t serial_ = 0;
  std::size_t offered_ = 0;
  int halvings_ = 0;
};

}  // namespace bole::slam
