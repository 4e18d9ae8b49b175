#include "plant/core/leaves/leaf_sheet.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/statistics.h"
#include "plant/core/leaves/raster_field.h"

namespace bole::plant {
namespace {

// Clouds lose or gain at the edges of leaves, which are thinner than their noise, all of them alike.
constexpr double edge_of_noise = 0.6;

// A smooth curve through the middles of a leaf, with a frame along it: u along, v across on the sheet, h off it.
class Midrib {
 public:
  Midrib(const Points3& points, const std::vector<double>& distance, double step) : step_(step) {
    fit(points, distance);
    add_frames(points);
  }
  bool found() const { return places_.size() > 2; }

  // u, v, h of a point.
  Eigen::Vector3d spread(const Eigen::Vector3d& p) const {
    const auto i = nearest(p);
    const Eigen::Vector3d d = p - places_[i];
    return {arc_[i] + d.dot(along_[i]), d.dot(across_[i]), d.dot(up_[i])};
  }
  Eigen::Vector3d place(double u) const { return places_[index(u)] + (u - arc_[index(u)]) * along_[index(u)]; }
  // How the curve bends towards v and h, 1 / length.
  Eigen::Vector2d bend(double u) const {
    const auto i = index(u), before = i > 0 ? i - 1 : i, after = i + 1 < places_.size() ? i + 1 : i;
    const Eigen::Vector3d turn = (along_[after] - along_[before]) / std::max(arc_[after] - arc_[before], 1e-9);
    return {turn.dot(across_[i]), turn.dot(up_[i])};
  }
  double length() const { return length_; }

 private:
  void fit(const Points3& points, const std::vector<double>& distance) {
    const auto [low, high] = std::ranges::minmax(distance);
    const int bins = static_cast<int>((high - low) / step_) + 1;
    std::vector<Eigen::Vector3d> sums(static_cast<std::size_t>(bins), Eigen::Vector3d::Zero());
    std::vector<double> counts(static_cast<std::size_t>(bins), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto b = static_cast<std::size_t>((distance[i] - low) / step_);
      sums[b] += points[i];
      counts[b] += 1;
    }
    Points3 middles;
    for (std::size_t b = 0; b < sums.size(); ++b)
      if (counts[b] > 0) middles.push_back(sums[b] / counts[b]);
    if (middles.size() < 4) return;
    std::vector<double> t(middles.size(), 0);
    for (std::size_t i = 1; i < t.size(); ++i) t[i] = t[i - 1] + (middles[i] - middles[i - 1]).norm();
    if (!(t.back() > 0)) return;
    for (auto& v : t) v /= t.back() / 2, v -= 1;
    const int terms = middles.size() < 8 ? 3 : middles.size() < 14 ? 4 : 5;
    std::vector<double> weight(t.size(), 1);
    Eigen::MatrixXd x;
    for (int round = 0; round < 5; ++round) {
      Eigen::MatrixXd a = 1e-9 * Eigen::MatrixXd::Identity(terms, terms), b = Eigen::MatrixXd::Zero(terms, 3);
      for (std::size_t i = 0; i < t.size(); ++i) {
        const auto row = powers(t[i], terms);
        a += weight[i] * row * row.transpose();
        b += weight[i] * row * middles[i].transpose();
      }
      x = a.ldlt().solve(b);
      std::vector<double> off;
      for (std::size_t i = 0; i < t.size(); ++i)
        off.push_back((middles[i] - x.transpose() * powers(t[i], terms)).norm());
      const double scale = std::max(2.5 * median(off), 1e-9);
      for (std::size_t i = 0; i < t.size(); ++i) weight[i] = 1 / (1 + std::pow(off[i] / scale, 4));
    }
    sample(x, terms);
  }

  static Eigen::VectorXd powers(double t, int terms) {
    Eigen::VectorXd row(terms);
    for (int k = 0; k < terms; ++k) row[k] = k == 0 ? 1 : row[k - 1] * t;
    return row;
  }

