// The place of a cloud that was brought onto another one, as the numbers of its panel.
#pragma once

#include "alignment/core/similarity.h"
#include "features/clouds/cloud_entry.h"

namespace bole::desktop {

// Where the cloud lies once `motion` has moved it from where it is shown.
CloudPlacing placed_after(const CloudEntry& cloud, const alignment::Similarity& motion);

}  // namespace bole::desktop
