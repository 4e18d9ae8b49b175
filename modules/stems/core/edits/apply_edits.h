// Edits applied to what the measurement found.
#pragma once

#include <optional>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "stems/core/edits/stem_edits.h"

namespace bole::stems {

struct EditOptions {
  std::string edits = "[]";
  std::string file;
  double match_distance = 0.5;
  double doubt = 1.0;
};

const OptionTable& option_table(const EditOptions*);

// Null where not connected.
struct EditInputs {
  const Table* stems = nullptr;
  const Table* sections = nullptr;
  const PointCloud* points = nullptr;  // with tree_id; gets the changed ids
  const PointCloud* slice = nullptr;   // points at breast height: what an added stem without a diameter is fitted to
  const Table* plot = nullptr;         // which trees count: their ids come first
  const Table* point_edits = nullptr;  // points that a person gave to trees, from survey.edit_points
};

struct EditedStems {
  Table stems;     // as given, and `note`; state is edited, accepted or rejected where a person decided
  Table sections;  // of the stems that are left and have their measured diameter; empty when none were given
  std::optional<PointCloud> points;
  Table log;  // edit, action, tree_id, x_m, y_m, outcome (applied, conflict), message, author, time, reason
  Report report;
};

// Applies `edits` in their order. An edit finds its stem by place, since ids change when a run is repeated: the nearest
// within match_distance, unless a second one is less than twice as far. What finds no stem, more than one, or another
// measurement than the one that was accepted or rejected is a conflict: it changes nothing and is told.
// With a plot the stems are numbered anew before any edit, those that count from 1 on (plot_numbers.h), in the stems,
// their sections and the points alike; edits do not change these ids, and new stems get ids above all others. A
// diameter that a person gives has no interval (NaN), and the sections of its stem, which say otherwise, are dropped;
// those of a moved or tilted stem move with it. Columns that hold the decision and are absent (state, note, height_m,
// species) are added. Throws Error{bad_input} when `stems` lacks tree_id, x_m, y_m or dbh_cm, Error{cancelled} when
// asked to.
EditedStems apply_stem_edits(const EditInputs& inputs, const std::vector<StemEdit>& edits, const EditOptions& options,
                             const Run& run);

}  // namespace bole::stems
