// Where the points of trees end although the trees go on: a top must show that it is one.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/run.h"
#include "stems/core/tree/assign_points.h"

namespace bole::stems {

// How the points of a tree end above. `narrows`: a crown was seen, the stem has room to narrow to nothing, and the
// points become fewer upwards. The others are no tops.
enum class TreeEnd { narrows, cloud_edge, thick_stem, blunt, bare_stem };

// A surface that the cloud was cut along: this high, or this high above the ground.
struct CloudCut {
  bool level = false;  // at one elevation, else parallel to the ground
  double z_m = 0;      // elevation, offset from the cloud's origin, or height above ground
};

struct TreeEnds {
  std::vector<TreeEnd> by_stem;
  std::optional<CloudCut> cut;
};

// `height_m` are the heights of the highest points, by stem. Needs the stem curves and the crown bases. `cut` is given
// where the points of all trees together end at one elevation or height, as densely as below it, and three trees, or
// all, end there thick or wide. A tree also ends at the edge
// of the cloud where most stems around it end while they are still thick or wide, unless it is 1 m lower than all of
// those: that is as high as the scanner saw, whatever the shape of that edge, and further away it sees higher.
TreeEnds tree_ends(const std::vector<Stem>& stems, const std::vector<double>& height_m, const PointCloud& points,
                   const PointLabels& labels, const Run& run);

// Points on and above a stem, by height above its ground.
struct StemColumn {
  static constexpr std::size_t bands = 90;
  std::array<int, bands> bark{}, inside{};
};

// Stems that end low in an open space while the trees around go on: stumps, posts, standing persons. Adds the reason
// and sets state check and quality poor. `height_m` as above.
class LowEnds {
 public:
  LowEnds(const std::vector<Stem>& stems, const PointCloud& points, const Run& run);
  void judge(std::vector<Stem>& stems, const std::vector<double>& height_m) const;

 private:
  std::vector<StemColumn> columns_;
};

}  // namespace bole::stems
