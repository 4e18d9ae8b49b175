// The points of clouds beside the survey about one stem, for the slice and the profile.
#pragma once

#include "document/stem_cut.h"
#include "render/draw/cloud_key.h"

namespace bole::desktop {

// A cloud where it is placed.
struct CutCloud {
  std::shared_ptr<const PointCloud> points;
  std::shared_ptr<const PointIndex> index;  // of `points`; null: every point is looked at
  std::string name;
  render::Color color;

  bool operator==(const CutCloud& other) const {
    return points == other.points && index == other.index && name == other.name && color.r == other.color.r &&
           color.g == other.color.g && color.b == other.color.b;
  }
};

// Heights are those above the foot of the stem: the survey's ground is that of all. Relative to `middle`, as the points
// of cut_across() are; at most 20 000 of each cloud, an even share.
std::vector<render::CloudDots> dots_across(const std::vector<CutCloud>& clouds, const StemPlace& stem,
                                           const CutPlace& cut, const Eigen::Vector2d& middle, double reach_m);
// As the points of cut_along() are.
std::vector<render::CloudDots> dots_along(const std::vector<CutCloud>& clouds, const StemPlace& stem,
                                          const render::StemProfileData& profile);

}  // namespace bole::desktop
