// The nearest of many points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace bole::alignment {

class PointTree {
 public:
  explicit PointTree(std::vector<Eigen::Vector3f> points);  // finite, in metres from any origin; at least one
  ~PointTree();

  struct Neighbour {
    std::uint32_t index = 0;
    float distance_m = 0;
  };
  // Threads may ask at the same time.
  Neighbour nearest(const Eigen::Vector3f& p) const;
  // As many as `found` has room for, nearest first; how many there are.
  std::size_t nearest(const Eigen::Vector3f& p, std::span<Neighbour> found) const;

  const std::vector<Eigen::Vector3f>& points() const { return points_; }

 private:
  struct Index;
  std::vector<Eigen::Vector3f> points_;
  std::unique_ptr<Index> index_;
};

// The plane through the `count` points nearest to p, by least squares.
struct LocalPlane {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, to either side; zero where fewer than three points are
};
LocalPlane plane_at(const PointTree& tree, const Eigen::Vector3f& p, std::size_t count);

}  // namespace bole::alignment
