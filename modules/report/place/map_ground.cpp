#include "report/place/map_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/core/gdal/map_picture.h"

namespace bole::report {
namespace {

constexpr double min_margin_m = 20, same_place_m = 1e-4, max_leant_m = 0.01;

Eigen::Vector3d on_earth(const GlobalFrame& frame, const Eigen::Vector2d& plan, double z) {
  return frame.to_global({plan.x(), plan.y(), z});
}

}  // namespace

bool MapGround::same_place(const MapGround& other) const {
  const auto &a = frame, &b = other.frame;
  const double leant_m = a.A_global_local.col(2).head<2>().norm() * std::abs(foot_m - other.foot_m);
  if (a.crs_wkt != b.crs_wkt || leant_m > max_leant_m) return false;
  const Eigen::Vector2d middle = box.center();
  const Eigen::Vector3d at(middle.x(), middle.y(), a.to_global({0, 0, foot_m}).z());
  return (a.to_local(at) - b.to_local(at)).head<2>().norm() < same_place_m &&
         a.A_global_local.isApprox(b.A_global_local, 1e-7);
}

double MapGround::margin_m() const { return std::max(min_margin_m, box.sizes().maxCoeff()); }

bool MapGround::serves(const MapGround& other) const {
  const Eigen::Vector2d half_margin = Eigen::Vector2d::Constant(margin_m() / 2);
  const Eigen::AlignedBox2d seen(box.min() - half_margin, box.max() + half_margin);
  // One that was read for much more is coarse.
  return same_place(other) && seen.contains(other.box) && box.sizes().maxCoeff() < 2 * other.box.sizes().maxCoeff();
}

MapGround ground_of(const GlobalFrame& frame, const Eigen::AlignedBox3d& extent) {
  MapGround ground;
  ground.frame = frame;
  ground.foot_m = extent.min().z();
  for (const double x : {extent.min().x(), extent.max().x()})
    for (const double y : {extent.min().y(), extent.max().y()})
      ground.box.extend(Eigen::Vector2d(on_earth(frame, {x, y}, ground.foot_m).head<2>()));
  return ground;
}

GroundMap read_ground_map(const std::filesystem::path& path, const MapGround& ground, const Run& run) {
  io::MapWanted wanted;
  wanted.crs = ground.frame.crs_wkt;
  wanted.survey = ground.box;
  wanted.margin_m = ground.margin_m();
  auto read = io::read_map_picture(path, wanted, run);
  GroundMap map;
  map.crs_known = read.crs_known;
  map.file_pixel_m = read.file_pixel_m;
  map.pixel_m = read.pixel_m.maxCoeff();
  const auto &from = read.north_west, to = read.south_east();
  const Eigen::Vector2d middle = ground.box.center();
  const double height_m = ground.frame.shift_global.z() + ground.foot_m - ground.frame.centre_local.z();
  const auto local = [&](double easting, double northing) {
    return Eigen::Vector2d(ground.frame.to_local({easting, northing, height_m}).head<2>());
  };
  map.corners = {local(from.x(), from.y()), local(to.x(), from.y()), local(to.x(), to.y()), local(from.x(), to.y())};
  map.north = (local(middle.x(), middle.y() + 1) - local(middle.x(), middle.y())).normalized();
  render::GroundPicture picture;
  picture.width = read.width;
  picture.height = read.height;
  picture.rgba = std::move(read.rgba);
  map.picture = std::make_shared<const render::GroundPicture>(std::move(picture));
  return map;
}

}  // namespace bole::report
