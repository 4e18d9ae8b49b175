// One edit of a person applied to the loop closures of a pose graph.
#pragma once

#include <string>

#include "slam/core/edits/loop_edits.h"
#include "slam/core/loops/loop_tables.h"

namespace bole::slam {

// Why an edit does not fit.
struct EditConflict {
  std::string why;
};

// "frames 12 and 340": the two of a loop.
std::string pair_text(const StoredGraph& graph, const Loop& loop);

// Accepts a candidate, puts a new loop in, or strikes one out. `match_frames`: largest difference between the frames of
// the edit and those of the loop that it means. What was done, for the log. Throws EditConflict, and then changes
// nothing.
std::string change_loops(StoredGraph& graph, const LoopEdit& edit, int match_frames);

}  // namespace bole::slam
