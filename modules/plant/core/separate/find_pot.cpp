#include "plant/core/separate/find_pot.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr int sectors = 36;
constexpr double min_coverage = 0.45;  // of the sectors; a pot in a corner of the room is seen from one side
constexpr std::size_t max_slice_points = 600;
constexpr int tries = 300;

using Points2 = std::vector<Eigen::Vector2d>;

struct Circle {
  double z = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0, coverage = 0;
};

int sector_of(const Eigen::Vector2d& d) {
  const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 0.5;
  return std::clamp(static_cast<int>(turn * sectors), 0, sectors - 1);
}

// Share of the directions in which the circle is the outermost thing: it has points, and few beyond it.
double coverage_of(const Points2& points, const Eigen::Vector2d& centre, double radius, double tolerance) {
  std::array<int, sectors> on{}, beyond{};
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - centre;
    const double off = d.norm() - radius;
    if (off < -tolerance || off > 6 * tolerance) continue;
    ++(off <= tolerance ? on : beyond)[static_cast<std::size_t>(sector_of(d))];
  }
  int covered = 0;
  for (std::size_t s = 0; s < sectors; ++s) covered += on[s] > 0 && on[s] >= beyond[s];
  return static_cast<double>(covered) / sectors;
}

std::optional<Circle> through(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double d = 2 * (u.x() * v.y() - u.y() * v.x());
  if (std::abs(d) < 1e-12) return std::nullopt;
  Circle circle;
  const Eigen::Vector2d o((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / d,
                          (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / d);
  circle.centre = a + o;
  circle.radius = o.norm();
  return circle;
}

// Least squares on the points near the circle (Kasa's on a narrow band, which covers most of the round).
void refine(Circle& circle, const Points2& points, double tolerance) {
  for (int round = 0; round < 5; ++round) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const auto& p : points) {
      const Eigen::Vector2d d = p - circle.centre;
      const double r = d.norm();
      if (std::abs(r - circle.radius) > tolerance || r <= 0) continue;
      const Eigen::Vector3d row(d.x() / r, d.y() / r, 1);
      a += row * row.transpose();
      b += row * (r - circle.radius);
    }
    if (a(2, 2) < 6) return;
    const Eigen::Vector3d step = (a + 1e-6 * a(2, 2) * Eigen::Matrix3d::Identity()).ldlt().solve(b);
    circle.centre += step.head<2>();
    circle.radius += step.z();
  }
}

std::optional<Circle> circle_in(const Points2& points, double z, const PotSearch& search, Random& random) {
  if (points.size() < 20) return std::nullopt;
  Circle best;
  for (int i = 0; i < tries; ++i) {
    const auto& a = points[random.next() % points.size()];
    const auto& b = points[random.next() % points.size()];
    const auto& c = points[random.next() % points.size()];
    auto circle = through(a, b, c);
    if (!circle || circle->radius < search.min_radius || circle->radius > search.max_radius) continue;
    circle->coverage = coverage_of(points, circle->centre, circle->radius, search.tolerance);
    // Of circles that are covered alike the outer one.
    if (circle->coverage > best.coverage + 1e-9 ||
        (circle->coverage > best.coverage - 0.03 && circle->radius > best.radius + search.tolerance))
      best = *circle;
  }
  if (best.coverage < min_coverage) return std::nullopt;
  refine(best, points, search.tolerance);
  best.coverage = coverage_of(points, best.centre, best.radius, search.tolerance);
  best.z = z;
  if (best.coverage < min_coverage) return std::nullopt;
  return best;
}

std::vector<Circle> circles_of(const Points3& level, const PotSearch& search, const Run& run) {
  const int count = std::clamp(static_cast<int>((search.top - search.bottom) / search.slice), 0, 200);
  std::vector<Points2> slices(static_cast<std::size_t>(count));
  for (const auto& p : level) {
    const double at = (p.z() - search.bottom) / search.slice;
    if (at >= 0 && at < count) slices[static_cast<std::size_t>(at)].push_back(p.head<2>());
  }
  std::vector<Circle> circles;
  for (int i = 0; i < count; ++i) {
    run.check_cancel();
    auto& points = slices[static_cast<std::size_t>(i)];
    Random random(31, static_cast<std::uint64_t>(i));
    if (points.size() > max_slice_points) {
      for (std::size_t k = 0; k < max_slice_points; ++k)
        std::swap(points[k], points[k + random.next() % (points.size() - k)]);
      points.resize(max_slice_points);
    }
    if (auto c = circle_in(points, search.bottom + (i + 0.5) * search.slice, search, random)) circles.push_back(*c);
  }
  return circles;
}

