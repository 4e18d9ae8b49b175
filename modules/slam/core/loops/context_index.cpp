#include "slam/core/loops/context_index.h"

#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>
#include <numbers>

namespace bole::slam {
namespace {

using Tree = flann::Index<flann::L2_Simple<float>>;

// A tree with the keyframes of its entries. The keys are owned here because FLANN keeps pointers.
struct KeyTree {
  std::vector<std::unique_ptr<std::vector<float>>> keys;
  std::vector<std::size_t> keyframes;
  std::unique_ptr<Tree> tree;

  void add(const std::vector<float>& key, std::size_t k) {
    keys.push_back(std::make_unique<std::vector<float>>(key));
    keyframes.push_back(k);
    const flann::Matrix<float> row(keys.back()->data(), 1, key.size());
    if (!tree) {
      tree = std::make_unique<Tree>(row, flann::KDTreeSingleIndexParams());
      tree->buildIndex();
    } else {
      tree->addPoints(row);
    }
  }

  std::vector<std::size_t> nearest(std::vector<float> key, std::size_t max_count) const {
    if (!tree) return {};
    std::vector<std::vector<std::size_t>> found;
    std::vector<std::vector<float>> distances;
    tree->knnSearch(flann::Matrix<float>(key.data(), 1, key.size()), found, distances, std::min(max_count, keys.size()),
                    flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
    std::vector<std::size_t> out;
    for (const auto i : found.front()) out.push_back(keyframes[i]);
    return out;
  }
};

Pose turned_and_shifted(double turn_rad, double left) {
  Pose T = Pose::Identity();
  T.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation().y() = left;
  return T;
}

}  // namespace

struct ContextIndex::Trees {
  KeyTree rings, carts;
};

Pose levelled(const Pose& T_map_sensor) {
  const Eigen::Vector3d ahead = T_map_sensor.linear().col(0);
  Pose T = turned_and_shifted(std::atan2(ahead.y(), ahead.x()), 0);
  T.translation() = T_map_sensor.translation();
  return T;
}

ScanContextShape context_shape(const SlamSettings& settings) {
  return {.rings = settings.context_rings, .sectors = settings.context_sectors, .range = settings.context_range};
}

ScanContext context_of(const Scan& scan, const FrameMotion& motion, const ScanContextShape& shape) {
  const Pose T_level_map = levelled(motion.T_map_end).inverse();
  const PoseGrid poses(motion);
  std::vector<Eigen::Vector3f> points;
  points.reserve(scan.points.size());
  for (const auto& p : scan.points) points.push_back((T_level_map * poses.in_map(p.position, p.s)).cast<float>());
  return make_scan_context(points, shape);
}

ContextIndex::ContextIndex(const ScanContextShape& shape) : shape_(shape), trees_(std::make_unique<Trees>()) {}
ContextIndex::~ContextIndex() = default;

void ContextIndex::add(const std::vector<Keyframe>& keyframes, std::size_t k) {
  const auto& context = keyframes[k].context;
  if (context.empty()) return;
  trees_->rings.add(context.ring_key, k);
  trees_->carts.add(context.cart_key, k);
}

std::optional<ContextCandidate> ContextIndex::best(const std::vector<Keyframe>& keyframes, std::size_t k,
                                                   const ContextSearch& search) const {
  auto found = ranked(keyframes, k, search, 1, 0);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<ContextCandidate> ContextIndex::ranked(const std::vector<Keyframe>& keyframes, std::size_t k,
                                                   const ContextSearch& search, std::size_t max_places,
                                                   double min_spacing) const {
  const auto& own = keyframes[k].context;
  if (own.empty()) return {};
  std::vector<ContextCandidate> found;
  const auto offer = [&](std::size_t j, const ContextMatch& match, double turn_rad, double left) {
    if (match.distance < search.tau) found.push_back({j, match.distance, turned_and_shifted(turn_rad, left)});
  };
  const auto max_count = static_cast<std::size_t>(search.nearest);
  for (const auto j : trees_->rings.nearest(own.ring_key, max_count)) {
    const auto match = match_polar(keyframes[j].context, own, search.columns);
    offer(j, match, 2 * std::numbers::pi * match.shift / shape_.sectors, 0);
  }
  for (const bool reversed : {false, true}) {
    if (!search.cart) break;
    for (const auto j : trees_->carts.nearest(reversed ? reversed_key(own.cart_key) : own.cart_key, max_count)) {
      const auto match = match_cart(keyframes[j].context, own, reversed, search.columns);
      offer(j, match, reversed ? std::numbers::pi : 0, 2 * shape_.range / shape_.columns * match.shift);
    }
  }
  return closest(keyframes, std::move(found), max_places, min_spacing);
}

std::vector<ContextCandidate> closest(const std::vector<Keyframe>& keyframes, std::vector<ContextCandidate> found,
                                      std::size_t max_count, double min_spacing) {
  std::ranges::stable_sort(found, {}, &ContextCandidate::distance);
  std::vector<ContextCandidate> apart;
  for (const auto& c : found) {
    if (apart.size() == max_count) break;
    if (std::ranges::none_of(apart, [&](const ContextCandidate& a) {
          return std::abs(keyframes[a.keyframe].travelled - keyframes[c.keyframe].travelled) < min_spacing;
        }))
      apart.push_back(c);
  }
  return apart;
}

}  // namespace bole::slam
