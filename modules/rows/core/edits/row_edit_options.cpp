#include "rows/core/edits/apply_row_edits.h"

namespace bole::rows {

const OptionTable& option_table(const RowEditOptions*) {
  using S = RowEditOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"edits",
                             &S::edits,
                             TextKind::json,
                             {},
                             Tier::basic,
                             "The edits as a JSON list, applied after those of the file."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::basic, "A file with a JSON list of edits."},
      Option<S, double>{"match_distance",
                        &S::match_distance,
                        Unit::metre,
                        {0.01, 100},
                        Tier::advanced,
                        "An edit belongs to the nearest row when that passes no further away than this."},
      Option<S, double>{"reach",
                        &S::reach,
                        Unit::metre,
                        {0, 100},
                        Tier::advanced,
                        "A drawn row takes the plants in no row that stand no further from it."},
      Option<S, double>{"doubt_deg",
                        &S::doubt_deg,
                        Unit::degree,
                        {0, 90},
                        Tier::advanced,
                        "A direction that differs by more than this from was_angle_deg of an edit is told."},
      Option<S, std::string>{"fit",
                             &S::fit,
                             TextKind::choice,
                             {"least_squares", "orthogonal"},
                             Tier::advanced,
                             "How changed rows are fitted; see rows.from_stems."},
  });
  return table;
}

}  // namespace bole::rows
