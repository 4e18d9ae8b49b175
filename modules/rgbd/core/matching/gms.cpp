#include "rgbd/core/matching/gms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace bole::rgbd {
namespace {

constexpr double pairs_per_cell = 5;
constexpr int min_cells = 3, max_cells = 20;  // across
constexpr double threshold_factor = 4;        // the paper has 6 for ten times as many matches, of which more are wrong
constexpr std::array<double, 3> scales{1, 0.7, 1.4};

// The eight neighbours of a cell, clockwise from the upper left; a turn by 45 degrees moves on by one.
constexpr std::array<std::array<int, 2>, 8> around{
    {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};

struct Grid {
  int nx = 1, ny = 1;
  double cell_x = 1, cell_y = 1, shift = 0;

  Grid(const ImageSize& size, double cells, double by) : shift(by) {
    nx = std::max(min_cells, static_cast<int>(std::lround(cells)));
    ny = std::max(min_cells, static_cast<int>(std::lround(cells * size.height / std::max(1, size.width))));
    cell_x = static_cast<double>(size.width) / nx;
    cell_y = static_cast<double>(size.height) / ny;
    ++nx, ++ny;  // shifted grids reach over the edge
  }
  int cell_of(const Eigen::Vector2d& p) const {
    const int x = std::clamp(static_cast<int>((p.x() + 0.5) / cell_x + shift), 0, nx - 1);
    const int y = std::clamp(static_cast<int>((p.y() + 0.5) / cell_y + shift), 0, ny - 1);
    return y * nx + x;
  }
  int neighbour(int cell, std::size_t k) const {
    const int x = cell % nx + around[k][0], y = cell / nx + around[k][1];
    return x >= 0 && y >= 0 && x < nx && y < ny ? y * nx + x : -1;
  }
};

class Votes {
 public:
  Votes(const std::vector<PixelPair>& pairs, const Grid& a, const Grid& b) : a_(a), b_(b) {
    in_a_.assign(static_cast<std::size_t>(a.nx) * static_cast<std::size_t>(a.ny), 0);
    for (const auto& p : pairs) {
      const int ca = a.cell_of(p.a), cb = b.cell_of(p.b);
      cells_.emplace_back(ca, cb);
      ++in_a_[static_cast<std::size_t>(ca)];
      ++count_[key(ca, cb)];
    }
  }

  // Marks the pairs that are supported with the neighbours of `b` turned by 45 degrees `turn` times.
  void mark(int turn, std::vector<char>& supported) const {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (supported[i]) continue;
      const auto [ca, cb] = cells_[i];
      int sum = votes(ca, cb) - 1;  // a match is no support of itself
      int cells = 1, present = in_a_[static_cast<std::size_t>(ca)];
      for (std::size_t k = 0; k < around.size(); ++k) {
        const int na = a_.neighbour(ca, k);
        const int nb = b_.neighbour(cb, (k + static_cast<std::size_t>(turn)) % around.size());
        if (na < 0 || nb < 0) continue;
        sum += votes(na, nb);
        present += in_a_[static_cast<std::size_t>(na)];
        ++cells;
      }
      supported[i] = sum >= threshold_factor * std::sqrt(static_cast<double>(present) / cells);
    }
  }

 private:
  static std::int64_t key(int a, int b) { return (static_cast<std::int64_t>(a) << 32) + b; }
  int votes(int a, int b) const {
    const auto it = count_.find(key(a, b));
    return it == count_.end() ? 0 : it->second;
  }

  const Grid a_, b_;
  std::vector<int> in_a_;
  std::vector<std::pair<int, int>> cells_;
  std::unordered_map<std::int64_t, int> count_;
};

}  // namespace

std::vector<char> supported_by_neighbours(const std::vector<PixelPair>& pairs, const ImageSize& size_a,
                                          const ImageSize& size_b) {
  std::vector<char> supported(pairs.size(), 0);
  if (pairs.empty()) return supported;
  const double aspect = static_cast<double>(size_a.width) / std::max(1, size_a.height);
  const double cells = std::clamp(std::sqrt(static_cast<double>(pairs.size()) / pairs_per_cell * aspect),
                                  static_cast<double>(min_cells), static_cast<double>(max_cells));
  for (const double scale : scales)
    for (const double shift : {0.0, 0.5})  // a match at the edge of a cell is in the middle of another one
    {
      const Votes votes(pairs, Grid(size_a, cells, shift), Grid(size_b, cells * scale, shift));
      for (int turn = 0; turn < 8; ++turn) votes.mark(turn, supported);
    }
  return supported;
}

}  // namespace bole::rgbd
