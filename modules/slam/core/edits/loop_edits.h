// What a person decided about loop closures: a list that is kept beside the pipeline and applied anew after every run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/transform.h"
#include "cloud/edit_list.h"

namespace bole::slam {

struct LoopEdit : EditRecord {
  enum class Action { accept, refuse };

  Action action = Action::accept;
  std::size_t from_frame = 0, to_frame = 0;  // in the scan, counted from 0; from_frame < to_frame
  std::optional<Pose> T_from_to;             // accept: the pose of the later frame in the axes of the earlier one
};

std::string_view action_name(LoopEdit::Action action);  // "accept", "refuse"

// A JSON list of objects, for instance
//   [{"action": "refuse", "from_frame": 210, "to_frame": 1840, "author": "A. Smith", "reason": "the next row"},
//    {"action": "accept", "from_frame": 12, "to_frame": 2050, "relative_pose": [0.1, 0.2, 0, 0, 0, 1, 0]}]
// relative_pose is x, y, z (metres) and qx, qy, qz, qw. Frames in the other order are put in order. Throws
// Error{bad_input} that names the edit by its number.
std::vector<LoopEdit> parse_loop_edits(std::string_view json);

// The same list back: parse_loop_edits(to_json(edits)) gives `edits`.
std::string to_json(const std::vector<LoopEdit>& edits);

}  // namespace bole::slam
