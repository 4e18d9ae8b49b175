// Rows as a person edits them: an id, a course, the plants, and ends where they were given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rows/core/edits/apply_row_edits.h"
#include "rows/core/rows/plant_grid.h"

namespace bole::rows {

struct RowEnds {
  Eigen::Vector2d from, to;
};

struct EditableRow {
  std::string id;
  Points2 course;                          // vertices of its guidance line, two or more
  double angle_rad = 0;                    // of its line with due east
  std::vector<int> plants;                 // indices into EditableRows::plants
  std::optional<RowEnds> ends;             // given by a person
  std::string found_id;                    // of the row that was found; empty for a drawn one
  bool edited = false, replanted = false;  // replanted: its plants are others, so that it is measured anew
};

struct EditableRows {
  std::vector<EditableRow> rows;
  Points2 plants;  // present ones, then the strays
  Table sources;   // x_m, y_m and tree_id of the plants, where the tables have it
};

// Throws Error{bad_input} for tables without the columns of find_rows.
EditableRows editable_rows(const FoundRows& found);

// Why an edit cannot be applied.
struct EditConflict {
  std::string why;
};

struct EditOutcome {
  std::string row_id;  // of the row that was meant; empty where none was
  std::string note;    // a warning about an edit that was applied
};

// Changes the row at the place of the edit, or throws EditConflict and changes nothing.
EditOutcome apply_row_edit(EditableRows& rows, const RowEdit& edit, const RowEditOptions& options);

// "0", "17": ids that tables keep as numbers and read back as they were.
bool is_whole_number(const std::string& id);

}  // namespace bole::rows
