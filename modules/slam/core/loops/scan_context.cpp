#include "slam/core/loops/scan_context.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::slam {
namespace {

constexpr float lowest = -2;
constexpr float min_height = 0.05f;  // so that an occupied cell is never 0
constexpr double min_shared = 0.3;   // of the columns that either has

// Mean cosine distance of the columns with `b` moved by `shift`. The columns wrap around with `wrap`, and are cut off
// without.
double column_distance(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b, const std::vector<float>& norm_a,
                       const std::vector<float>& norm_b, int shift, bool wrap, bool reversed, ContextDistance columns) {
  const int n = static_cast<int>(a.cols());
  double sum = 0;
  int shared = 0, either = 0;
  for (int j = 0; j < n; ++j) {
    int k = j - shift;
    if (wrap) k = ((k % n) + n) % n;
    const bool inside = k >= 0 && k < n;
    const int from = reversed ? n - 1 - k : k;
    const float na = norm_a[static_cast<std::size_t>(j)], nb = inside ? norm_b[static_cast<std::size_t>(from)] : 0;
    either += na > 0 || nb > 0;
    if (na <= 0 || nb <= 0) continue;
    const float dot = reversed ? a.col(j).dot(b.col(from).reverse()) : a.col(j).dot(b.col(from));
    sum += 1 - dot / (na * nb);
    ++shared;
  }
  if (columns == ContextDistance::all_sectors) return n > 0 ? (sum + either - shared) / n : 1;
  return shared > 0 && shared >= min_shared * either ? sum / shared : 1;
}

std::vector<float> column_norms(const Eigen::MatrixXf& m) {
  std::vector<float> norms(static_cast<std::size_t>(m.cols()));
  for (Eigen::Index j = 0; j < m.cols(); ++j) norms[static_cast<std::size_t>(j)] = m.col(j).norm();
  return norms;
}

std::vector<float> occupancy_of_rows(const Eigen::MatrixXf& m) {
  std::vector<float> key(static_cast<std::size_t>(m.rows()));
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    key[static_cast<std::size_t>(i)] =
        static_cast<float>((m.row(i).array() > 0).count()) / static_cast<float>(m.cols());
  return key;
}

template <class Distance>
ContextMatch best_shift(int first, int last, const Distance& distance) {
  ContextMatch best{2, 0};
  for (int shift = first; shift <= last; ++shift)
    if (const double d = distance(shift); d < best.distance) best = {d, shift};
  return best;
}

}  // namespace

ScanContext make_scan_context(const std::vector<Eigen::Vector3f>& points, const ScanContextShape& shape) {
  ScanContext out;
  out.polar = Eigen::MatrixXf::Zero(shape.rings, shape.sectors);
  out.cart = Eigen::MatrixXf::Zero(shape.rows, shape.columns);
  const auto range = static_cast<float>(shape.range);
  const auto raise = [](float& cell, float height) { cell = std::max(cell, height); };
  for (const auto& p : points) {
    const float r = p.head<2>().norm(), height = std::max(p.z() - lowest, min_height);
    if (!(r < range)) continue;
    float turn = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi_v<float>);
    turn -= std::floor(turn);
    raise(out.polar(std::min(shape.rings - 1, static_cast<int>(r / range * static_cast<float>(shape.rings))),
                    std::min(shape.sectors - 1, static_cast<int>(turn * static_cast<float>(shape.sectors)))),
          height);
    const auto bin = [&](float v, int bins) {
      return std::clamp(static_cast<int>((v / range + 1) * 0.5f * static_cast<float>(bins)), 0, bins - 1);
    };
    raise(out.cart(bin(p.x(), shape.rows), bin(p.y(), shape.columns)), height);
  }
  out.ring_key = occupancy_of_rows(out.polar);
  out.cart_key = occupancy_of_rows(out.cart);
  return out;
}

ContextMatch match_polar(const ScanContext& a, const ScanContext& b, ContextDistance columns) {
  return match_polar(a, b, 0, static_cast<int>(a.polar.cols()) - 1, columns);
}

ContextMatch match_polar(const ScanContext& a, const ScanContext& b, int first_shift, int last_shift,
                         ContextDistance columns) {
  const auto na = column_norms(a.polar), nb = column_norms(b.polar);
  return best_shift(first_shift, last_shift,
                    [&](int shift) { return column_distance(a.polar, b.polar, na, nb, shift, true, false, columns); });
}

ContextMatch match_cart(const ScanContext& a, const ScanContext& b, bool reversed, ContextDistance columns) {
  const auto na = column_norms(a.cart), nb = column_norms(b.cart);
  const int max_shift = static_cast<int>(a.cart.cols()) / 4;
  return best_shift(-max_shift, max_shift, [&](int shift) {
    return column_distance(a.cart, b.cart, na, nb, shift, false, reversed, columns);
  });
}

std::vector<float> reversed_key(const std::vector<float>& cart_key) { return {cart_key.rbegin(), cart_key.rend()}; }

}  // namespace bole::slam