  // The curve, and straight on at both ends.
  void sample(const Eigen::MatrixXd& x, int terms) {
    constexpr int fine = 200;
    Points3 curve;
    for (int i = 0; i <= fine; ++i) curve.push_back(x.transpose() * powers(2.0 * i / fine - 1, terms));
    double length = 0;
    for (int i = 1; i <= fine; ++i)
      length += (curve[static_cast<std::size_t>(i)] - curve[static_cast<std::size_t>(i) - 1]).norm();
    length_ = length;
    const double beyond = std::max(6 * step_, 0.15 * length);
    const Eigen::Vector3d first = (curve[4] - curve[0]).normalized(),
                          last = (curve[fine] - curve[fine - 4]).normalized();
    curve.insert(curve.begin(), curve.front() - beyond * first);
    curve.push_back(curve.back() + beyond * last);
    const double spacing = step_ / 3;
    double done = 0, from = -beyond;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Eigen::Vector3d d = curve[i] - curve[i - 1];
      const double l = d.norm();
      while (done <= l && l > 0) {
        places_.push_back(curve[i - 1] + done / l * d);
        arc_.push_back(from + done);
        done += spacing;
      }
      done -= l;
      from += l;
    }
  }

  void add_frames(const Points3& points) {
    if (!found()) return;
    const auto n = places_.size();
    Points3 one(n), other(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto before = i > 0 ? i - 1 : i, after = i + 1 < n ? i + 1 : i;
      along_.emplace_back((places_[after] - places_[before]).normalized());
      // The frame is carried along without turning about the curve.
      const Eigen::Vector3d start = i > 0 ? one[i - 1] : along_[0].unitOrthogonal();
      one[i] = (start - start.dot(along_[i]) * along_[i]).normalized();
      other[i] = along_[i].cross(one[i]);
    }
    std::vector<Eigen::Matrix2d> squares(n, Eigen::Matrix2d::Zero());
    for (const auto& p : points) {
      const auto i = nearest(p);
      const Eigen::Vector3d d = p - places_[i];
      const Eigen::Vector2d q(d.dot(one[i]), d.dot(other[i]));
      squares[i] += q * q.transpose();
    }
    const int reach = 24;  // of steps of a third: the direction across turns slowly
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
      for (int k = -2 * reach; k <= 2 * reach; ++k) {
        const auto at = static_cast<std::ptrdiff_t>(i) + k;
        if (at < 0 || at >= static_cast<std::ptrdiff_t>(n)) continue;
        sum += std::exp(-2.0 * k * k / (reach * reach)) * squares[static_cast<std::size_t>(at)];
      }
      const double angle = 0.5 * std::atan2(2 * sum(0, 1), sum(0, 0) - sum(1, 1));
      Eigen::Vector3d across = std::cos(angle) * one[i] + std::sin(angle) * other[i];
      if (i > 0 && across.dot(across_.back()) < 0) across = -across;
      across_.push_back(across);
      up_.emplace_back(along_[i].cross(across));
    }
  }

  std::size_t nearest(const Eigen::Vector3d& p) const {
    std::size_t best = 0;
    double best2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (const double d2 = (p - places_[i]).squaredNorm(); d2 < best2) {
        best2 = d2;
        best = i;
      }
    return best;
  }
  std::size_t index(double u) const {
    const auto i = std::lround((u - arc_.front()) / (step_ / 3));
    return static_cast<std::size_t>(std::clamp<long>(i, 0, static_cast<long>(arc_.size()) - 1));
  }

  double step_, length_ = 0;
  Points3 places_, along_, across_, up_;
  std::vector<double> arc_;
};

class Spreading {
 public:
  Spreading(const Points3& points, const std::vector<double>& distance, const SheetScales& scales)
      : points_(points), s_(scales), midrib_(points, distance, scales.step) {}

  LeafSheet all() {
    if (!midrib_.found() || !lay_out()) return out_;
    raster();
    measure();
    find_stalk();
    return out_;
  }

