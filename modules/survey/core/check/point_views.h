// From where each point of a cloud was seen.
#pragma once

#include <optional>

#include "cloud/point_cloud.h"

namespace bole::survey {

class PointViews {
 public:
  explicit PointViews(const PointCloud& points) : origin_(points.origin.head<2>()) {
    if (!points.has(arrays::sensor_x) || !points.has(arrays::sensor_y)) return;
    x_ = &points.values<float>(arrays::sensor_x);
    y_ = &points.values<float>(arrays::sensor_y);
  }
  bool known() const { return x_ != nullptr; }
  // The place of the sensor in the axes of the points; nothing where it is not known.
  std::optional<Eigen::Vector2d> sensor(std::size_t i) const {
    const Eigen::Vector2d at = origin_ + Eigen::Vector2f((*x_)[i], (*y_)[i]).cast<double>();
    if (!at.allFinite()) return std::nullopt;
    return at;
  }

 private:
  Eigen::Vector2d origin_;
  const std::vector<float>*x_ = nullptr, *y_ = nullptr;
};

}  // namespace bole::survey
