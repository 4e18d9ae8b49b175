// How the distances of a cloud from another one are spread.
#pragma once

#include <cstddef>
#include <vector>

namespace bole::alignment {

// Bins of one width beside one another, which begin at a multiple of it. Each compared point is in exactly one of
// `counts`, `below`, `above` and `unmatched`.
struct DistanceHistogram {
  double lo_m = 0, bin_m = 0;        // where the first bin begins; the width of each
  std::vector<std::size_t> counts;   // empty where nothing was found
  std::size_t compared = 0;          // points
  std::size_t below = 0, above = 0;  // found, and outside of the bins
  std::size_t unmatched = 0;         // nothing was found within the distance that was looked at
  double median_m = 0;
  double lo95_m = 0, hi95_m = 0;  // 95 % lie between the two
  double hi_m() const { return lo_m + bin_m * static_cast<double>(counts.size()); }
};

// Both take a value for each of the `compared` points at least, which is not finite where nothing was found.

// Of distances, which have no sign. The bins begin at 0 and end behind 99.5 % of those found, so that a few far points
// do not squeeze all others into one bin. Median and hi95_m are of all compared points: infinite where those unmatched
// decide, NaN without points. lo95_m is 0.
DistanceHistogram histogram_of_distances(const std::vector<float>& distances_m, std::size_t compared);

// Of height differences, which are positive where the cloud is higher. The bins hold the middle 99.5 % of those found.
// The quantiles (50, 2.5 and 97.5 %) are of those found, because nobody knows whether the others are higher or lower;
// NaN where nothing was found.
DistanceHistogram histogram_of_rises(const std::vector<float>& rises_m, std::size_t compared);

}  // namespace bole::alignment