// The circles about one axis whose radii change evenly: those that agree with the line through two of them.
std::vector<Circle> agreeing(const std::vector<Circle>& circles, const PotSearch& search) {
  std::vector<Circle> best;
  for (std::size_t i = 0; i < circles.size(); ++i)
    for (std::size_t j = i + 1; j < circles.size(); ++j) {
      const auto &a = circles[i], &b = circles[j];
      if ((a.centre - b.centre).norm() > 2 * search.tolerance) continue;
      const double slope = (b.radius - a.radius) / (b.z - a.z);
      if (std::abs(slope) > 0.5 && b.z - a.z > 2 * search.slice) continue;
      std::vector<Circle> with;
      for (const auto& c : circles)
        if ((c.centre - (a.centre + b.centre) / 2).norm() <= 2 * search.tolerance &&
            std::abs(a.radius + slope * (c.z - a.z) - c.radius) <= 1.5 * search.tolerance)
          with.push_back(c);
      if (with.size() > best.size()) best = with;
    }
  return best;
}

}  // namespace

double FoundPot::radius_at(double z) const {
  const double height = rim_height - foot_height;
  if (!(height > 0)) return rim_radius;
  const double share = std::clamp((z - foot_height) / height, -0.2, 1.2);
  return foot_radius + share * (rim_radius - foot_radius);
}

std::optional<FoundPot> find_pot(const Points3& level, const PotSearch& search, const Run& run) {
  const auto circles = agreeing(circles_of(level, search, run), search);
  if (circles.size() < 3) return std::nullopt;
  FoundPot pot;
  std::vector<double> x, y, coverage;
  for (const auto& c : circles) {
    x.push_back(c.centre.x());
    y.push_back(c.centre.y());
    coverage.push_back(c.coverage);
  }
  pot.centre = {median(x), median(y)};
  pot.coverage = median(coverage);
  // Radius by height: a straight line through the circles.
  double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
  for (const auto& c : circles) {
    n += 1;
    sz += c.z;
    sr += c.radius;
    szz += c.z * c.z;
    szr += c.z * c.radius;
  }
  const double spread = n * szz - sz * sz;
  const double slope = spread > 0 ? (n * szr - sz * sr) / spread : 0;
  const auto wall = [&](double z) { return sr / n + slope * (z - sz / n); };
  double low = circles.front().z, high = circles.front().z;
  for (const auto& c : circles) {
    low = std::min(low, c.z);
    high = std::max(high, c.z);
  }
  // The rim is the highest place where points near the wall lie all around.
  const double step = search.slice / 2;
  double rim = high, squares = 0, on_wall = 0, lip = 0;
  for (double z = high - search.slice; z <= high + 4 * search.slice; z += step) {
    Points2 ring;
    for (const auto& p : level)
      if (p.z() >= z && p.z() < z + step) ring.push_back(p.head<2>());
    double best = 0;
    for (double out = -1.5 * search.tolerance; out <= 3 * search.tolerance; out += search.tolerance)
      if (const double c = coverage_of(ring, pot.centre, wall(z) + out, search.tolerance); c > best) {
        best = c;
        if (c >= min_coverage) lip = std::max(lip, out);
      }
    if (best >= min_coverage) rim = z + step;
  }
  for (const auto& p : level) {
    const double off = (p.head<2>() - pot.centre).norm() - wall(p.z());
    if (p.z() < low || p.z() > high || std::abs(off) > search.tolerance) continue;
    squares += off * off;
    on_wall += 1;
  }
  pot.sigma = on_wall > 0 ? std::sqrt(squares / on_wall) : search.tolerance;
  pot.rim_height = rim;
  pot.foot_height = std::max(search.bottom, low - search.slice);
  pot.rim_radius = wall(rim);
  pot.foot_radius = wall(pot.foot_height);
  pot.lip = lip;
  if (!(pot.foot_radius > 0) || !(pot.rim_radius > 0)) return std::nullopt;
  return pot;
}

}  // namespace bole::plant
