// One-to-one matching of points in the plane.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace bole::evaluation {

struct Pairing {
  std::size_t left = 0, right = 0;
  double cost = 0;
};

// As many pairs as possible, and among those sets the one of least total cost, of the pairs offered (Kuhn 1955, in the
// O(n^3) form with potentials, for each connected group by itself). Each left and right index is used at most once; the
// result is sorted by left.
std::vector<Pairing> assign_pairs(const std::vector<Pairing>& offered);

}  // namespace bole::evaluation
