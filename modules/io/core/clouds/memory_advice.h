// Whether the memory of this machine will do for a cloud.
#pragma once

#include <cstddef>
#include <string>

namespace bole::io {

// Memory that programs can still have, bytes; 0 when the system does not tell.
std::size_t available_memory_bytes();

// What to tell about a cloud that was read, when the stages of a plot (terrain, stems) will need more than is
// available: how much and what to do. Empty when it will do or nothing is known.
std::string memory_advice(std::size_t points, std::size_t available_bytes);

}  // namespace bole::io
