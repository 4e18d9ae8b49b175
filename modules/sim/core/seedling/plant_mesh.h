// Triangles of a seedling.
#pragma once

#include "sim/core/seedling/plant_form.h"
#include "sim/core/seedling/scene_part.h"

namespace bole::sim {

// Tubes of stem, branches and petioles; blades and wings as closed sheets of the leaf's thickness, upper side and
// underside as parts of their own whose vertices correspond.
std::vector<ScenePart> plant_parts(const PlantForm& plant);

// One-sided area of the middle surface of a blade, or of the wings (m2).
double blade_area(const PlantLeaf& leaf);
double wing_area(const PlantLeaf& leaf);

}  // namespace bole::sim
