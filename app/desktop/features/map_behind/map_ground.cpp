#include "features/map_behind/map_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bole::desktop {
namespace {

constexpr double min_margin_m = 20, same_place_m = 1e-4, max_leant_m = 0.01;
constexpr int coarse_side_px = 1024;  // of the map that is drawn from afar

std::optional<GlobalFrame> frame_in(const Table* table) {
  if (table == nullptr) return {};
  try {
    return global_frame_of(table->facts);
  } catch (const Error&) {
    return {};  // the stage that reads it says so
  }
}

Eigen::Vector3d on_earth(const GlobalFrame& frame, const Eigen::Vector2d& plan, double z) {
  return frame.to_global({plan.x(), plan.y(), z});
}

}  // namespace

std::optional<GlobalFrame> place_on_earth(const Survey& shown, const Results& results) {
  if (shown.points && shown.points->axes == Axes::global) {
    GlobalFrame itself;
    itself.crs_wkt = shown.points->crs_wkt;
    itself.heights_known = true;
    return itself;
  }
  if (auto frame = frame_in(shown.stems.get())) return frame;
  for (const auto& [stage, outputs] : results)
    for (const auto& [port, data] : outputs.all())
      if (const auto* table = std::get_if<std::shared_ptr<const Table>>(&data))
        if (auto frame = frame_in(table->get())) return frame;
  return {};
}

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

MapGround ground_of(const GlobalFrame& frame, const render::ClipBox& extent) {
  MapGround ground;
  ground.frame = frame;
  ground.foot_m = extent.lo.z();
  for (const double x : {extent.lo.x(), extent.hi.x()})
    for (const double y : {extent.lo.y(), extent.hi.y()})
      ground.box.extend(Eigen::Vector2d(on_earth(frame, {x, y}, ground.foot_m).head<2>()));
  return ground;
}

ReadMap read_map(const QString& path, const MapGround& ground, const Run& run) {
  io::MapWanted wanted;
  wanted.crs = ground.frame.crs_wkt;
  wanted.survey = ground.box;
  wanted.margin_m = ground.margin_m();
  auto picture = io::read_map_picture(path.toStdString(), wanted, run);
  ReadMap read;
  read.crs_known = picture.crs_known;
  read.file_pixel_m = picture.file_pixel_m;
  const auto &from = picture.north_west, to = picture.south_east();
  const Eigen::Vector2d middle = ground.box.center();
  const double height_m = ground.frame.shift_global.z() + ground.foot_m - ground.frame.centre_local.z();
  const auto local = [&](double easting, double northing) {
    return Eigen::Vector2d(ground.frame.to_local({easting, northing, height_m}).head<2>());
  };
  read.map.corners = {local(from.x(), from.y()), local(to.x(), from.y()), local(to.x(), to.y()),
                      local(from.x(), to.y())};
  read.map.north = (local(middle.x(), middle.y() + 1) - local(middle.x(), middle.y())).normalized();
  auto pixels = std::make_shared<render::GroundPicture>();
  pixels->width = picture.width;
  pixels->height = picture.height;
  pixels->rgba = std::move(picture.rgba);
  if (const int step = (std::max(pixels->width, pixels->height) - 1) / coarse_side_px + 1; step > 1)
    read.map.coarse = std::make_shared<const render::GroundPicture>(render::coarser(*pixels, step));
  read.map.picture = std::move(pixels);
  read.map.pixel_m = picture.pixel_m.maxCoeff();
  return read;
}

}  // namespace bole::desktop
