// The points about one stem with what is known of their rays, read from the cloud once.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// A straight piece with a radius at either end; offsets from the cloud's origin, metres.
struct Tube {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  double low_radius = 0, high_radius = 0;
};

// The rays of neighbours lie all over the columns of a cloud, and a stem is fitted several times: what is near it is
// kept.
class NearPoints {
 public:
  struct Point {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();    // offset
    Eigen::Vector3d ray = Eigen::Vector3d::Zero();  // from the sensor; zero when not known
    double range = 0;                               // length of `ray`
    double time = 0;                                // 0 when not known
    std::int32_t pass = 0;                          // of the cloud; likewise
  };

  NearPoints(const StemLayer& layer, const CloudRays& rays) : layer_(layer), rays_(rays) {}

  // Reads what lies within the tube and a little beyond, unless it was read before. After a cancel there are none.
  void cover(const Tube& tube, const Run& run);

  const CloudRays& rays() const { return rays_; }
  std::size_t size() const { return points_.size(); }
  const Point& operator[](std::size_t i) const { return points_[i]; }

 private:
  bool covers(const Tube& tube) const;
  std::vector<std::uint32_t> within(const Tube& tube) const;  // of the layer
  Point read(std::uint32_t k) const;

  const StemLayer& layer_;
  const CloudRays& rays_;
  Tube covered_;
  bool read_ = false;
  std::vector<Point> points_;
};

}  // namespace bole::stems
