// What an edit is called in the menu Edit and in the history.
#pragma once

#include <QString>
#include <vector>

#include "cloud/core/regions/point_edits.h"
#include "plant/core/edits/plant_edits.h"
#include "rows/core/edits/row_edits.h"
#include "slam/core/edits/loop_edits.h"
#include "stems/core/edits/stem_edits.h"

namespace bole::desktop {

// "accept stem", "reject stem (3)".
QString edit_words(const std::vector<stems::StemEdit>& edits);
QString edit_words(const std::vector<rows::RowEdit>& edits);
QString edit_words(const std::vector<plant::PlantEdit>& edits);
QString edit_words(const std::vector<slam::LoopEdit>& edits);
QString edit_words(const std::vector<PointEdit>& edits);

}  // namespace bole::desktop
