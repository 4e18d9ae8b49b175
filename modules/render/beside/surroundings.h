// What is drawn about a survey and belongs to none of its stages.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cloud/raster.h"
#include "render/beside/beside_cloud.h"
#include "render/beside/ground_places.h"

namespace bole::render {

struct PlacedPicture {
  std::shared_ptr<const GroundPicture> picture;  // never null
  GroundPlaces places;
  double opacity = 1;  // 0 to 1
};

struct ShownTerrain {
  std::shared_ptr<const Raster> heights;  // never null
  bool lines_only = false;                // over a map that follows it
};

// In the axes of the survey.
struct Surroundings {
  std::vector<BesideCloud> clouds;
  std::optional<PlacedPicture> ground{};
  std::optional<ShownTerrain> terrain{};
};

}  // namespace bole::render
