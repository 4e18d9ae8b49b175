#include "vtkbridge/shared_arrays.h"

#include <map>
#include <mutex>

namespace bole::vtkbridge {
namespace {

struct KeptMemory {
  std::mutex mutex;
  std::multimap<const void*, std::shared_ptr<const void>> owners;
};

KeptMemory& kept_memory() {
  static auto* kept = new KeptMemory;  // NOLINT: outlives every VTK object, those freed at exit too
  return *kept;
}

}  // namespace

void keep_memory(const void* pointer, std::shared_ptr<const void> owner) {
  auto& kept = kept_memory();
  const std::lock_guard lock(kept.mutex);
  kept.owners.emplace(pointer, std::move(owner));
}

void release_memory(void* pointer) {
  auto& kept = kept_memory();
  std::shared_ptr<const void> last;  // destroyed outside the lock
  const std::lock_guard lock(kept.mutex);
  if (const auto it = kept.owners.find(pointer); it != kept.owners.end()) {
    last = std::move(it->second);
    kept.owners.erase(it);
  }
}

}  // namespace bole::vtkbridge
