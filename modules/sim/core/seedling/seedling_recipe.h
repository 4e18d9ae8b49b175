// What a seedling and its pot are made of: read from resources/plants/*.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/core/plot/recipe_fields.h"

namespace bole::sim {

// Every span is a range that the seed draws a value from.
struct SeedlingStem {
  Span height_m{0.28, 0.38};   // of the tip of the stem above the soil
  Span diameter_mm{4.5, 6.5};  // 30 mm above the soil
  Span tip_share{0.35, 0.5};   // diameter at the tip / diameter at the soil
  Span lean_deg{0, 5};         // of the whole stem
  Span bow_share{0.01, 0.05};  // sideways bow / height
  Span zigzag_deg{1, 5};       // change of direction from node to node
};

struct SeedlingBranches {
  Span count{0, 0};
  Span from_share{0.25, 0.4};       // height of the lowest / height of the stem
  Span to_share{0.6, 0.8};          // height of the highest / height of the stem
  Span angle_deg{35, 55};           // between branch and stem
  Span length_share{0.3, 0.5};      // of the height of the stem
  Span diameter_share{0.45, 0.65};  // of the stem's diameter at the insertion
  Span rise_deg{5, 25};             // turn upwards along the branch
};

struct SeedlingLeaves {
  Span spacing_mm{10, 16};        // internodes
  Span first_share{0.2, 0.35};    // height of the lowest leaf / height of the stem
  Span divergence_deg{132, 142};  // from leaf to leaf around the axis
  Span length_mm{45, 75};         // of the blade
  Span width_share{0.42, 0.55};
  Span petiole_mm{8, 16};
  Span wing_mm{3, 8};        // width of the wings of the petiole
  Span angle_deg{40, 70};    // between petiole and axis
  Span droop_deg{10, 50};    // bend of the midrib downwards
  Span cup{0.05, 0.25};      // the halves bend down by this share of the half width
  Span fold_deg{0, 20};      // the halves rise like a V
  Span wave_share{0, 0.08};  // waves of the margin / half width
  Span thickness_mm{0.3, 0.3};
  Span yellow{0, 0.3};  // share of yellowing
};

struct SeedlingPot {
  Span top_mm{90, 110};  // outer diameter at the rim
  Span bottom_share{0.68, 0.8};
  Span height_mm{80, 100};
  Span soil_below_mm{8, 14};  // soil below the rim
  Span relief_mm{0.5, 1.5};   // standard deviation of the soil's surface
};

struct SeedlingRecipe {
  std::string name = "unnamed", title;
  SeedlingStem stem;
  SeedlingBranches branches;
  SeedlingLeaves leaves;
  SeedlingPot pot;
};

// Throws Error{bad_input} that names the field of the recipe, its value and what was needed; unknown ones are errors.
SeedlingRecipe parse_seedling(const nlohmann::json& json);

// `name_or_path`: a name in resources/plants ("citrus") or the path of a recipe.
SeedlingRecipe read_seedling(const std::string& name_or_path);

nlohmann::json seedling_json(const SeedlingRecipe& recipe);

// Names in resources/plants, sorted.
std::vector<std::string> seedling_names();

}  // namespace bole::sim
