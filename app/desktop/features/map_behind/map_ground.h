// Where the survey that the 3-D view shows lies on the earth, and a picture of that place in its axes.
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "base/run.h"
#include "cloud/core/global_frame.h"
#include "document/survey.h"
#include "io/core/gdal/map_picture.h"
#include "render/scene/point_layer.h"
#include "views/map/map_layer.h"

namespace bole::desktop {

// The axes of the points themselves where they are those of a coordinate system, else the place that the run found.
// Its system is empty where only its coordinates are known.
std::optional<GlobalFrame> place_on_earth(const Survey& shown, const Results& results);

// What of the earth a survey lies on.
struct MapGround {
  GlobalFrame frame;
  Eigen::AlignedBox2d box;  // eastings and northings around it
  double foot_m = 0;        // local height of the map

  bool same_place(const MapGround& other) const;
  double margin_m() const;  // that is read around it
  // A map of this ground shows enough of the other one too.
  bool serves(const MapGround& other) const;
};
MapGround ground_of(const GlobalFrame& frame, const render::ClipBox& extent);

struct ReadMap {
  SceneMap map;
  bool crs_known = true;
  double file_pixel_m = 0;
};
// Takes as long as the picture is large. Throws as io::read_map_picture does.
ReadMap read_map(const QString& path, const MapGround& ground, const Run& run);

}  // namespace bole::desktop
