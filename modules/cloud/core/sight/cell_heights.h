// Lowest and highest points per square cell of the plan. Stray points below the ground and above the crowns do not
// count: a fiftieth of the cell lies within 0.3 m behind the point that does. Cells with next to no points are stray as
// a whole.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bole {
inline namespace cloud {
namespace sight {

class CellHeights {
 public:
  CellHeights(const std::vector<Eigen::Vector3f>& points, double cell_m);

  std::size_t size() const { return cells_.size(); }
  double area_m2() const { return static_cast<double>(size()) * cell_m_ * cell_m_; }

  // The lowest of the cells around a place. NaN where there are none, or stray points only.
  float low_around(double x, double y, int cells) const;

  // The median of the lowest points of the cells around, so that a stray point below does not count.
  double ground_around(double x, double y, int cells) const;

  // Share of the cells whose height lies on the straight line between the heights on both sides: a surface that goes
  // on, whatever its slope.
  double continuing_share(bool top) const;

 private:
  struct Cell {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    std::uint32_t count = 0;
  };
  int index(double v) const;
  const Cell* find(int ix, int iy) const;

  double cell_m_;
  double min_count_ = 0;  // points of a cell that counts
  std::unordered_map<std::uint64_t, Cell> cells_;
};

// Cells of a metre, larger where a cloud is so wide or so sparse that few of them would hold points. m.
double cell_size_m(const std::vector<Eigen::Vector3f>& points, int axis);

}  // namespace sight
}  // namespace cloud
}  // namespace bole
