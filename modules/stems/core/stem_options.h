// Options of the stem stages. Each default lives here, each range and help sentence in the table beside it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "cloud/breast_height.h"

namespace bole::stems {

enum class BreastHeightFrom { uphill, mean };
constexpr std::array<std::string_view, 2> choice_names(BreastHeightFrom) { return {"uphill", "mean"}; }

enum class FitModel { automatic, ray, surface };
constexpr std::array<std::string_view, 3> choice_names(FitModel) { return {"auto", "ray", "surface"}; }

struct SliceOptions {
  double height = usual_breast_height_m;
  double thickness = 0.10;
};

struct MeasureOptions {
  // Detection
  double min_dbh_cm = 5;
  double max_dbh_cm = 150;
  double search_bottom = 0.50;
  double search_top = 3.50;
  double max_lean_deg = 35;
  int min_sections = 3;
  int min_section_points = 6;
  double min_arc_deg = 80;
  // Fit
  BreastHeightFrom breast_height_from = BreastHeightFrom::uphill;
  FitModel model = FitModel::automatic;
  double window = 0.65;
  double section_step = 0.10;
  double max_sigma = 0.025;
  double ray_gate = 0.95;
  // Without a value: as the cloud says.
  std::optional<double> beam_divergence_mrad, beam_divergence_sd_mrad, beam_aperture, range_noise;
  std::string bark = "mean";
  std::optional<double> bark_relief, bark_relief_sd;  // without a value: as the bark says
  bool estimate_range_offset = true;
  std::optional<double> range_offset_sd;  // without a value: by the number of lasers
  double range_bias = 0.0004;
  double pass_gap = 10;
  double max_range = 20;
  double max_ray_through = 0.30;
  // Points of a tree
  double crown_radius = 6;
  double bark_tolerance = 0.03;
};

const OptionTable& option_table(const SliceOptions*);
const OptionTable& option_table(const MeasureOptions*);

}  // namespace bole::stems
