// What a cloud shows of itself before anything is computed from it: which way is up, how dense it is, what kind of
// cloud it is. From a bounded sample of the points, so that it takes seconds whatever the size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "base/run.h"
#include "cloud/known_facts.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

// single_tree: one tree that was cut out, without the ground around it; plot: stems are seen, or it is dense enough
// for them; airborne: wide, and too sparse for stems.
enum class CloudKind { unknown, single_tree, plot, airborne };
constexpr std::array<std::string_view, 4> choice_names(CloudKind) {
  return {"unknown", "single_tree", "plot", "airborne"};
}

namespace facts {
inline constexpr FactInfo kind{"kind", "", 0, 0,
                               "What kind of cloud it is, where that decides how it is measured: single_tree."};
}  // namespace facts

// What speaks for an axis of the cloud being the vertical.
struct AxisEvidence {
  std::size_t stems = 0;     // straight thin upright things over 2 m or more along it
  double stem_metres = 0;    // their length together
  double ground_seen = 0;    // share of the cells across it whose lowest points continue their neighbours
  double top_continues = 0;  // the same of the highest points: larger than ground_seen where the axis points down
};

struct FirstSight {
  std::size_t points = 0;
  Eigen::Vector3d extent_m = Eigen::Vector3d::Zero();  // that holds all but one point in a thousand, per axis
  double duplicated_share = 0;                         // of the points: have the coordinates of another one

  std::array<AxisEvidence, 3> along;  // the axes x, y, z
  std::optional<int> up;              // 0, 1, 2; nothing where the evidence does not decide

  // The rest counts with z up.
  CloudKind kind = CloudKind::unknown;
  double points_per_m2 = 0;                // of plan that holds points
  double breast_height_points_per_m2 = 0;  // of them, 1.2 to 1.4 m above the lowest points around
  std::size_t stems = 0;
  double points_per_stem = std::numeric_limits<double>::quiet_NaN();  // median, on 1.3 m of stem about breast height
  double stem_diameter_m = std::numeric_limits<double>::quiet_NaN();  // median of rough circles
  double doubled_by_m = 0;  // apart lie two walls of the stems, in the same direction at all of them; 0: one wall
  double doubled_bearing_deg = 0;                                   // of that direction, clockwise from y, 0 to 180
  double top_height_m = 0;                                          // above the lowest points around
  double lean_deg = 0;                                              // that all stems have in common
  double lean_error_deg = std::numeric_limits<double>::infinity();  // standard error of it
  Eigen::Vector3d stem_direction = Eigen::Vector3d::UnitZ();        // the common direction
};

// Where fewer points of a stem are seen about breast height its diameter is not to be relied on.
constexpr double needed_points_per_stem = 40;

// The coordinates are metres. The cloud is not changed. Fewer than 100 points: counts only.
FirstSight first_sight(const PointCloud& cloud, const Run& run = {});

}  // namespace cloud
}  // namespace bole
