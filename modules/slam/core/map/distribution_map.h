// A map of point distributions on a pyramid of grids. Each cell keeps count, sum and second moments, so the surface at
// a place is found by merging the eight cells around it, in constant time and with every point averaged in. The caller
// goes from fine to coarse until there are enough points of the wanted shape, which adapts the neighbourhood to the
// density of the scan.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace bole::slam {

// The surface of the map around a place.
struct LocalSurface {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d deviations = Eigen::Vector3d::Zero();  // square roots of the eigenvalues of the covariance, ascending
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  // eigenvectors in columns: column 0 is the normal, column 2 the direction
  int points = 0;
  int lines = 0;  // number of scan lines that the points come from, where known; at most 16
  int level = 0;

  // How planar and how linear, 0 to 1 (Demantke et al. 2011, dimensionality features).
  double planarity() const { return (deviations[1] - deviations[0]) / deviations[2]; }
  double linearity() const { return (deviations[2] - deviations[1]) / deviations[2]; }
};

// A place to half a cell of the finest level. Places in the same half cell lie in the same cells of all levels and are
// nearest to the same corners, so the map has the same surfaces for them.
using HalfCell = Eigen::Matrix<std::int32_t, 3, 1>;

class DistributionMap {
 public:
  static constexpr int levels = 5;
  using CellNumbers = std::array<std::vector<std::uint32_t>, levels>;  // by level, of each of many points
  static constexpr std::uint16_t max_per_cell = 200;  // then the cell is full: early points hold against drift

  explicit DistributionMap(double finest_cell_size);

  void clear();
  // `line_bit`: one bit for the scan line of the point (see line_bit()), or 0.
  void insert(const Eigen::Vector3d& point, std::uint16_t line_bit = 0) { insert({&point, 1}, {&line_bit, 1}); }
  // Many at once, the levels in parallel. `line_bits` has one per point or is empty. Adds the numbers of their cells to
  // `numbers`.
  void insert(std::span<const Eigen::Vector3d> points, std::span<const std::uint16_t> line_bits = {},
              CellNumbers* numbers = nullptr);
  HalfCell half_cell(const Eigen::Vector3d& point) const {
    return (point / half_cell_size_).array().floor().cast<std::int32_t>();
  }
  // The points around a place on one level (the 2 x 2 x 2 nearest cells), where there are at least `min_points`.
  std::optional<LocalSurface> surface(const HalfCell& place, int level, int min_points = 8) const;
  std::optional<LocalSurface> surface(const Eigen::Vector3d& point, int level, int min_points = 8) const {
    return surface(half_cell(point), level, min_points);
  }
  // Calls for the memory that surface() of these places will want: together they wait for it about as long as one
  // alone.
  void call_for(std::span<const HalfCell> places, int level) const;
  // The points of one cell, by its number among cells(level), about its centre, where there are at least `min_points`.
  std::optional<LocalSurface> cell_surface(int level, std::size_t cell, int min_points = 8) const;
  // Of the cell that holds a place.
  Eigen::Vector3d centre_at(const HalfCell& place, int level) const;

  double cell_size(int level) const { return levels_[static_cast<std::size_t>(level)].cell_size; }
  std::size_t cells(int level) const { return levels_[static_cast<std::size_t>(level)].cells.size(); }
  bool empty() const { return levels_[0].cells.empty(); }

 private:
  // Moments about the centre of the cell. They are small there, so float32 is precise enough.
  struct Cell {
    std::uint16_t count = 0, lines = 0;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float second[6] = {0, 0, 0, 0, 0, 0};  // xx xy xz yy yz zz

    void add(const Eigen::Vector3f& from_centre, std::uint16_t line_bit);
  };
  // Memory that is not in the cache makes this slow. So cells are stored consecutively and found through blocks of 4 x
  // 4 x 4: the eight cells around a place need two look-ups of a block on average, not eight of a cell.
  struct Block {
    std::array<std::uint32_t, 64> cell{};  // 1 + index in `cells`; 0: none
  };
  struct Slot {
    std::uint64_t key = ~0ull;
    std::uint32_t block = 0;
  };
  struct Level {
    double cell_size = 0;
    std::vector<Slot> slots;  // open addressing, size a power of two
    std::vector<Block> blocks;
    std::vector<Cell> cells;

    // The block that a point was inserted into last: the next one mostly goes there too.
    std::uint64_t last_key = ~0ull;
    std::uint32_t last_block = 0;

    void clear();
    void insert(std::span<const Eigen::Vector3d> points, std::span<const std::uint16_t> line_bits,
                std::vector<std::uint32_t>* numbers);
    std::uint32_t block_at(std::uint64_t key);
    const Block* find_block(std::uint64_t key) const;
    std::array<const Cell*, 8> cells_about(const Eigen::Matrix<std::int64_t, 3, 1>& corner) const;
    void grow();
  };
  // Counts and moments of cells about a common place.
  struct Moments {
    int count = 0;
    unsigned lines = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // the lower triangle

    // `centre`: of the cell, relative to the common place.
    void add(const Cell& cell, const Eigen::Vector3d& centre);
    LocalSurface surface(const Eigen::Vector3d& place, int level) const;
  };

  std::vector<Level> levels_;
  double half_cell_size_;  // of the finest level
};

// A bit for the elevation (in bins of a third of a degree, modulo sixteen) at which a sensor at the origin sees a
// point.
inline std::uint16_t line_bit(const Eigen::Vector3f& point_in_sensor) {
  const float slope = point_in_sensor.z() / std::max(point_in_sensor.head<2>().norm(), 1e-3f);
  return static_cast<std::uint16_t>(1u << (static_cast<unsigned>(static_cast<int>(std::floor(172 * slope))) & 15u));
}

}  // namespace bole::slam
