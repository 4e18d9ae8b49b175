// Where the survey that the 3-D view shows lies on the earth, and a picture of that place in its axes.
#pragma once

#include <QString>
#include <optional>

#include "cloud/core/global_frame.h"
#include "document/survey.h"
#include "report/place/map_ground.h"
#include "views/map/map_layer.h"

namespace bole::desktop {

// The axes of the points themselves where they are those of a coordinate system, else the place that the run found.
// Its system is empty where only its coordinates are known.
std::optional<GlobalFrame> place_on_earth(const Survey& shown, const Results& results);

using report::MapGround;

struct ReadMap {
  SceneMap map;
  bool crs_known = true;
  double file_pixel_m = 0;
};
// Throws as report::read_ground_map does.
ReadMap read_map(const QString& path, const MapGround& ground, const Run& run);

}  // namespace bole::desktop
