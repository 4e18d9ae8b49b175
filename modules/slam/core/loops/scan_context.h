// Scan Context: the surroundings of a place as a small matrix that can be compared with others. Kim and Kim 2018 (polar
// context: recognised at any heading) and Kim, Choi and Kim 2021, "Scan Context++" (cart context: recognised from a
// parallel path).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam/core/choices.h"

namespace bole::slam {

struct ScanContextShape {
  int rings = 20, sectors = 60;
  double range = 40;
  // Cart context: bins along the heading by bins across it, over the square of half side `range`.
  int rows = 20, columns = 40;
};

struct ScanContext {
  Eigen::MatrixXf polar;        // greatest height above `lowest`, 0 where there are no points
  Eigen::MatrixXf cart;         // rows (along the heading) x columns (across it)
  std::vector<float> ring_key;  // share of occupied sectors per ring: the same at any heading
  std::vector<float> cart_key;  // share of occupied columns per row: the same at any sideways offset
  bool empty() const { return polar.size() == 0; }
};

// `points` in levelled axes: origin at the sensor, x along its heading, z up. Points more than 2 m below the sensor
// (the ground in front of a person) count as 0.
ScanContext make_scan_context(const std::vector<Eigen::Vector3f>& points, const ScanContextShape& shape);

struct ContextMatch {
  double distance = 1;  // 1 - cosine, averaged over columns: 0 the same, 1 nothing in common
  int shift = 0;        // columns by which `b` is moved to lie on `a`
};

// The columns that count. shared_sectors: those that both have, and the distance is 1 where these are few. all_sectors:
// SPEC D, equation 4, d = 1/N_s sum (1 - c_a . c_b / |c_a| |c_b|). The cosine with an empty column is 0/0 there; here
// it is 0 where one column is empty and 1 where both are, so that a context has no distance to itself. Over all turns.
// `b` seen in the axes of `a` is turned by 2 pi shift / sectors about z.
ContextMatch match_polar(const ScanContext& a, const ScanContext& b,
                         ContextDistance columns = ContextDistance::shared_sectors);
// Over turns of first_shift to last_shift sectors only, which may be negative: where the heading is roughly known.
ContextMatch match_polar(const ScanContext& a, const ScanContext& b, int first_shift, int last_shift,
                         ContextDistance columns = ContextDistance::shared_sectors);
// Over sideways offsets of up to a quarter of the width. `b` lies 2 range / columns * shift to the left in the axes of
// `a`. With `reversed`, `b` is turned by 180 deg first: the same lane in the other direction.
ContextMatch match_cart(const ScanContext& a, const ScanContext& b, bool reversed,
                        ContextDistance columns = ContextDistance::shared_sectors);

// The cart key of the same place with the opposite heading.
std::vector<float> reversed_key(const std::vector<float>& cart_key);

}  // namespace bole::slam
