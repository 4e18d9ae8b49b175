#include "alignment/core/point_tree.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <flann/flann.hpp>

namespace bole::alignment {
namespace {

using Tree = flann::Index<flann::L2_Simple<float>>;
constexpr std::size_t max_neighbours = 32;

}  // namespace

struct PointTree::Index {
  explicit Index(std::vector<Eigen::Vector3f>& points)
      : tree(flann::Matrix<float>(points.front().data(), points.size(), 3), flann::KDTreeSingleIndexParams()) {
    tree.buildIndex();
  }
  Tree tree;
};

PointTree::PointTree(std::vector<Eigen::Vector3f> points)
    : points_(std::move(points)), index_(std::make_unique<Index>(points_)) {}
PointTree::~PointTree() = default;

std::size_t PointTree::nearest(const Eigen::Vector3f& p, std::span<Neighbour> found) const {
  std::array<float, 3> query{p.x(), p.y(), p.z()};
  std::array<std::size_t, max_neighbours> indices{};
  std::array<float, max_neighbours> squares{};
  const std::size_t count = std::min({found.size(), points_.size(), max_neighbours});
  flann::Matrix<std::size_t> to(indices.data(), 1, count);
  flann::Matrix<float> distances(squares.data(), 1, count);
  index_->tree.knnSearch(flann::Matrix<float>(query.data(), 1, 3), to, distances, count,
                         flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
  for (std::size_t k = 0; k < count; ++k) found[k] = {static_cast<std::uint32_t>(indices[k]), std::sqrt(squares[k])};
  return count;
}

PointTree::Neighbour PointTree::nearest(const Eigen::Vector3f& p) const {
  Neighbour found;
  nearest(p, std::span(&found, 1));
  return found;
}

LocalPlane plane_at(const PointTree& tree, const Eigen::Vector3f& p, std::size_t count) {
  std::array<PointTree::Neighbour, max_neighbours> room{};
  const auto found = std::span(room).first(tree.nearest(p, std::span(room).first(std::min(count, room.size()))));
  LocalPlane plane;
  if (found.size() < 3) return plane;
  for (const auto& n : found) plane.centre += tree.points()[n.index] / static_cast<float>(found.size());
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const auto& n : found) {
    const Eigen::Vector3f d = tree.points()[n.index] - plane.centre;
    scatter += d * d.transpose();
  }
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors().col(0);
  return plane;
}

}  // namespace bole::alignment
