#include "io/core/clouds/memory_advice.h"

#include <fmt/format.h>

#include <fstream>

namespace bole::io {
namespace {

// Memory per point without the columns that lie on file (docs/dev/diameters.md, speed and memory): its coordinates once
// it is read, and with grids, heights and labels while stems are measured.
constexpr double bytes_once_read = 12;
constexpr double bytes_at_work = 36;

}  // namespace

std::size_t available_memory_bytes() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  std::size_t kib = 0;
  while (file >> name >> kib) {
    if (name == "MemAvailable:") return kib << 10;
    std::getline(file, unit);
  }
  return 0;
}

std::string memory_advice(std::size_t points, std::size_t available_bytes) {
  const double count = static_cast<double>(points);
  if (available_bytes == 0 || count * (bytes_at_work - bytes_once_read) <= static_cast<double>(available_bytes))
    return {};
  constexpr double gib = 1U << 30;
  return fmt::format(
      "{:.0f} million points: terrain and stems need about {:.0f} GiB of memory in all, and {:.1f} GiB are free beside "
      "the points. If the run ends for lack of memory, cut the plot into parts that overlap by 20 m, or thin the file",
      1e-6 * count, count * bytes_at_work / gib, static_cast<double>(available_bytes) / gib);
}

}  // namespace bole::io
