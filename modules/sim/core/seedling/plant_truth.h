// What a perfect measurement of a simulated seedling gives.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "sim/core/seedling/plant_form.h"
#include "sim/core/seedling/scene_part.h"

namespace bole::sim {

// One row: plant_id, height_mm (soil to the highest point), breadth_length_mm, breadth_width_mm (least-area rectangle
// around the plant in plan), stem_diameter_mm (of a circle of the same area at `stem_height` above the soil),
// leaf_count, leaf_area_cm2 (one side of the blades), wing_area_cm2, branch_count, stem_length_mm (soil to tip),
// stem_volume_cm3.
Table plant_traits(const PlantForm& plant, const std::vector<ScenePart>& parts, const std::string& plant_id,
                   double stem_height);

Table leaf_table(const PlantForm& plant);  // leaf, axis, height_mm, azimuth_deg, angle_deg, length_mm, ..., area_cm2
Table internode_table(const PlantForm& plant);  // axis, from_leaf, to_leaf, length_mm
Table stem_table(const PlantForm& plant);       // along the stem above the soil: arc_mm, x_m, y_m, z_m, diameter_mm
Table branch_table(const PlantForm& plant);     // branch, height_mm, angle_deg, length_mm, diameter_mm

// Sides of the rectangle of least area around points in the plane, the longer one first (rotating calipers).
Eigen::Vector2d smallest_rectangle(std::vector<Eigen::Vector2d> points);

// Binary PLY with the property `part` (PartLabel) and `leaf` (-1: none) for each face. Throws Error{failed}.
void write_mesh(const std::filesystem::path& file, const std::vector<ScenePart>& parts);

}  // namespace bole::sim