 private:
  bool lay_out() {
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const auto& p : points_) {
      uvh_.push_back(midrib_.spread(p));
      low = low.cwiseMin(uvh_.back().head<2>());
      high = high.cwiseMax(uvh_.back().head<2>());
    }
    constexpr int border = 6;
    corner_ = low - Eigen::Vector2d::Constant(border * s_.cell);
    const Eigen::Vector2d size = (high - low) / s_.cell;
    if (!(size.maxCoeff() < 4000)) return false;
    nx_ = static_cast<int>(size.x()) + 2 * border + 1;
    ny_ = static_cast<int>(size.y()) + 2 * border + 1;
    return true;
  }

  int x_of(double u) const { return static_cast<int>((u - corner_.x()) / s_.cell); }
  int y_of(double v) const { return static_cast<int>((v - corner_.y()) / s_.cell); }
  double u_of(int x) const { return corner_.x() + (x + 0.5) * s_.cell; }
  double v_of(int y) const { return corner_.y() + (y + 0.5) * s_.cell; }

  void raster() {
    RasterField count(nx_, ny_), sum(nx_, ny_);
    for (const auto& p : uvh_) {
      count.at(x_of(p.x()), y_of(p.y())) += 1;
      sum.at(x_of(p.x()), y_of(p.y())) += p.z();
    }
    const auto soft = blurred(count, 2), soft_sum = blurred(sum, 2);
    height_ = RasterField(nx_, ny_);
    for (std::size_t i = 0; i < height_.values.size(); ++i)
      if (soft.values[i] > 1e-12) height_.values[i] = soft_sum.values[i] / soft.values[i];
    // A few cells that were seen much more often must not set the level of all around them.
    std::vector<double> filled;
    for (const double c : count.values)
      if (c > 0) filled.push_back(c);
    const double most = 2 * median(filled);
    for (auto& c : count.values) c = std::min(c, most);
    const auto density = blurred(count, 1);
    const auto level = largest_within(blurred(count, 2.5), static_cast<int>(std::lround(4 * s_.step / 3 / s_.cell)));
    mask_ = RasterField(nx_, ny_);
    for (std::size_t i = 0; i < mask_.values.size(); ++i)
      mask_.values[i] = level.values[i] > 0 && density.values[i] > 0.5 * level.values[i];
    keep_large_parts(mask_, 0.04);
    seen_ = mask_;
    fill_holes(mask_);
  }

  // Area of the sheet over one cell of the raster.
  double element(int x, int y) const {
    const auto slope = [&](int dx, int dy) {
      int ahead = 0, behind = 0;
      while (ahead < 2 && inside(x + (ahead + 1) * dx, y + (ahead + 1) * dy)) ++ahead;
      while (behind < 2 && inside(x - (behind + 1) * dx, y - (behind + 1) * dy)) ++behind;
      if (ahead + behind == 0) return 0.0;
      return (height_.at(x + ahead * dx, y + ahead * dy) - height_.at(x - behind * dx, y - behind * dy)) /
             ((ahead + behind) * s_.cell);
    };
    const double hu = slope(1, 0), hv = slope(0, 1);
    const Eigen::Vector2d bend = midrib_.bend(u_of(x));
    const double stretch = std::clamp(1 - bend.x() * v_of(y) - bend.y() * height_.at(x, y), 0.3, 2.0);
    return s_.cell * s_.cell * std::sqrt(stretch * stretch * (1 + hv * hv) + hu * hu);
  }
  bool inside(int x, int y) const { return mask_.holds(x, y) && mask_.at(x, y) > 0; }

  void measure() {
    std::vector<double> breadth(static_cast<std::size_t>(nx_), 0), area(static_cast<std::size_t>(nx_), 0);
    for (int x = 0; x < nx_; ++x)
      for (int y = 0; y < ny_; ++y) {
        if (!inside(x, y)) continue;
        const int up = inside(x, y + 1) ? y + 1 : y, down = inside(x, y - 1) ? y - 1 : y;
        const double hv = up > down ? (height_.at(x, up) - height_.at(x, down)) / ((up - down) * s_.cell) : 0;
        breadth[static_cast<std::size_t>(x)] += s_.cell * std::sqrt(1 + hv * hv);
        area[static_cast<std::size_t>(x)] += element(x, y);
      }
    const auto broadest = static_cast<int>(std::ranges::max_element(breadth) - breadth.begin());
    out_.width = breadth[static_cast<std::size_t>(broadest)];
    int first = broadest, last = broadest;
    while (first > 0 && breadth[static_cast<std::size_t>(first) - 1] > 0.25 * out_.width) --first;
    // Behind a gap the blade may go on.
    for (int x = first - 1; x >= std::max(0, first - static_cast<int>(1.5 * s_.step / s_.cell)); --x)
      if (breadth[static_cast<std::size_t>(x)] > 0.4 * out_.width) {
        first = x;
        while (first > 0 && breadth[static_cast<std::size_t>(first) - 1] > 0.25 * out_.width) --first;
        x = first;
      }
    for (int x = broadest; x < nx_; ++x)
      if (breadth[static_cast<std::size_t>(x)] > 0) last = x;
    // The blade narrows to nothing over a little more than the columns that are broad enough to be told from the stalk.
    int half = first;
    while (half < broadest && breadth[static_cast<std::size_t>(half)] < 0.5 * out_.width) ++half;
    const double taper = std::min(0.5 * (half - first) * s_.cell, 0.03 * (last - first) * s_.cell);
    out_.length = (last - first + 1) * s_.cell + taper;
    start_ = u_of(first) - 0.5 * s_.cell - taper;
    double gap = 0, edge = 0, empty = 0, cells = 0;
    for (int x = first; x <= last; ++x) {
      out_.area += area[static_cast<std::size_t>(x)];
      gap += missing(breadth, x) * s_.cell;
      for (int y = 0; y < ny_; ++y) {
        if (!inside(x, y)) continue;
        cells += 1;
        empty += seen_.at(x, y) == 0;
        edge += (!inside(x, y - 1) + !inside(x, y + 1) + !inside(x - 1, y) + !inside(x + 1, y)) * s_.cell;
      }
    }
    out_.area += gap;
    // A stair of cells is longer than the edge that it follows by 4 / pi on average.
    edge *= std::numbers::pi / 4;
    out_.edge = edge;
    out_.area_sd = edge * std::hypot(0.2 * s_.cell, edge_of_noise * s_.noise) + 0.5 * gap;
    out_.filled = cells > 0 ? empty / cells : 1;
    std::vector<double> off;
    for (const auto& p : uvh_)
      if (const int x = x_of(p.x()), y = y_of(p.y()); x >= first && x <= last && inside(x, y))
        off.push_back(std::abs(p.z() - height_.at(x, y)));
    const double thickness = off.empty() ? 0 : 1.4826 * median(std::move(off));
    out_.blade = out_.width > s_.blade && thickness < 0.15 * out_.width && out_.length > 0.8 * out_.width;
  }

  // What a column lacks to those on both sides of it: a strip without points. Blades have no waist.
  double missing(const std::vector<double>& breadth, int x) const {
    const int reach = static_cast<int>(2.5 * s_.step / s_.cell);
    double before = 0, after = 0;
    for (int k = 0; k <= reach; ++k) {
      const int left = x - k, right = x + k;
      if (left >= 0) before = std::max(before, breadth[static_cast<std::size_t>(left)]);
      if (right < nx_) after = std::max(after, breadth[static_cast<std::size_t>(right)]);
    }
    const double expected = std::min(before, after), found = breadth[static_cast<std::size_t>(x)];
    return found < 0.7 * expected ? expected - found : 0;
  }

  void find_stalk() {
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    for (const auto& p : uvh_) {
      begin = std::min(begin, p.x());
      end = std::max(end, p.x());
    }
    const double step = 0.66 * s_.step, stop = start_ + 0.15 * out_.length;
    const auto bins = static_cast<std::size_t>(std::max(1.0, (stop - begin) / step + 1));
    std::vector<Eigen::Vector3d> sums(bins, Eigen::Vector3d::Zero());
    std::vector<double> counts(bins, 0);
    for (std::size_t i = 0; i < uvh_.size(); ++i) {
      if (uvh_[i].x() > stop) continue;
      const auto b = static_cast<std::size_t>((uvh_[i].x() - begin) / step);
      sums[b] += points_[i];
      counts[b] += 1;
    }
    for (std::size_t b = 0; b < bins; ++b)
      if (counts[b] >= 3) out_.stalk_middles.push_back(sums[b] / counts[b]);
    for (double u = begin; u < end; u += step) out_.midrib.push_back(midrib_.place(u));
    out_.blade_foot = midrib_.place(start_);
  }

  const Points3& points_;
  const SheetScales& s_;
  Midrib midrib_;
  std::vector<Eigen::Vector3d> uvh_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  int nx_ = 0, ny_ = 0;
  double start_ = 0;
  RasterField height_{0, 0}, mask_{0, 0}, seen_{0, 0};
  LeafSheet out_;
};

}  // namespace

LeafSheet leaf_sheet(const Points3& points, const std::vector<double>& distance, const SheetScales& scales) {
  if (points.size() < 20) return {};
  return Spreading(points, distance, scales).all();
}

}  // namespace bole::plant
