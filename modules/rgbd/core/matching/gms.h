// Grid-based motion statistics: a match is kept where its neighbours move along with it (Bian et al. 2017).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace bole::rgbd {

struct PixelPair {
  Eigen::Vector2d a, b;
};

struct ImageSize {
  int width = 0, height = 0;
};

// For each pair, whether it is supported: the matches that lead from the 3 x 3 cells around it in `a` to the 3 x 3
// cells around its place in `b`, the second turned and scaled by the best of some steps, are more than a threshold
// that grows with the root of their density. Grids are as fine as the number of pairs allows.
std::vector<char> supported_by_neighbours(const std::vector<PixelPair>& pairs, const ImageSize& size_a,
                                          const ImageSize& size_b);

}  // namespace bole::rgbd
