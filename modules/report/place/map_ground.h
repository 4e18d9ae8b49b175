// What of the earth a survey lies on, and a picture of that place (orthophoto, scanned map) in its axes.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>

#include "base/run.h"
#include "cloud/core/global_frame.h"
#include "render/beside/ground_places.h"

namespace bole::report {

struct MapGround {
  GlobalFrame frame;
  Eigen::AlignedBox2d box;  // eastings and northings around it
  double foot_m = 0;        // local height of the map

  bool same_place(const MapGround& other) const;
  double margin_m() const;  // that is read around it
  // A map of this ground shows enough of the other one too.
  bool serves(const MapGround& other) const;
};
// `extent`: of the survey, local.
MapGround ground_of(const GlobalFrame& frame, const Eigen::AlignedBox3d& extent);

struct GroundMap {
  std::shared_ptr<const render::GroundPicture> picture;  // never null
  double pixel_m = 1;                                    // of `picture`
  render::GroundCorners corners;                         // local x and y
  Eigen::Vector2d north = Eigen::Vector2d::UnitY();      // of its coordinate system, in local axes; unit
  bool crs_known = true;                                 // false: it was taken to have the system of the survey
  double file_pixel_m = 0;
};
// Takes as long as the picture is large. Throws as io::read_map_picture does.
GroundMap read_ground_map(const std::filesystem::path& path, const MapGround& ground, const Run& run);

}  // namespace bole::report
