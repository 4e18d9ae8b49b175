// Whether this machine has enough memory for a cloud.
#pragma once

#include <cstddef>
#include <string>

namespace bole::io {

// Memory available to programs, bytes. 0 when the system does not report it.
std::size_t available_memory_bytes();

// A warning where the stages of a plot (terrain, stems) will need more memory than is available: how much, and what to
// do. Empty when there is enough or nothing is known.
std::string memory_advice(std::size_t points, std::size_t available_bytes);

}  // namespace bole::io
