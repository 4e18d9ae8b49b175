// Squares that a large cloud is worked on in: half-open cores side by side, each with a buffer around it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace bole::io {

struct TilePlace {
  int column = 0, row = 0;
  bool operator==(const TilePlace&) const = default;
  bool operator<(const TilePlace& o) const { return row != o.row ? row < o.row : column < o.column; }
};

// Cores begin at multiples of tile_m from `origin`, in the coordinates of the files.
struct TileGrid {
  double tile_m = 50, buffer_m = 10;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();

  TilePlace at(const Eigen::Vector2d& p) const { return {index(p.x(), origin.x()), index(p.y(), origin.y())}; }
  Eigen::AlignedBox2d core(const TilePlace& place) const {
    const Eigen::Vector2d low = origin + tile_m * Eigen::Vector2d(place.column, place.row);
    return {low, low + Eigen::Vector2d::Constant(tile_m)};
  }
  // Calls f(place) for every tile whose core or buffer holds the point.
  template <class F>
  void for_each_over(const Eigen::Vector2d& p, F&& f) const {
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(buffer_m);
    const TilePlace first = at(p - reach), last = at(p + reach);
    for (int row = first.row; row <= last.row; ++row)
      for (int column = first.column; column <= last.column; ++column) f(TilePlace{column, row});
  }

 private:
  // Coordinates of a broken header must not leave the numbers of tiles.
  int index(double v, double begin) const {
    return static_cast<int>(std::clamp(std::floor((v - begin) / tile_m), -1e9, 1e9));
  }
};

inline std::string tile_name(const TilePlace& place) {
  return "c" + std::to_string(place.column) + "r" + std::to_string(place.row);
}

}  // namespace bole::io
