// Options of the stem stages. Each default lives here, each range and help sentence in the table beside it.
#pragma once

#include <string>

#include "base/option.h"
#include "cloud/breast_height.h"

namespace bole::stems {

struct SliceOptions {
  double height = usual_breast_height_m;
  double thickness = 0.10;
};

struct MeasureOptions {
  // Detection
  double min_dbh_cm = 5;
  double max_dbh_cm = 150;
  double search_bottom_m = 0.50;
  double search_top_m = 3.50;
  double max_lean_deg = 35;
  int min_sections = 3;
  int min_section_points = 6;
  double min_arc_deg = 80;
  // Fit
  std::string breast_height_from = "uphill";
  std::string model = "auto";
  double window_m = 0.65;
  double section_step_m = 0.10;
  double max_sigma_m = 0.025;
  double ray_gate = 0.95;
  double beam_divergence_mrad = 3.0;
  double beam_aperture_m = 0.0095;
  double bark_relief_m = 0.0015;
  bool estimate_range_offset = true;
  double range_offset_sd_m = 0.001;
  double range_bias_m = 0.0004;
  double pass_gap_s = 10;
  double max_range_m = 20;
  double max_ray_through = 0.30;
  // Points of a tree
  double crown_radius_m = 2.5;
  double bark_tolerance_m = 0.03;
};

const OptionTable& option_table(const SliceOptions*);
const OptionTable& option_table(const MeasureOptions*);

}  // namespace bole::stems
