// Archetypes that vegetation is made of: each call grows another individual.
#pragma once

#include "sim/core/scene/random.h"
#include "sim/core/scene/scene_model.h"

namespace bole::sim {

inline constexpr float wood_reflectivity = 0.4f;  // at the laser's wavelength of about 0.9 um, as those of plants.cpp

Archetype leaf_clump(Random& random);    // leaves of a branch's end, about 0.8 m across
Archetype needle_spray(Random& random);  // a conifer's branch end: a flat spray of needles along +x, 0.9 m long
Archetype shrub(Random& random);  // a bush about 1 m high and wide, of stems from one root with leaves along them
// Shoots and leaves of one vine between the wires, `height_m` high, along x, a little longer than `spacing_m`.
Archetype vine_canopy(double height_m, double spacing_m, Random& random);
Archetype grass_tuft(Random& random);
Archetype rock(Random& random);  // radius about 1

}  // namespace bole::sim
