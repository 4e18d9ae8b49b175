// What a person changed in a stem table: a list that is kept beside the pipeline and applied anew after every run.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/edit_list.h"

namespace bole::stems {

// `at`, `to`, `with` and `into` are plan positions at breast height in the axes of the stems, metres.
struct StemEdit : EditRecord {
  enum class Action { add, remove, move, resize, set_height, split, merge, accept, reject, note, set_species, tilt };
  struct Part {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double dbh_cm = 0;
  };

  Action action = Action::note;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // the stem that is meant, or the place of a new one
  std::optional<Eigen::Vector2d> to;             // move
  std::optional<double> dbh_cm;                  // resize; add and merge where given
  std::optional<double> was_dbh_cm;              // what the person saw: a changed fit is told
  std::optional<double> height_m;                // set_height; add where given
  std::vector<Part> into;                        // split
  std::vector<Eigen::Vector2d> with;             // merge: the other stems
  std::string text;                              // note
  std::string species;                           // set_species
  // tilt: from the vertical, and the direction that the stem leans towards, clockwise from north
  std::optional<double> lean_deg, lean_azimuth_deg;
};

std::string_view action_name(StemEdit::Action action);  // "add", "delete", ...

// A JSON list of objects, for instance
//   [{"action": "resize", "at": [3.2, 27.9], "dbh_cm": 23.4, "author": "A. Smith", "time": "2026-05-02T10:15:00Z",
//     "reason": "taped"}]
// Throws Error{bad_input} that names the edit by its number: text that is no JSON, unknown keys or actions, what an
// action needs and lacks, and sizes that no tree has.
std::vector<StemEdit> parse_stem_edits(std::string_view json);

// The same list back: parse_stem_edits(to_json(edits)) gives `edits`.
std::string to_json(const std::vector<StemEdit>& edits);

}  // namespace bole::stems
