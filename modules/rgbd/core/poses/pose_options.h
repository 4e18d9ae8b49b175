// Options of rgbd.estimate_poses.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/option.h"
#include "rgbd/core/features/features.h"

namespace bole::rgbd {

enum class PoseSource { slam, given };
constexpr std::array<std::string_view, 2> choice_names(PoseSource) { return {"slam", "given"}; }

// Whether the camera stands still and the object turns.
enum class Turntable { automatic, yes, no };
constexpr std::array<std::string_view, 3> choice_names(Turntable) { return {"auto", "yes", "no"}; }

struct PoseOptions {
  PoseSource source = PoseSource::slam;
  FeatureKind features = FeatureKind::sift;
  int max_features = 1500;
  int max_width = 1280;  // pixels
  double max_ratio = 0.8;
  bool gms = true;
  double max_match_error = 4;  // pixels in an image 1280 wide
  int min_matches = 12;
  int neighbours = 5;
  int loops = 6;
  std::optional<double> depth_noise;  // metres at 1 m
  bool use_board = true;
  Turntable turntable = Turntable::automatic;
  bool refine_focal = false;
  bool allow_unscaled = false;
};

const OptionTable& option_table(const PoseOptions*);

}  // namespace bole::rgbd
