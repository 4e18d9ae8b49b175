#include "slam/core/edits/apply_loop_edits.h"

namespace bole::slam {

const OptionTable& option_table(const LoopEditOptions*) {
  using S = LoopEditOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{
          "edits", &S::edits, TextKind::json, {}, Tier::basic, "JSON list of edits, applied after those of the file."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::basic, "File with a JSON list of edits."},
      Option<S, int>{"match_frames",
                     &S::match_frames,
                     Unit::none,
                     {0, 1000},
                     Tier::advanced,
                     "Largest difference between the frames of an edit and those of the loop closure that it means."},
  });
  return table;
}

}  // namespace bole::slam
