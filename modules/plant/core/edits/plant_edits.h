// What a person changed about a plant: a list that is kept beside the pipeline and applied anew after every run.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/core/regions/point_region.h"
#include "cloud/edit_list.h"
#include "plant/core/separate/plant_scene.h"

namespace bole::plant {

// Places are metres in the axes of the points.
struct PlantEdit : EditRecord {
  enum class Action { set_base, set_stem_height, assign, set_value, accept, reject, note };

  Action action = Action::note;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // set_base
  double height = 0;                             // set_stem_height: above the soil
  PointRegion region;                            // assign: which points
  std::optional<Part> from;                      // assign: only points of this part
  Part part = Part::other;                       // assign: what they become
  std::string trait;                             // set_value: height, breadth_length, breadth_width, stem_diameter
  double value_mm = 0;                           // set_value
  std::optional<double> was_mm;                  // set_value: what the person saw
  std::string text;                              // note
};

std::string_view action_name(PlantEdit::Action action);  // "set_base", ...

// A JSON list of objects, for instance
//   [{"action": "assign", "at": [0.1, 0.2, 0.3], "radius_m": 0.02, "from": "plant", "part": "other", "reason": "leaf of
//   the neighbour"}, {"action": "set_value", "trait": "stem_diameter", "value_mm": 5.4, "author": "A. Smith"}]
// The points of assign are those of a ball ("at", "radius_m"), of a box ("min", "max") or of an outline ("outline": a
// list of corners, "eye" where it was drawn in perspective), see point_region.h.
// Throws Error{bad_input} that names the edit by its number: text that is no JSON, unknown keys or actions, what an
// action needs and lacks, and values that no seedling has.
std::vector<PlantEdit> parse_plant_edits(std::string_view json);

// The same list back: parse_plant_edits(to_json(edits)) gives `edits`.
std::string to_json(const std::vector<PlantEdit>& edits);

}  // namespace bole::plant
