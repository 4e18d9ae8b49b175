// The motion that takes points of one cloud to their partners in another.
#pragma once

#include <vector>

#include "alignment/core/similarity.h"

namespace bole::alignment {

struct PointPair {
  Eigen::Vector3d moved, fixed;  // metres; of the cloud that is to be moved, and where it shall come to lie
};

// Why pairs give no motion.
enum class PairProblem { none, too_few, on_a_line };
inline constexpr std::size_t min_pairs = 3;
// On a line are points that leave their best line by less than this share of their extent along it (roots of mean
// squares): the turn about the line would be an error of the clicks. A guess: at 0.02 errors of 0.1 % of the extent
// turn the cloud by three degrees about the line.
inline constexpr double min_breadth = 0.02;

PairProblem problem_of(const std::vector<PointPair>& pairs);  // of either side

struct PairFit {
  Similarity motion;
  std::vector<double> residual_m;  // of each pair: from where its moved point comes to lie to its fixed one
  double rms_m = 0;                // root of their mean square
};

// Least squares; at scale 1 unless `with_scale`. Throws Error{bad_input} where problem_of() says why.
PairFit fit_pairs(const std::vector<PointPair>& pairs, bool with_scale);

double residual_m(const Similarity& motion, const PointPair& pair);

}  // namespace bole::alignment
