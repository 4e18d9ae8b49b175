// Loop closures as a person decided, and the pose graph solved again with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "slam/core/edits/loop_edits.h"
#include "slam/core/loops/corrections.h"

namespace bole::slam {

struct LoopEditOptions {
  std::string edits = "[]";
  std::string file;
  int match_frames = 5;
};

const OptionTable& option_table(const LoopEditOptions*);

struct EditedLoops {
  // The tables of slam.run after the edits, with the column state (auto, edited) in `candidates`.
  Table loops, candidates, graph;
  Table log;  // edit, action, from_frame, to_frame, outcome (applied, conflict), message, author, time, reason
  std::optional<Corrections> corrections;  // of trajectory and map; none where nothing changed
  Report report;
};

// `odometry` and `candidates` are the tables of slam.run. An edit means the candidate whose frames are nearest, within
// match_frames of both. `refuse` strikes a loop out. `accept` puts one in: it is held whatever the others say, with the
// relative pose that registration found, or with the one that is given, which needs no candidate. All other loops that
// registration confirmed are judged by the pose graph anew. What no longer fits is a conflict: it changes nothing and
// is listed. Deterministic. Throws Error{bad_input} for tables that are not those of one run, Error{cancelled}.
EditedLoops apply_loop_edits(const Table& odometry, const Table& candidates, const std::vector<LoopEdit>& edits,
                             const LoopEditOptions& options, const Run& run);

}  // namespace bole::slam
