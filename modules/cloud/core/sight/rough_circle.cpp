#include "cloud/core/sight/rough_circle.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/statistics.h"

namespace bole {
inline namespace cloud {
namespace sight {

RoughCircle rough_circle(std::vector<Eigen::Vector2d> points) {
  RoughCircle out;
  constexpr int rounds = 8;
  constexpr std::size_t min_on_circle = 5;
  for (int round = 0; round < rounds; ++round) {
    if (points.size() < min_on_circle) break;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& p : points) {
      const Eigen::Vector3d row(p.x(), p.y(), 1);
      normal += row * row.transpose();
      right += p.squaredNorm() * row;
    }
    const Eigen::Vector3d s = normal.ldlt().solve(right);
    const Eigen::Vector2d centre = 0.5 * s.head<2>();
    const double radius = std::sqrt(std::max(0.0, s.z() + centre.squaredNorm()));
    std::vector<double> off;
    for (const auto& p : points) off.push_back(std::abs((p - centre).norm() - radius));
    const double limit = std::max(0.02, 3 * upper_median(std::vector(off)));
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (off[i] <= limit) kept.push_back(points[i]);
    out.radius_m = radius;
    out.centre = centre;
    const bool settled = kept.size() == points.size();
    points = std::move(kept);
    if (settled) break;
  }
  out.points = std::move(points);
  return out;
}

// Two copies of a stem, a step s apart towards the bearing b, lie on one circle with residuals of +-s/2 cos(t - b) at
// the bearing t: their squares rise and fall with 2 t, by s^2/8, and at the faces they come in two groups. Noise, oval
// stems and displacements that differ from stem to stem do neither.
void see_doubled_walls(const std::vector<RoughCircle>& circles, FirstSight& out) {
  constexpr std::size_t min_circles = 5, min_on_circle = 30, min_pooled = 300;
  std::vector<double> cosines, sines;
  for (const auto& c : circles) {
    if (c.points.size() < min_on_circle) continue;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& p : c.points) {
      const Eigen::Vector2d off = p - c.centre;
      const double t = std::atan2(off.y(), off.x()), residual = off.norm() - c.radius_m;
      const Eigen::Vector3d row(1, std::cos(2 * t), std::sin(2 * t));
      normal += row * row.transpose();
      right += residual * residual * row;
    }
    const Eigen::Vector3d s = normal.ldlt().solve(right);
    cosines.push_back(s.y());
    sines.push_back(s.z());
  }
  if (cosines.size() < min_circles) return;
  const double b = median(std::move(cosines)), c = median(std::move(sines));
  const double step_m = std::sqrt(8 * std::hypot(b, c)), direction = 0.5 * std::atan2(c, b);
  std::vector<double> faces, flanks;  // distances from the circles
  for (const auto& circle : circles)
    for (const auto& p : circle.points) {
      const Eigen::Vector2d off = p - circle.centre;
      const double along = std::abs(std::cos(std::atan2(off.y(), off.x()) - direction));
      const double distance = std::abs(off.norm() - circle.radius_m);
      if (distance > step_m) continue;  // no bark
      if (along > 0.8) faces.push_back(distance);
      if (along < 0.3) flanks.push_back(distance);
    }
  constexpr double min_step_m = 0.02;
  if (step_m < min_step_m || faces.size() < min_pooled || flanks.size() < min_pooled) return;
  // Between two walls there is little: one bell has 0.3 and more of its points there.
  constexpr double times_flanks = 1.5, middle_of_step = 0.2, max_in_middle = 0.22;
  const auto in_middle = std::ranges::count_if(faces, [&](double d) { return d < middle_of_step * step_m; });
  const double middle_share = static_cast<double>(in_middle) / static_cast<double>(faces.size());
  const double ratio = median(std::move(faces)) / median(std::move(flanks));
  if (middle_share > max_in_middle || ratio < times_flanks) return;
  out.doubled_by_m = step_m;
  out.doubled_bearing_deg = std::fmod(90 - degrees(direction) + 360, 180);
}

}  // namespace sight
}  // namespace cloud
}  // namespace bole
