#include "cloud/voxels.h"

#include <algorithm>
#include <numeric>

namespace bole {
inline namespace cloud {
namespace {

class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The smaller index becomes the root, so that groups are numbered by their first member.
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::uint32_t> connected_groups(const std::vector<std::uint64_t>& keys) {
  Groups groups(keys.size());
  for (int dz = 0; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::int64_t step = (static_cast<std::int64_t>(dz) << 42) + (static_cast<std::int64_t>(dy) << 21) + dx;
        if (step <= 0) continue;  // each pair is met once
        // Both ascend, so one sweep finds all pairs.
        std::size_t j = 0;
        for (std::size_t i = 0; i < keys.size(); ++i) {
          const std::uint64_t wanted = keys[i] + static_cast<std::uint64_t>(step);
          while (j < keys.size() && keys[j] < wanted) ++j;
          if (j < keys.size() && keys[j] == wanted)
            groups.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
      }
  std::vector<std::uint32_t> number(keys.size());
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < keys.size(); ++i) number[i] = groups.root(i) == i ? next++ : number[groups.root(i)];
  return number;
}

}  // namespace cloud
}  // namespace bole
