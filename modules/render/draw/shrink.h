// Pictures that were drawn larger than they are needed, for smooth edges.
#pragma once

#include <cstdint>
#include <span>

#include "render/draw/canvas.h"

namespace bole::render {

// Means of squares of `samples` x `samples` pixels; `rgb` has three bytes for each of `samples` times the width and
// height, rows from below, the picture rows from the top.
Image shrunk(std::span<const std::uint8_t> rgb, int width, int height, int samples);

}  // namespace bole::render
