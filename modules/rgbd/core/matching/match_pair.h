// The matches of two views, screened step by step: ratio test, mutual, grid-based motion statistics, rigid motion.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/transform.h"
#include "camera/camera_model.h"
#include "rgbd/core/features/features.h"
#include "rgbd/core/matching/descriptor_match.h"

namespace bole::rgbd {

// Why a match is used or not. still: it does not move while another part of the image does, as the background of a
// turntable. depth: it disagrees with the rigid motion of the others.
enum class MatchFate { kept, ratio, mutual, gms, still, depth };
constexpr std::array<std::string_view, 6> choice_names(MatchFate) {
  return {"kept", "ratio", "mutual", "gms", "still", "depth"};
}

struct ScreenOptions {
  double max_ratio = 0.8;  // distance to the best over distance to the next best descriptor
  bool gms = true;
  double max_error_px = 4;    // of a match from the motion
  double depth_noise = 0.01;  // standard deviation of the inverse depth, 1 / m
  int min_inliers = 15;
  bool drop_still = false;  // leave out what does not move
};

// One view as matching needs it.
struct MatchableView {
  const Features* features = nullptr;
  const CameraModel* camera = nullptr;
  int index = 0;
};

struct ScreenedMatch {
  Match match;
  MatchFate fate = MatchFate::kept;
};

struct MatchedPair {
  int view_a = 0, view_b = 0;
  Pose T_b_a = Pose::Identity();
  std::vector<Match> kept;  // empty: no motion was found
  // The matches agree with one motion of the rays alone: without depth, the length of the shift is 1 and means nothing.
  bool by_rays = false;
  int candidates = 0;  // that passed the ratio test and are mutual
  int still = 0;       // of them, that do not move
  // Where a part of the image moves and another part, of which some cannot belong to that motion, is still.
  bool two_motions = false;
  double still_depth = 0, moving_depth = 0;  // metres, medians of the two parts; 0: not known

  bool connected() const { return !kept.empty(); }
};

// `fates`: every candidate with what became of it, where somebody wants to see them.
MatchedPair match_pair(const MatchableView& a, const MatchableView& b, const ScreenOptions& options,
                       std::vector<ScreenedMatch>* fates = nullptr);

}  // namespace bole::rgbd
