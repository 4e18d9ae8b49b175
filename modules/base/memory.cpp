#include "base/memory.h"

#include <sys/resource.h>

namespace bole {
inline namespace base {

double peak_resident_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace base
}  // namespace bole
