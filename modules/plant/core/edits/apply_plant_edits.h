// Edits applied to a separated and measured plant.
#pragma once

#include "base/option.h"
#include "plant/core/edits/plant_edits.h"
#include "plant/core/traits/traits.h"

namespace bole::plant {

struct PlantEditOptions {
  std::string edits = "[]";
  std::string file;
};
const OptionTable& option_table(const PlantEditOptions*);

struct PlantEditInputs {
  const PointCloud* points = nullptr;  // of plant.separate
  const Table* traits = nullptr;       // of plant.traits, with the facts that tell its options
  const Table* stem = nullptr;         // the other tables, handed on where nothing is measured anew; may be null
  const Table* leaves = nullptr;
  const Table* internodes = nullptr;
  const Table* contours = nullptr;
  const ViewSource* views = nullptr;  // as plant.traits had them
  const Trajectory* poses = nullptr;
  const Table* branches = nullptr;
};

struct EditedPlant {
  PointCloud points;
  Traits traits;  // with its report
  Table log;      // edit, action, outcome (applied, conflict), message, author, time, reason
};

// Edits of base, height of measurement and parts of points come first, whatever their order in the list, and the plant
// is measured anew with the options of the first measurement. Then values that a person gave take the place of measured
// ones; they have no interval (NaN). state becomes edited, accepted or rejected. An edit that changes nothing (no such
// point lies there), or whose was_mm is another value than what is measured now (by more than 2 % and 0.1 mm), is a
// conflict: it changes nothing and is listed. Throws Error{bad_input} for tables that are not of plant.traits.
EditedPlant apply_plant_edits(const PlantEditInputs& inputs, const std::vector<PlantEdit>& edits, const Run& run);

}  // namespace bole::plant
