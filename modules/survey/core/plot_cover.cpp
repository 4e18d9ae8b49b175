#include "survey/core/plot_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/no_number.h"

namespace bole::survey {
namespace {

constexpr double max_squares = 1 << 24;

// Squares of the plan that hold points.
class Squares {
 public:
  Squares(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double size) : low_(low), size_(size) {
    while (((high - low).x() / size_ + 1) * ((high - low).y() / size_ + 1) > max_squares) size_ *= 2;
    nx_ = static_cast<std::size_t>((high - low).x() / size_) + 1;
    ny_ = static_cast<std::size_t>((high - low).y() / size_) + 1;
    met_.assign(nx_ * ny_, 0);
  }
  void add(const PointCloud& points, const Run& run) {
    const Eigen::Vector2d shift = points.origin.head<2>() - low_;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      const Eigen::Vector2d q = (points.positions()[i].head<2>().cast<double>() + shift) / size_;
      if (q.x() >= 0 && q.y() >= 0 && q.x() < static_cast<double>(nx_) && q.y() < static_cast<double>(ny_))
        met_[static_cast<std::size_t>(q.y()) * nx_ + static_cast<std::size_t>(q.x())] = 1;
    }
  }
  std::size_t nx() const { return nx_; }
  std::size_t ny() const { return ny_; }
  bool met(std::size_t ix, std::size_t iy) const { return met_[iy * nx_ + ix] != 0; }
  Eigen::Vector2d middle(std::size_t ix, std::size_t iy) const {
    return low_ + size_ * Eigen::Vector2d(static_cast<double>(ix) + 0.5, static_cast<double>(iy) + 0.5);
  }

 private:
  Eigen::Vector2d low_;
  double size_;
  std::size_t nx_ = 0, ny_ = 0;
  std::vector<std::uint8_t> met_;
};

double middle_between(std::vector<double>& values) {
  const auto at = [&](double rank) {
    const auto it = values.begin() + std::lround(rank * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, it);
    return *it;
  };
  constexpr double tail = 0.01;
  return (at(tail) + at(1 - tail)) / 2;
}

}  // namespace

std::optional<Eigen::Vector2d> middle_of(const PointCloud& points, const Run& run) {
  Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (const auto& p = points.positions()[i]; p.allFinite()) {
      low = low.cwiseMin(p.head<2>());
      high = high.cwiseMax(p.head<2>());
    }
  }
  if (!(low.array() <= high.array()).all()) return std::nullopt;
  const Eigen::Vector2d origin = points.origin.head<2>();
  // A small cloud has smaller squares, so that its middle is found as finely.
  const double size = std::clamp((high - low).cast<double>().minCoeff() / 50, 0.05, 1.0);
  Squares squares(origin + low.cast<double>(), origin + high.cast<double>(), size);
  squares.add(points, run);
  std::vector<double> x, y;
  for (std::size_t iy = 0; iy < squares.ny(); ++iy)
    for (std::size_t ix = 0; ix < squares.nx(); ++ix)
      if (squares.met(ix, iy)) {
        x.push_back(squares.middle(ix, iy).x());
        y.push_back(squares.middle(ix, iy).y());
      }
  return Eigen::Vector2d(middle_between(x), middle_between(y));
}

double empty_share(const PlotArea& area, const PointCloud& points, const Run& run) {
  const auto outline = area.outline();
  if (outline.empty()) return no_number;
  Eigen::Vector2d low = outline.front(), high = low;
  for (const auto& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  constexpr double squares_across = 25;
  Squares squares(low, high, std::clamp(std::sqrt(area.area_m2()) / squares_across, 0.25, 2.0));
  squares.add(points, run);
  std::size_t inside = 0, empty = 0;
  for (std::size_t iy = 0; iy < squares.ny(); ++iy)
    for (std::size_t ix = 0; ix < squares.nx(); ++ix)
      if (area.contains(squares.middle(ix, iy))) {
        ++inside;
        empty += !squares.met(ix, iy);
      }
  return inside > 0 ? static_cast<double>(empty) / static_cast<double>(inside) : no_number;
}

}  // namespace bole::survey
