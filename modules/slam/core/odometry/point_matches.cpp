#include "slam/core/odometry/point_matches.h"

#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>

#include "base/angles.h"

namespace bole::slam {
namespace {

using Tree = flann::Index<flann::L2_Simple<float>>;

constexpr double max_distance = 2;                   // of a reference from the point
constexpr std::size_t neighbours = 16;               // among which the references are chosen
constexpr double same_line_rad = radians(0.1);       // difference in elevation of the returns of one laser
constexpr double min_length = 0.05, min_sine = 0.2;  // of references that span a line or plane
constexpr double model_sigma = 0.01;  // how far bark and ground depart from lines and planes: open in the paper

}  // namespace

PointDistance distance_from_line(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double t = along.dot(x - a) / along.squaredNorm();
  const Eigen::Vector3d across = x - (a + t * along);
  PointDistance out;
  out.distance = across.norm();
  out.direction = out.distance > 1e-9 ? Eigen::Vector3d(across / out.distance) : along.unitOrthogonal();
  out.shares = {1 - t, t, 0};
  return out;
}

PointDistance distance_from_plane(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, n = ab.cross(ac);
  const double n2 = n.squaredNorm();
  PointDistance out;
  out.direction = n / std::sqrt(n2);
  out.distance = out.direction.dot(x - a);
  const Eigen::Vector3d foot = x - a - out.distance * out.direction;
  const double of_b = n.dot(foot.cross(ac)) / n2, of_c = n.dot(ab.cross(foot)) / n2;
  out.shares = {1 - of_b - of_c, of_b, of_c};
  return out;
}

double condition_variance(const PointDistance& distance, double model_variance,
                          std::span<const Eigen::Matrix3d* const> of_references, const Eigen::Matrix3d& of_point) {
  const Eigen::Vector3d& u = distance.direction;
  double variance = model_variance + u.dot(of_point * u);
  for (std::size_t k = 0; k < of_references.size(); ++k)
    variance += distance.shares[k] * distance.shares[k] * u.dot(*of_references[k] * u);
  return variance;
}

struct PointMatches::Part {
  struct Reference {
    Eigen::Vector3d position;    // map axes
    Eigen::Matrix3d covariance;  // the same
    double elevation_rad;        // of the laser
  };
  std::vector<Reference> references;
  std::vector<float> coordinates;  // relative to `origin`; the tree keeps pointers to them
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::unique_ptr<Tree> tree;

  Part(const std::vector<FeaturePoint>& points, const PoseGrid& poses, const Eigen::Vector3d& sensor_place,
       const SensorPrior& sensor, const Matrix6d& pose_covariance)
      : origin(sensor_place) {
    references.reserve(points.size());
    coordinates.reserve(3 * points.size());
    for (const auto& p : points) {
      const Eigen::Vector3d in_sensor = p.position.cast<double>(), in_map = poses.in_map(p.position, p.s);
      const Eigen::Matrix3d& R = poses.rotation(p.s);
      Eigen::Matrix<double, 3, 6> J;
      J << -skew(in_map - sensor_place), Eigen::Matrix3d::Identity();
      references.push_back(
          {in_map, R * point_covariance(in_sensor, sensor) * R.transpose() + J * pose_covariance * J.transpose(),
           std::atan2(in_sensor.z(), in_sensor.head<2>().norm())});
      const Eigen::Vector3f offset = (in_map - origin).cast<float>();
      coordinates.insert(coordinates.end(), offset.data(), offset.data() + 3);
    }
    if (references.empty()) return;
    tree = std::make_unique<Tree>(flann::Matrix<float>(coordinates.data(), references.size(), 3),
                                  flann::KDTreeSingleIndexParams());
    tree->buildIndex();
  }

  // The nearest first; none beyond the reach.
  std::size_t nearest(const Eigen::Vector3d& place, std::array<const Reference*, neighbours>& out) const {
    if (!tree) return 0;
    Eigen::Vector3f query = (place - origin).cast<float>();
    std::array<std::size_t, neighbours> index{};
    std::array<float, neighbours> squared{};
    flann::Matrix<std::size_t> indices(index.data(), 1, neighbours);
    flann::Matrix<float> distances(squared.data(), 1, neighbours);
    const auto wanted = std::min(neighbours, references.size());
    tree->knnSearch(flann::Matrix<float>(query.data(), 1, 3), indices, distances, wanted,
                    flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
    std::size_t n = 0;
    while (n < wanted && squared[n] <= static_cast<float>(max_distance * max_distance)) {
      out[n] = &references[index[n]];
      ++n;
    }
    return n;
  }
};

PointMatches::PointMatches(const FeatureSet& features, const FrameMotion& motion, const SensorPrior& sensor,
                           const Matrix6d& pose_covariance) {
  const PoseGrid poses(motion);
  const Eigen::Vector3d place = motion.T_map_end.translation();
  edges_ = std::make_unique<Part>(features.edges, poses, place, sensor, pose_covariance);
  planes_ = std::make_unique<Part>(features.planes, poses, place, sensor, pose_covariance);
}

PointMatches::~PointMatches() = default;

Target PointMatches::target(const Eigen::Vector3d& x, bool line, const Eigen::Matrix3d* of_point,
                            double variance) const {
  std::array<const Part::Reference*, neighbours> found{};
  const auto n = (line ? edges_ : planes_)->nearest(x, found);
  if (n < 2) return {};
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(n);
  const auto& a = *found[0];
  const auto on_line_of_a = [&](const Part::Reference* r) {
    return std::abs(r->elevation_rad - a.elevation_rad) < same_line_rad;
  };
  const auto other = std::find_if_not(found.begin() + 1, end, on_line_of_a);
  if (other == end || ((*other)->position - a.position).norm() < min_length) return {};
  const Eigen::Vector3d to_other = (*other)->position - a.position;
  Target target;
  target.mean = a.position;
  target.variance = variance;
  if (line) {
    target.axis = to_other.normalized();
    target.kind = Target::Kind::line;
    if (of_point)
      target.variance =
          condition_variance(distance_from_line(x, a.position, (*other)->position), model_sigma * model_sigma,
                             std::array{&a.covariance, &(*other)->covariance}, *of_point);
    return target;
  }
  const auto beside = std::find_if(found.begin() + 1, end, on_line_of_a);
  if (beside == end) return {};
  const Eigen::Vector3d to_beside = (*beside)->position - a.position, n_raw = to_beside.cross(to_other);
  if (to_beside.norm() < min_length || n_raw.norm() < min_sine * to_beside.norm() * to_other.norm()) return {};
  target.axis = n_raw.normalized();
  target.kind = Target::Kind::plane;
  if (of_point)
    target.variance = condition_variance(
        distance_from_plane(x, a.position, (*beside)->position, (*other)->position), model_sigma * model_sigma,
        std::array{&a.covariance, &(*beside)->covariance, &(*other)->covariance}, *of_point);
  return target;
}

}  // namespace bole::slam
