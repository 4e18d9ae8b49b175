#include "behaviors/edit_behavior.h"

#include "behaviors/edit_list.h"

namespace bole::desktop {

void EditBehavior::apply(std::vector<stems::StemEdit> edits) {
  add_edits(session_, "stems.edit", parse_stem_edits, std::move(edits));
  Q_EMIT applied();
}

}  // namespace bole::desktop
