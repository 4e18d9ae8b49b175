// What was measured on a plant, as lines over the 3-D view and as rows of a table.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "document/survey.h"
#include "views/scene_drawing.h"

namespace bole::desktop {

// Where traits stand on the plant, metres in world axes; what is not known is absent.
struct TraitPlaces {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> base;     // of the stem, on the soil
  std::optional<Eigen::Vector3d> stem;     // its axis at the height of measurement
  std::vector<Eigen::Vector3d> axis;       // of the stem, from below
  std::vector<Eigen::Vector3d> rectangle;  // of the breadth, its corners at the height of the base
};
TraitPlaces trait_places(const Survey& survey);

// Height, breadth and stem with their values in millimetres; nothing for what was not measured. The ids are "height",
// "breadth", "stem" and "axis".
std::vector<SceneDrawing> trait_drawings(const Survey& survey);

// One row per trait that has an interval: trait, value, from, to, unit. Null without traits.
std::shared_ptr<const Table> trait_rows(const Table* traits);

}  // namespace bole::desktop
