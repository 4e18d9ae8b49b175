// The size of a pixel, for pictures drawn true to scale.
#pragma once

namespace bole::desktop {

// Of a widget's own pixels: Qt counts 96 to the inch, whatever the screen is.
inline constexpr double mm_per_px = 25.4 / 96;

}  // namespace bole::desktop
