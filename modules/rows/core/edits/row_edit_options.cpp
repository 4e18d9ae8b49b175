#include "rows/core/edits/apply_row_edits.h"

namespace bole::rows {

const OptionTable& option_table(const RowEditOptions*) {
  using S = RowEditOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{
          "edits", &S::edits, TextKind::json, {}, Tier::basic, "JSON list of edits, applied after those of the file."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::basic, "File with a JSON list of edits."},
      Option<S, double>{"match_distance",
                        &S::match_distance,
                        Unit::metre,
                        {0.01, 100},
                        Tier::advanced,
                        "Largest distance between the place of an edit and the row that it changes."},
      Option<S, double>{"reach",
                        &S::reach,
                        Unit::metre,
                        {0, 100},
                        Tier::advanced,
                        "Largest distance of a stray plant from a drawn row that takes it in."},
      Option<S, double>{"angle_tolerance",
                        &S::angle_tolerance_deg,
                        Unit::degree,
                        {0, 90},
                        Tier::advanced,
                        "A row whose direction differs from was_angle_deg of an edit by more than this is reported."},
      Option<S, LineFitMethod>{"fit", &S::fit, Tier::advanced, "Line fit of changed rows, as in rows.from_stems."},
  });
  return table;
}

}  // namespace bole::rows
