#include "render/beside/placed_cloud.h"

#include <Eigen/Geometry>

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
    const Eigen::Matrix3d R = place_.turn();
    OctreeView own = view;
    Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
    turn.topLeftCorner<3, 3>() = R;
    own.world_to_clip = view.world_to_clip * turn;
    if (place_.turn_rad != 0) {
      // The box around the box that is turned back.
      const Eigen::Vector3d centre = (view.lo + view.hi).cast<double>() / 2,
                            half = (view.hi - view.lo).cast<double>() / 2;
      const Eigen::Vector3d own_centre = R.transpose() * centre, own_half = R.transpose().cwiseAbs() * half;
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

Eigen::Matrix3d CloudPlace::turn() const {
  return Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Eigen::Vector3d CloudPlace::of(const Eigen::Vector3d& p) const {
  if (turn_rad == 0) return p + shift;  // exactly
  const Eigen::Vector3d about(pivot.x(), pivot.y(), 0);
  return about + turn() * (p - about) + shift;
}

Eigen::Vector2d CloudPlace::back(const Eigen::Vector2d& plan) const {
  Eigen::Vector2d before = plan - shift.head<2>();
  if (turn_rad == 0) return before;
  return pivot + turn().topLeftCorner<2, 2>().transpose() * (before - pivot);
}

PointCloud placed_cloud(const PointCloud& cloud, const CloudPlace& place) {
  PointCloud out = cloud;
  if (place.moves_nothing()) return out;
  out.origin = place.of(cloud.origin);
  out.scale.setZero();
  if (place.turn_rad == 0) return out;
  const Eigen::Matrix3f R = place.turn().cast<float>();
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
