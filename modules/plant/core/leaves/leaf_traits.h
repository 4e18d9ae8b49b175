// Leaves, internodes, branches and the whole stem of a plant as tables and columns.
#pragma once

#include <functional>
#include <optional>

#include "base/no_number.h"
#include "base/report.h"
#include "cloud/table.h"
#include "plant/core/leaves/plant_organs.h"

namespace bole::plant {

struct LeafInputs {
  const Points3* plant = nullptr;  // plant axes: z up, the origin where the stem leaves the soil
  Eigen::Matrix3d R_world_plant = Eigen::Matrix3d::Identity();
  double unit = 0.02;  // as OrganScales
  double spacing = 0, noise = 0, max_gap = 0;
  double scale_sd = 0;  // of lengths, as a share
};

struct LeafTraits {
  PlantOrgans organs;
  Table leaves, internodes, branches;
  bool usable = false;  // leaves and stem can be told apart
};

// Finds of what is uncertain go into `report`.
LeafTraits measure_leaves(const LeafInputs& inputs, const Run& run, Report& report);

// leaf_count, leaf_area_cm2, branch_count, stem_length_mm, intervals as NAME_lo_UNIT and NAME_hi_UNIT. Leaves that hang
// on others are rows of the table of leaves and count in leaf_hi_count alone. NaN where nothing is known.
void add_leaf_columns(Table& traits, const LeafTraits& leaves, const LeafInputs& inputs);

struct DiameterThere {
  double diameter = no_number;  // metres
  double sd = no_number;        // of it
  bool seen = false;            // in the pictures; else it is that between two places that were
};

// Adds the rest of the main stem, every 5 mm, to the sections that were measured; rows go upwards. `diameter_at`: by
// the length along the stem from the soil, as the pictures show it (source contours) or between places where they do
// (source between); without a diameter (source cloud) elsewhere, as a cloud shows thin stems too wide.
void add_stem_sections(Table& stem, const LeafTraits& leaves, const LeafInputs& inputs,
                       const std::function<DiameterThere(double arc)>& diameter_at);

}  // namespace bole::plant
