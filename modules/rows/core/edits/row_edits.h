// What a person changed about rows: a list that is kept beside the pipeline and applied anew after every run.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/edit_list.h"

namespace bole::rows {

// Positions are metres in the axes of the rows. `at` is a place on the row that is meant.
struct RowEdit : EditRecord {
  enum class Action { move, add, remove, split, merge, renumber, note };

  Action action = Action::note;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // not for add
  std::optional<Eigen::Vector2d> from, to;       // move, add: the ends
  std::vector<Eigen::Vector2d> with;             // merge: places on the other rows
  std::string row_id;                            // renumber; add where given
  std::optional<double> was_angle_deg;           // what the person saw; a changed row is reported
  std::string text;                              // note
};

std::string_view action_name(RowEdit::Action action);  // "move", "add", "delete", ...

// A JSON list of objects, for instance
//   [{"action": "move", "at": [3, 7], "from": [0, 7.1], "to": [40, 7.4], "author": "A. Smith", "reason": "first vine is
//   a post"}]
// Throws Error{bad_input} that names the edit by its number: text that is no JSON, unknown keys or actions, and what an
// action needs and lacks.
std::vector<RowEdit> parse_row_edits(std::string_view json);

// The same list back: parse_row_edits(to_json(edits)) gives `edits`.
std::string to_json(const std::vector<RowEdit>& edits);

}  // namespace bole::rows
