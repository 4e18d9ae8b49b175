// How far the passes of a walk are displaced against one another, by the stems that several of them see.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::stems {

// Where one stretch of the walk sees one stem, less where all of them together put it.
struct PassSighting {
  int stem = 0;
  std::int32_t pass = 0;                             // of the cloud; 0 where it has none
  double time_s = 0;                                 // mean of its returns; 0 where times are not known
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();  // metres in the plan
};

// Displacements in the plan by pass and by time within it. The place of every stem is free, so that a stem that few
// passes see does not pull on them; the mean over all sightings is zero, so that the map stays where it is.
class PassAlignment {
 public:
  PassAlignment() = default;
  // Within a pass the displacement follows the sightings in time, as far as several agree.
  explicit PassAlignment(const std::vector<PassSighting>& sightings);

  bool empty() const { return tables_.empty(); }
  Eigen::Vector2d at(std::int32_t pass, double time_s) const;  // zero for a pass without sightings
  double rms_m() const { return rms_m_; }                      // over the sightings, per axis

 private:
  struct Table {
    std::vector<double> time_s;  // of the sightings, rising
    std::vector<Eigen::Vector2d> shift;
  };
  std::map<std::int32_t, Table> tables_;
  double rms_m_ = 0;
};

// The cloud with every point and its sensor moved back by the displacement of its pass. Uses `pass`, `time` and
// `sensor_x`, `sensor_y` where present.
PointCloud aligned(const PointCloud& points, const PassAlignment& alignment, const Run& run);

}  // namespace bole::stems
