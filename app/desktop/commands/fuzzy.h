// How well a few typed letters fit a text: "fab" finds "From above".
#pragma once

#include <QString>
#include <optional>

namespace bole::desktop {

// Larger is better; nothing when the letters do not occur in this order. Blanks in `typed` part words that may stand in
// any order. Letters at the beginnings of words and letters side by side count most.
std::optional<int> fuzzy_score(const QString& text, const QString& typed);

}  // namespace bole::desktop
