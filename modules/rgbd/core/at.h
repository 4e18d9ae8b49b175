// Indices of our vectors from the integers that OpenCV and Ceres count with.
#pragma once

#include <cstddef>

namespace bole::rgbd {

// i >= 0.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace bole::rgbd
