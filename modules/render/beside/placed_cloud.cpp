#include "render/beside/placed_cloud.h"

#include <Eigen/Geometry>

#include "base/transform.h"

namespace bole::render {
namespace {

std::shared_ptr<const PointCloud> placed_tile(const std::shared_ptr<const PointCloud>& cloud, const CloudPlace& place) {
  return cloud ? std::make_shared<const PointCloud>(placed_cloud(*cloud, place)) : nullptr;
}

class PlacedNodes : public PointNodes {
 public:
  PlacedNodes(std::shared_ptr<PointNodes> nodes, const CloudPlace& place) : nodes_(std::move(nodes)), place_(place) {}

  Eigen::Vector3d origin() const override { return place_.of(nodes_->origin()); }

  std::vector<std::uint32_t> choose(const OctreeView& view, std::size_t budget, double min_px) override {
    OctreeView own = view;
    Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
    turn.topLeftCorner<3, 3>() = place_.linear();
    own.world_to_clip = view.world_to_clip * turn;
    if (!place_.only_shifts()) {
      // The box around the box that is turned back.
      const Eigen::Matrix3d back = place_.turn().transpose() / place_.scale;
      const Eigen::Vector3d centre = (view.lo + view.hi).cast<double>() / 2,
                            half = (view.hi - view.lo).cast<double>() / 2;
      const Eigen::Vector3d own_centre = back * centre, own_half = back.cwiseAbs() * half;
      own.lo = (own_centre - own_half).cast<float>();
      own.hi = (own_centre + own_half).cast<float>();
    }
    return nodes_->choose(own, budget, min_px);
  }

  std::size_t size_of(std::uint32_t node) const override { return nodes_->size_of(node); }
  PointSet points(std::uint32_t node) const override {
    auto set = nodes_->points(node);
    set.cloud = placed_tile(set.cloud, place_);
    return set;
  }
  std::shared_ptr<const PointCloud> cloud_of(std::uint32_t node) const override {
    return placed_tile(nodes_->cloud_of(node), place_);
  }
  std::size_t max_prepared() const override { return nodes_->max_prepared(); }

 private:
  std::shared_ptr<PointNodes> nodes_;
  CloudPlace place_;
};

}  // namespace

Eigen::Matrix3d CloudPlace::turn() const { return rotation_from_rpy(tilt_x_rad, tilt_y_rad, turn_rad); }

Eigen::Matrix3d CloudPlace::linear() const { return scale * turn(); }

Eigen::Vector3d CloudPlace::of(const Eigen::Vector3d& p) const {
  if (only_shifts()) return p + shift;  // exactly
  return pivot + linear() * (p - pivot) + shift;
}

Eigen::Vector3d CloudPlace::back(const Eigen::Vector3d& world) const {
  const Eigen::Vector3d before = world - shift;
  if (only_shifts()) return before;
  return pivot + turn().transpose() * (before - pivot) / scale;
}

PointCloud placed_cloud(const PointCloud& cloud, const CloudPlace& place) {
  PointCloud out = cloud;
  if (place.moves_nothing()) return out;
  out.origin = place.of(cloud.origin);
  out.scale.setZero();
  if (place.only_shifts()) return out;
  const Eigen::Matrix3f R = place.linear().cast<float>();
  PointCloud::Positions positions;
  positions.reserve(cloud.size());
  for (const auto& p : cloud.positions()) positions.emplace_back(R * p);
  out.set_positions(std::move(positions));
  return out;
}

std::shared_ptr<PointNodes> placed_nodes(std::shared_ptr<PointNodes> nodes, const CloudPlace& place) {
  if (!nodes || place.moves_nothing()) return nodes;
  return std::make_shared<PlacedNodes>(std::move(nodes), place);
}

}  // namespace bole::render
