#include "ground/core/columns.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace bole::ground {
namespace {

constexpr double max_gap_m = 0.30;     // along a column
constexpr double min_height_m = 1.2;   // of a column
constexpr double window_low_m = 0.2;   // above its foot, where its density is compared
constexpr double window_high_m = 1.7;  // likewise
constexpr std::size_t min_column_points = 15;
constexpr double min_contrast = 4;
constexpr int near_cells = 2;  // what is as near belongs to the same structure
constexpr int far_cells = 4;   // from near_cells to here it is compared with what is beside it

class ColumnFinder {
 public:
  ColumnFinder(const PointCloud& cloud, const PointGrid& grid, const Run& run)
      : cloud_(cloud), grid_(grid), shape_(grid.shape()), run_(run), column_(shape_.cells()) {}

  std::vector<UprightColumn> find() {
    for_each_cell([&](std::size_t c) { column_[c] = lowest_run(c); });
    std::vector<char> stands_out(shape_.cells(), 0);
    for_each_cell([&](std::size_t c) { stands_out[c] = is_upright(c); });
    for (std::size_t c = 0; c < shape_.cells(); ++c)
      if (!stands_out[c]) column_[c].points = 0;
    std::vector<UprightColumn> out;
    for (std::size_t c = 0; c < shape_.cells(); ++c)
      if (column_[c].points > 0 && is_strongest(c)) out.push_back(structure_at(c));
    return out;
  }

 private:
  struct Column {
    double foot = 0, top = 0;
    std::size_t points = 0;                             // in the window; 0: no column
    Eigen::Vector2d at_foot = Eigen::Vector2d::Zero();  // mean of the lowest points
  };

  template <class F>
  void for_each_cell(const F& f) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, shape_.cells(), 1024), [&](const auto& range) {
      run_.check_cancel();
      for (std::size_t c = range.begin(); c < range.end(); ++c) f(c);
    });
  }

  double z(std::uint32_t point) const { return static_cast<double>(cloud_.positions()[point].z()); }

  std::size_t count_between(std::size_t cell, double low, double high) const {
    const auto points = grid_.points(cell);
    const auto below = [&](std::uint32_t i, double at) { return z(i) < at; };
    return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), high, below) -
                                    std::lower_bound(points.begin(), points.end(), low, below));
  }

  // The lowest stretch of a cell that is tall enough. A stray point or two below it do not belong to it.
  Column lowest_run(std::size_t cell) const {
    const auto points = grid_.points(cell);
    Column out;
    for (std::size_t begin = 0; begin + min_column_points <= points.size();) {
      std::size_t end = begin + 1;
      while (end < points.size() && z(points[end]) - z(points[end - 1]) <= max_gap_m) ++end;
      const std::size_t first = std::min(begin + 2, end - 1);
      const double foot = z(points[first]), top = z(points[end - 1]);
      if (end - begin >= min_column_points && top - foot >= min_height_m) {
        out.foot = foot;
        out.top = top;
        out.points = count_between(cell, foot + window_low_m, foot + window_high_m);
        std::size_t k = begin;
        for (; k < end && z(points[k]) <= foot + 0.1; ++k)
          out.at_foot += cloud_.positions()[points[k]].head<2>().cast<double>();
        out.at_foot /= static_cast<double>(k - begin);
        return out;
      }
      begin = end;
    }
    return out;
  }

  // f(cell, distance in cells) around (ix, iy), itself apart.
  template <class F>
  void around(std::size_t cell, int reach, const F& f) const {
    const int ix = static_cast<int>(cell % static_cast<std::size_t>(shape_.nx)),
              iy = static_cast<int>(cell / static_cast<std::size_t>(shape_.nx));
    for (int jy = std::max(0, iy - reach); jy <= std::min(shape_.ny - 1, iy + reach); ++jy)
      for (int jx = std::max(0, ix - reach); jx <= std::min(shape_.nx - 1, ix + reach); ++jx)
        if (jx != ix || jy != iy) f(shape_.index(jx, jy), std::max(std::abs(jx - ix), std::abs(jy - iy)));
  }

  bool is_upright(std::size_t cell) const {
    const auto& c = column_[cell];
    if (c.points < min_column_points / 2) return false;
    std::size_t beside = 0;
    int cells = 0;
    around(cell, far_cells, [&](std::size_t other, int distance) {
      if (distance <= near_cells) return;
      beside += count_between(other, c.foot + window_low_m, c.foot + window_high_m);
      ++cells;
    });
    return static_cast<double>(c.points) * cells > min_contrast * static_cast<double>(beside);
  }

  bool is_strongest(std::size_t cell) const {
    bool strongest = true;
    around(cell, near_cells, [&](std::size_t other, int) {
      const auto n = column_[other].points;
      if (n > column_[cell].points || (n == column_[cell].points && n > 0 && other < cell)) strongest = false;
    });
    return strongest;
  }

  // The lowest foot of its cells: a leaning stem leaves a cell above the ground of the next.
  UprightColumn structure_at(std::size_t cell) const {
    Column lowest = column_[cell];
    around(cell, near_cells, [&](std::size_t other, int) {
      const auto& o = column_[other];
      if (o.points > 0 && o.foot < lowest.foot && o.top > column_[cell].foot) lowest = o;
    });
    return {{lowest.at_foot.x(), lowest.at_foot.y(), lowest.foot}, std::max(lowest.top, column_[cell].top)};
  }

  const PointCloud& cloud_;
  const PointGrid& grid_;
  const GridShape& shape_;
  const Run& run_;
  std::vector<Column> column_;
};

}  // namespace

std::vector<UprightColumn> upright_columns(const PointCloud& cloud, const PointGrid& grid, const Run& run) {
  return ColumnFinder(cloud, grid, run).find();
}

}  // namespace bole::ground
