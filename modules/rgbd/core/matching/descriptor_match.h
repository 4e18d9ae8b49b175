// For every feature of one image, the most alike of another.
#pragma once

#include <cstdint>
#include <vector>

#include "rgbd/core/features/features.h"

namespace bole::rgbd {

struct Match {
  std::uint32_t a = 0, b = 0;  // indices of features
};

// The best candidate of a feature of `a`, whether or not it is good enough.
struct Candidate {
  Match match;
  double ratio = 1;     // distance to it over distance to the next best at another place
  bool mutual = false;  // the feature of `a` is also the best for that of `b`
};

// One for each feature of `a`; empty where either has no features. By comparing all with all.
std::vector<Candidate> best_candidates(const Features& a, const Features& b);

// How many of the `count` largest features of both find one another: cheap, to tell which views show the same place.
class Likeness {
 public:
  Likeness(const Features& features, int count);
  int with(const Likeness& other) const;

 private:
  Features strongest_;
};

}  // namespace bole::rgbd
