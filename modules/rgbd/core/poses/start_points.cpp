#include "rgbd/core/poses/start_points.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"
#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

constexpr int max_starts = 6;  // depths that are tried
constexpr double min_parallax_rad = 0.015;

struct Sight {
  Eigen::Vector3d origin, ray;  // world axes; ray is a unit vector
};

std::optional<Eigen::Vector3d> meeting_point(const std::vector<Sight>& sights) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double parallax = 0;
  for (const auto& s : sights) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - s.ray * s.ray.transpose();
    A += across;
    b += across * s.origin;
    parallax = std::max(parallax, std::acos(std::clamp(s.ray.dot(sights.front().ray), -1.0, 1.0)));
  }
  if (parallax < min_parallax_rad) return std::nullopt;
  const Eigen::Vector3d p = A.ldlt().solve(b);
  if (!p.allFinite()) return std::nullopt;
  return p;
}

}  // namespace

const Feature& StartPoints::feature(const TrackedFeature& t) const {
  return data_[at(t.view)].features.features[t.feature];
}

// Median distance in pixels from where the views saw the point.
double StartPoints::miss(const std::vector<TrackedFeature>& track, const Eigen::Vector3d& point) const {
  std::vector<double> errors;
  for (const auto& t : track) {
    if (!poses_[at(t.view)]) continue;
    const auto seen = data_[at(t.view)].camera->color.project(poses_[at(t.view)]->inverse() * point);
    errors.push_back(seen ? (*seen - feature(t).pixel).norm() : std::numeric_limits<double>::infinity());
  }
  return upper_median(std::move(errors));
}

std::optional<Eigen::Vector3d> StartPoints::of(const std::vector<TrackedFeature>& track, double max_error_px) const {
  std::optional<Eigen::Vector3d> best;
  double smallest = max_error_px;
  const auto consider = [&](const Eigen::Vector3d& p) {
    if (const double e = miss(track, p); e < smallest) {
      smallest = e;
      best = p;
    }
  };
  int tried = 0;
  std::vector<Sight> sights;
  for (const auto& t : track) {
    if (!poses_[at(t.view)]) continue;
    const auto& f = feature(t);
    const auto& T = *poses_[at(t.view)];
    sights.push_back({T.translation(), (T.linear() * f.direction).normalized()});
    if (f.inverse_depth > 0 && tried++ < max_starts) consider(T * (f.direction / f.inverse_depth));
  }
  if (sights.size() < 2) return best;
  if (const auto p = meeting_point(sights)) consider(*p);
  return best;
}

}  // namespace bole::rgbd
