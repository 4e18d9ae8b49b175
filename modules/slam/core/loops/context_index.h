// Keyframes with similar surroundings: the nearest keys in a KD-tree (FLANN), then the best of their scan contexts.
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
  // Pose of the later keyframe in the levelled axes of the earlier one: turn about z and shift.
  Pose T_from_to = Pose::Identity();
};

struct ContextSearch {
  int nearest = 10;   // contexts compared per key
  double tau = 0.5;   // maximum distance
  bool cart = false;  // search by cart context as well, in both directions
  ContextDistance columns = ContextDistance::shared_sectors;
};

ScanContextShape context_shape(const SlamSettings& settings);

// The context of a frame whose motion is known.
ScanContext context_of(const Scan& scan, const FrameMotion& motion, const ScanContextShape& shape);

// Axes at a pose that follow its heading and are level in map axes.
Pose levelled(const Pose& T_map_sensor);

// The best of `found`, the most similar first, with at least `min_spacing` travelled between any two of them.
std::vector<ContextCandidate> closest(const std::vector<Keyframe>& keyframes, std::vector<ContextCandidate> found,
                                      std::size_t max_count, double min_spacing);

class ContextIndex {
 public:
  explicit ContextIndex(const ScanContextShape& shape);
  ~ContextIndex();
  ContextIndex(const ContextIndex&) = delete;
  ContextIndex& operator=(const ContextIndex&) = delete;

  // Keyframes are added in order; one without a context is skipped.
  void add(const std::vector<Keyframe>& keyframes, std::size_t k);
  std::optional<ContextCandidate> best(const std::vector<Keyframe>& keyframes, std::size_t k,
                                       const ContextSearch& search) const;
  // See closest().
  std::vector<ContextCandidate> ranked(const std::vector<Keyframe>& keyframes, std::size_t k,
                                       const ContextSearch& search, std::size_t max_count, double min_spacing) const;

 private:
  struct Trees;
  ScanContextShape shape_;
  std::unique_ptr<Trees> trees_;
};

}  // namespace bole::slam
