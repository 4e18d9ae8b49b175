// Two maps of one stand, in unknown axes, brought together by the places and diameters of its trees.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/run.h"

namespace bole::survey {

// A diameter that is not known is NaN.
struct StandTree {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double dbh_cm = 0;
};

struct AlignLimits {
  double match_distance_m = 0.5;
  double max_loss_cm = 4;     // by which a tree may seem thinner in the second survey
  double max_growth_cm = 12;  // by which it may be thicker
};

struct TreePair {
  std::size_t first = 0, second = 0;
  double distance_m = 0;  // after the motion
};

struct StandAlignment {
  Eigen::Isometry2d T_first_second = Eigen::Isometry2d::Identity();
  std::vector<TreePair> pairs;  // one to one, by first
  double rms_m = 0;             // of the distances of the pairs
  double evidence = 0;          // logarithm of how much likelier the pairs are with this motion than by chance
  // The best motion that is another one: how far it is from being taken for this.
  double rival_evidence = 0;
  std::size_t rival_pairs = 0;
  bool certain = false;  // enough evidence, and no rival
};

// A rigid motion (no mirror, no scale) without a start. Pairs of trees of one map are laid on pairs of like length and
// like diameters of the other; motions that many pairs of pairs agree on are refined and scored by the likelihood of
// their matches (place and diameter, against trees scattered at random; a tree that should have a partner and has none
// counts against the motion). Of many trees the thickest 200 take part in the search. The motion is certain where its
// evidence is above what chance gives among all motions, at least a third of the trees that both maps cover have a
// partner, and no other motion explains nearly as much (rows planted evenly, plots with a symmetry).
StandAlignment align_stands(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                            const AlignLimits& limits, const Run& run);

// The same without a search, for maps that lie in the same axes already: refined from no motion at all.
StandAlignment align_in_place(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                              const AlignLimits& limits);

// One-to-one matches of trees whose diameters go together, the nearest first.
std::vector<TreePair> match_trees(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                                  const Eigen::Isometry2d& T_first_second, const AlignLimits& limits);

}  // namespace bole::survey
