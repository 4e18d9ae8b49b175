// Key frames that look alike: nearest keys in a KD-tree (FLANN), then the best of the matrices behind them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/transform.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/odometry/scan.h"
#include "slam/core/options.h"

namespace bole::slam {

struct ContextCandidate {
  std::size_t keyframe = 0;
  double distance = 1;
  // Where the later key frame is, in the levelled axes of the earlier one: turn about z and shift.
  Pose T_from_to = Pose::Identity();
};

struct ContextSearch {
  int nearest = 10;   // matrices compared per key
  double tau = 0.5;   // largest distance
  bool cart = false;  // look by cart context as well, in both directions
};

ScanContextShape context_shape(const SlamOptions& options);

// Of a frame whose motion is known.
ScanContext context_of(const Scan& scan, const FrameMotion& motion, const ScanContextShape& shape);

// Axes at a pose that look along its heading and are level in map axes.
Pose levelled(const Pose& T_map_sensor);

// The best of `found`, the most alike first, no two of them within `apart_m` of way.
std::vector<ContextCandidate> most_alike(const std::vector<Keyframe>& keyframes, std::vector<ContextCandidate> found,
                                         std::size_t most, double apart_m);

class ContextIndex {
 public:
  explicit ContextIndex(const ScanContextShape& shape);
  ~ContextIndex();
  ContextIndex(const ContextIndex&) = delete;
  ContextIndex& operator=(const ContextIndex&) = delete;

  // Key frames are added in their order; one without a context is passed over.
  void add(const std::vector<Keyframe>& keyframes, std::size_t k);
  std::optional<ContextCandidate> best(const std::vector<Keyframe>& keyframes, std::size_t k,
                                       const ContextSearch& search) const;
  // See most_alike().
  std::vector<ContextCandidate> ranked(const std::vector<Keyframe>& keyframes, std::size_t k,
                                       const ContextSearch& search, std::size_t most, double apart_m) const;

 private:
  struct Trees;
  ScanContextShape shape_;
  std::unique_ptr<Trees> trees_;
};

}  // namespace bole::slam
