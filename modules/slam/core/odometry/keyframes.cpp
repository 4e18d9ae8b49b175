#include "slam/core/odometry/keyframes.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace bole::slam {

Keyframe make_keyframe(std::size_t frame, double time_s, const FeatureSet& features, const FrameMotion& motion) {
  Keyframe out;
  out.frame = frame;
  out.time_s = time_s;
  out.T_map_keyframe = motion.T_map_end;
  const PoseGrid poses(FrameMotion{motion.T_map_end.inverse() * motion.T_map_begin, Pose::Identity(), motion.shape});
  const auto bring = [&](const std::vector<FeaturePoint>& from, std::vector<Eigen::Vector3f>& to) {
    to.reserve(from.size());
    for (const auto& p : from) to.push_back(poses.in_map(p.position, p.s).cast<float>());
  };
  bring(features.edges, out.edges);
  bring(features.planes, out.planes);
  return out;
}

void insert_keyframe(const Keyframe& keyframe, FeatureMaps& maps) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint16_t> line_bits;
  const auto insert = [&](const std::vector<Eigen::Vector3f>& from, DistributionMap& to) {
    points.clear();
    line_bits.clear();
    for (const auto& p : from) {
      points.push_back(keyframe.T_map_keyframe * p.cast<double>());
      line_bits.push_back(line_bit(p));
    }
    to.insert(points, line_bits);
  };
  insert(keyframe.edges, maps.edges);
  insert(keyframe.planes, maps.planes);
}

void LocalMap::update(const std::vector<Keyframe>& keyframes, const Eigen::Vector3d& place, bool moved) {
  std::vector<std::size_t> nearest(keyframes.size());
  std::iota(nearest.begin(), nearest.end(), std::size_t{0});
  if (nearest.size() > max_keyframes_ && kind_ == LocalMapKind::last) {
    nearest.erase(nearest.begin(), nearest.end() - static_cast<std::ptrdiff_t>(max_keyframes_));
  } else if (nearest.size() > max_keyframes_) {
    std::ranges::stable_sort(
        nearest, {}, [&](std::size_t k) { return (keyframes[k].T_map_keyframe.translation() - place).squaredNorm(); });
    nearest.resize(max_keyframes_);
    std::ranges::sort(nearest);
  }
  // Adding is cheap, removing needs a rebuild. So members that are no longer near stay until there are half as many
  // again.
  std::vector<std::size_t> wanted;
  std::ranges::set_union(nearest, members_, std::back_inserter(wanted));
  if (moved || wanted.size() > max_keyframes_ + max_keyframes_ / 2) {
    maps_.clear();
    members_.clear();
    wanted = std::move(nearest);
  }
  for (const auto k : wanted)
    if (!std::ranges::binary_search(members_, k)) insert_keyframe(keyframes[k], maps_);
  members_ = std::move(wanted);
}

}  // namespace bole::slam
