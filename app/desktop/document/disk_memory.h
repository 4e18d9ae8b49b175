// How much memory the window takes for the points of clouds that it shows from the disk.
#pragma once

#include <array>
#include <cstddef>

namespace bole::desktop {

inline constexpr std::array<int, 5> disk_memory_choices_mib{256, 512, 1024, 2048, 4096};
inline constexpr int default_disk_memory_mib = 1024;

int disk_memory_mib();  // as the person chose it
void save_disk_memory_mib(int mib);
inline std::size_t disk_memory_bytes() { return static_cast<std::size_t>(disk_memory_mib()) << 20; }

}  // namespace bole::desktop
