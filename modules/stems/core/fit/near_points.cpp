#include "stems/core/fit/near_points.h"

#include <algorithm>
#include <cmath>

namespace bole::stems {
namespace {

// Beyond the tube that is asked for: fits move a stem by less.
constexpr double beyond_m = 0.05;
constexpr std::size_t points_between_polls = 256;  // where each may lie on a page of a file

}  // namespace

// Tubes are straight: what holds at both ends holds between them.
bool NearPoints::covers(const Tube& tube) const {
  return read_ && (tube.low - covered_.low).norm() + tube.low_radius - covered_.low_radius < beyond_m &&
         (tube.high - covered_.high).norm() + tube.high_radius - covered_.high_radius < beyond_m;
}

std::vector<std::uint32_t> NearPoints::within(const Tube& tube) const {
  const Eigen::Vector3d axis = tube.high - tube.low;
  const double length = axis.norm(), taper = (tube.high_radius - tube.low_radius) / length;
  const Eigen::Matrix3d rotation = rotation_between(axis / length, Eigen::Vector3d::UnitZ());
  const double widest = std::max(tube.low_radius, tube.high_radius) + (1 + std::abs(taper)) * beyond_m;
  const Eigen::Vector2d middle = 0.5 * (tube.low + tube.high).head<2>(),
                        reach = 0.5 * axis.head<2>().cwiseAbs() + Eigen::Vector2d::Constant(widest + beyond_m);
  std::vector<std::uint32_t> near;
  layer_.for_each_near(middle.x(), middle.y(), reach.maxCoeff(), [&](std::uint32_t k) {
    const Eigen::Vector3d p = rotation * (layer_.position[k].cast<double>() - tube.low);
    if (p.z() < -beyond_m || p.z() > length + beyond_m) return;
    const double radius = tube.low_radius + taper * p.z() + (1 + std::abs(taper)) * beyond_m;
    if (radius > 0 && p.head<2>().squaredNorm() <= radius * radius) near.push_back(k);
  });
  return near;
}

NearPoints::Point NearPoints::read(std::uint32_t k) const {
  Point out;
  const auto i = layer_.index[k];
  out.p = layer_.position[k].cast<double>();
  if (rays_.sensor_x)
    out.ray = out.p - Eigen::Vector3d((*rays_.sensor_x)[i], (*rays_.sensor_y)[i], (*rays_.sensor_z)[i]);
  else if (rays_.has_sensor())
    out.ray = out.p - rays_.sensor[k].cast<double>();
  out.range = out.ray.norm();
  if (rays_.time) out.time = (*rays_.time)[i];
  if (rays_.pass) out.pass = (*rays_.pass)[i];
  return out;
}

void NearPoints::cover(const Tube& tube, const Run& run) {
  if (covers(tube)) return;
  points_.clear(), covered_ = tube, read_ = true;
  const auto near = within(tube);
  points_.reserve(near.size());
  for (const auto k : near) {
    if (points_.size() % points_between_polls == 0 && run.cancelled()) return points_.clear();
    points_.push_back(read(k));
  }
}

}  // namespace bole::stems
