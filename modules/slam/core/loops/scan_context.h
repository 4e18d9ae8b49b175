// Scan Context: what the surroundings look like from a place, as a small matrix that can be compared with others. Kim
// and Kim 2018 (polar context: found again at any heading) and Kim, Choi and Kim 2021, "Scan Context++" (cart context:
// found again from a path that runs beside the first one).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace bole::slam {

struct ScanContextShape {
  int rings = 20, sectors = 60;
  double range_m = 40;
  // The cart context: bins ahead and astern by bins abeam, over the square of half side range_m.
  int rows = 20, columns = 40;
};

struct ScanContext {
  Eigen::MatrixXf polar;        // rings x sectors: greatest height over `lowest_m`, 0 where nothing is
  Eigen::MatrixXf cart;         // rows (along the heading) x columns (across it)
  std::vector<float> ring_key;  // share of sectors that are taken, per ring: the same at any heading
  std::vector<float> cart_key;  // share of columns that are taken, per row: the same at any offset abeam
  bool empty() const { return polar.size() == 0; }
};

// `points` in levelled axes: origin at the sensor, x along its heading, z up. Points more than 2 m below the sensor
// (the ground ahead of a bearer) count as 0.
ScanContext make_scan_context(const std::vector<Eigen::Vector3f>& points, const ScanContextShape& shape);

struct ContextMatch {
  double distance = 1;  // 1 - cosine, averaged over the columns that both have: 0 alike, 1 nothing in common
  int shift = 0;        // columns by which `b` is moved to lie on `a`
};

// Over all turns; `b` seen in the axes of `a` is turned by 2 pi shift / sectors about z.
ContextMatch match_polar(const ScanContext& a, const ScanContext& b);
// Over turns of first_shift to last_shift sectors only, which may be negative: where the heading is known about.
ContextMatch match_polar(const ScanContext& a, const ScanContext& b, int first_shift, int last_shift);
// Over offsets abeam of up to a quarter of the width; `b` lies 2 range_m / columns * shift to the left in the axes of
// `a`. With `reversed`, `b` is turned about by 180 deg first: the same lane walked the other way.
ContextMatch match_cart(const ScanContext& a, const ScanContext& b, bool reversed);

// The cart key of the same place seen with the opposite heading.
std::vector<float> reversed_key(const std::vector<float>& cart_key);

}  // namespace bole::slam
