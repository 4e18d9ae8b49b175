// The points about one stem that the slice and the profile show.
#pragma once

#include "document/survey.h"
#include "render/charts/stem_profile.h"
#include "render/charts/stem_slice.h"
#include "render/scene/stem_shapes.h"
#include "stems/core/tree/diameter_at_height.h"

namespace bole::desktop {

struct CutPlace {
  double height_m = 1.3, thickness_m = 0.1;  // above ground
  double breast_height_m = 1.3;
};

// A tree of the stem table and what is known of its shape; looked up once for every selection.
struct StemPlace {
  std::int64_t tree_id = 0;
  std::size_t row = 0;
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();  // ground below breast height; x, y at breast height
  double dbh_m = 0;
  render::StemShape shape;
};
std::optional<StemPlace> stem_place(const Survey& survey, std::int64_t tree);

// The circle of a fitted stem at a height: from the table at breast height, else from its sections.
render::SliceCircle circle_at(const Survey& survey, const StemPlace& stem, const CutPlace& cut);

// Points within `reach_m` of `middle` in a cut, for fits; in the plan from `middle`.
std::vector<stems::CutPoint> points_of_cut(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                           const Eigen::Vector2d& middle, double reach_m);

// What a circle of the stem away from breast height is judged by, from the tables and the points near breast height.
stems::KnownStem known_of(const Survey& survey, const StemPlace& stem, double breast_height_m);

// The stem measured in a cut at any height; centre in the axes of the stems. Nothing where no circle fits there.
std::optional<stems::DiameterAtHeight> diameter_in(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                                   const stems::KnownStem& known);

// Points within `reach_m` of `middle` at the height of the cut, neighbours and the circle of the stem, relative to
// `middle`.
render::StemSliceData cut_across(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                 const Eigen::Vector2d& middle, double reach_m);

render::StemProfileData cut_along(const Survey& survey, const StemPlace& stem, const CutPlace& cut);

}  // namespace bole::desktop
