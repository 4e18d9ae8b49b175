// What a simulated plot is made of: read from resources/plots/*.json. Every field, with its unit, is described in
// modules/sim/README.md.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace bole::sim {

// natural: Poisson-disc with clustering; rows: a planting; vineyard: a block of vine rows within the plot, trees around
// it.
enum class LayoutKind { natural, rows, vineyard };
constexpr std::array<std::string_view, 3> choice_names(LayoutKind) { return {"natural", "rows", "vineyard"}; }

struct LayoutRecipe {
  LayoutKind kind = LayoutKind::natural;
  double min_spacing_m = 1.2;     // natural: smallest distance between stem axes
  double clustering = 0.3;        // natural, 0 to 1: share of trees that stand close to an earlier one
  double row_spacing_m = 3.0;     // rows
  double plant_spacing_m = 2.0;   // rows
  double row_azimuth_deg = 90.0;  // rows: direction of the rows, clockwise from north
  double position_sd_m = 0.05;    // rows
  double missing_share = 0.0;     // rows
};

enum class Species { broadleaf, conifer };  // the form of a tree
constexpr std::array<std::string_view, 2> choice_names(Species) { return {"broadleaf", "conifer"}; }

// A species of a stand with bark and form of its own.
struct SpeciesRecipe {
  std::string name = "unnamed";
  Species form = Species::broadleaf;
  double share = 1;    // of the trees, relative to the shares of the other species
  double bark_mm = 3;  // as TreeRecipe has them
  double ovality = 0.02;
  double flare = 0.25;
};

struct TreeRecipe {
  int count = 20;  // within the plot; for rows 0 means as many as fit
  double dbh_mean_cm = 20;
  double dbh_sd_cm = 4;  // divided by n, as the plots of the source are described
  double dbh_min_cm = 7.5;
  double dbh_max_cm = 80;
  double conifer_share = 0.3;
  double dead_share = 0.03;
  double fork_share = 0.05;  // forks above breast height
  double twin_share = 0.03;  // stems that share their base with another (fork below breast height); both count
  double lean_sd_deg = 2.0;
  double sweep_m = 0.10;  // largest bow of the axis over the lowest 4 m, 1 sigma
  double ovality =
      0.02;  // 1 sigma of the relative amplitude of the second Fourier term of a section; higher ones fall off
  double flare = 0.25;        // mean relative widening at the ground
  double bark_mm = 3.0;       // depth of the bark's fissures
  double low_branches = 1.0;  // multiplies the number of branches and twigs below the crown
  // Where species are named, form, bark, ovality and flare are theirs.
  std::vector<SpeciesRecipe> species;
  double buttress_share = 0;  // stems whose root lobes reach above breast height
  double leaning_share = 0;   // stems that lean by 10 to 20 deg
  double coppice_share = 0;   // stems that stand in stools: several from one base
  int coppice_stems = 5;      // most stems of a stool
};

struct TerrainRecipe {
  double slope_deg = 8;
  double aspect_deg = 180;         // direction the slope faces (downhill), clockwise from north
  double undulation_m = 0.5;       // height of the broad waves
  double undulation_scale_m = 14;  // their length
  double micro_relief_m = 0.03;
  double rocks_per_ha = 60;
  double fallen_stems_per_ha = 30;
  double fallen_max_cm = 26;  // thickest fallen stem
  double stumps_per_ha = 0;
  double terrace_width_m = 0;    // of a terrace along the slope; 0: an even slope
  double terrace_riser_m = 0.8;  // part of it that is the steep riser
};

struct UnderstoreyRecipe {
  double shrubs_per_ha = 250;
  double saplings_per_ha = 80;  // thin stems below the smallest diameter, crossing breast height
  double grass_per_ha = 4000;   // tufts
  double poles_per_ha = 0;      // young trees between and below the others: they are in trees.csv
  double pole_min_cm = 3, pole_max_cm = 9;
};

// Free ground between the ends of vine rows and the edge of their plot, where a robot turns.
inline constexpr double vineyard_headland_m = 5.5;

// Rows of trained vines, parallel to the x axis about the plot's centre (layout.kind "vineyard").
struct VineyardRecipe {
  int rows = 7;
  double row_length_m = 40;
  double row_spacing_m = 2.75;
  double vine_spacing_m = 1.1;
  double post_spacing_m = 5.5;
  double canopy_bottom_m = 0.75, canopy_top_m = 1.9;
  double missing_share = 0.06;  // of vines
  int repeats = 2;              // alleys that are driven once more in the direction of the first time
  int sheds = 1;                // 0 to 2: buildings beyond the block
};

struct PlotRecipe {
  std::string name = "unnamed", title;
  double size_m = 32;    // side of the square plot; x east, y north, origin at its centre
  double buffer_m = 12;  // the forest goes on this far beyond the boundary
  LayoutRecipe layout;
  TreeRecipe trees;
  TerrainRecipe terrain;
  UnderstoreyRecipe understorey;
  VineyardRecipe vineyard;

  bool is_vineyard() const { return layout.kind == LayoutKind::vineyard; }
};

// Throws Error{bad_input} that names the field, its value and what was needed; unknown fields are errors too.
PlotRecipe parse_recipe(const nlohmann::json& json);
PlotRecipe read_recipe(const std::filesystem::path& file);
nlohmann::json to_json(const PlotRecipe& recipe);

}  // namespace bole::sim
