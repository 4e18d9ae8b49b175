// Things joined pair by pair into groups (union-find).
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace bole {
inline namespace base {

class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t size() const { return parent_.size(); }

  // The smallest member of the group of `i`, by which the group is known.
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

  bool together(std::size_t a, std::size_t b) { return root(a) == root(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace base
}  // namespace bole
