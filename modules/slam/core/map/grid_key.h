// Integer grid cells packed into one 64-bit key, and a small open-addressing set of them.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bole::slam {

// 21 bits per axis: +-1 M cells (100 km at 0.1 m). Beyond that keys wrap around.
inline std::uint64_t pack_cell(std::int64_t ix, std::int64_t iy, std::int64_t iz) {
  constexpr std::int64_t half = 1 << 20;
  constexpr std::uint64_t mask = (1u << 21) - 1;
  return ((static_cast<std::uint64_t>(ix + half) & mask) << 42) |
         ((static_cast<std::uint64_t>(iy + half) & mask) << 21) | (static_cast<std::uint64_t>(iz + half) & mask);
}

// The cell of a point given in units of the cell.
template <class Vector>
std::uint64_t grid_key(const Vector& p_in_cells) {
  return pack_cell(static_cast<std::int64_t>(std::floor(p_in_cells.x())),
                   static_cast<std::int64_t>(std::floor(p_in_cells.y())),
                   static_cast<std::int64_t>(std::floor(p_in_cells.z())));
}

// Mixes the bits (finalizer of MurmurHash3).
inline std::uint64_t mix_bits(std::uint64_t k) {
  k ^= k >> 33;
  k *= 0xff51afd7ed558ccdull;
  k ^= k >> 33;
  k *= 0xc4ceb9fe1a85ec53ull;
  return k ^ (k >> 33);
}

// A set of keys with room for a known number of them.
class GridKeySet {
 public:
  explicit GridKeySet(std::size_t max_keys)
      : slots_(std::bit_ceil(2 * max_keys + 2), empty), mask_(slots_.size() - 1) {}

  // False when the key was there already.
  bool insert(std::uint64_t key) {
    for (std::size_t i = mix_bits(key) & mask_;; i = (i + 1) & mask_) {
      if (slots_[i] == key) return false;
      if (slots_[i] == empty) {
        slots_[i] = key;
        return true;
      }
    }
  }

 private:
  static constexpr std::uint64_t empty = ~0ull;  // packed cells have 63 bits
  std::vector<std::uint64_t> slots_;
  std::size_t mask_;
};

}  // namespace bole::slam
