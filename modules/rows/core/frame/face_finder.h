// The trunks of clusters of points, from the side of them that the sensor sees.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "cloud/point_cloud.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

struct FoundTrunk {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double diameter_cm = std::numeric_limits<double>::quiet_NaN();
  std::int64_t plant = 0, layers = 0;
  std::int64_t points = 0;               // that the centre rests on
  std::vector<Eigen::Vector3d> shown{};  // points of the trunk, for figures
};

// Looks for trunks in `dense`: the levelled frame, the sensor at its origin. Keeps a reference to it.
class FaceFinder {
 public:
  FaceFinder(const PointCloud& dense, const TrunkOptions& options);

  // The trunk near `middle`; `foot` and `top`: heights between which it is looked for. Empty where nothing upright is
  // high and full enough.
  std::optional<FoundTrunk> find(std::int32_t plant, const Eigen::Vector2d& middle, double foot, double top) const;

  // A nearer trunk may hide one side of another: where a thin strip begins at the edge of a nearer one, the edge that
  // is seen and the usual radius of the frame tell the axis.
  static void uncover(std::vector<FoundTrunk>& trunks);

  // Clusters of leaves beside a trunk lead to the same trunk: the one of most layers stays.
  std::vector<FoundTrunk> distinct(std::vector<FoundTrunk> trunks) const;

 private:
  std::vector<Eigen::Vector3d> about(const Eigen::Vector2d& at, double reach_m, double low_m, double high_m) const;

  const PointCloud& dense_;
  const TrunkOptions& o_;
  double widest_;
};

}  // namespace bole::rows
