// Returns held against the true stems of a simulated plot, along their rays: whether the poses stand too near to what
// they see, and how thick the walls of the trunks are with them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/transform.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"

namespace bole {

// A stem about breast height, plot axes.
struct TrueStem {
  Eigen::Vector3d breast_height = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::UnitZ();
  double radius = 0;
};
// From trees.csv of `bole simulate`: those in the plot.
std::vector<TrueStem> true_stems(const Table& trees);

// A return from within 0.3 m of breast height whose ray passes the axis of the stem at less than 0.9 radii.
struct StemReturn {
  std::size_t stem = 0;
  double along_m = 0;  // measured less predicted range
  double range = 0;
  double impact = 0;                                // distance of the ray from the axis, in radii
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // across the axis
  Eigen::Vector2d ray = Eigen::Vector2d::Zero();    // direction, across the axis, of length 1
};

// The pose of the sensor in plot axes; nothing where the path does not reach.
using PoseInPlot = std::function<std::optional<Pose>(double time_s)>;

std::vector<StemReturn> stem_returns(const FrameSource& source, std::size_t frames, const PoseInPlot& pose,
                                     const std::vector<TrueStem>& stems);

struct WallFigures {
  double along_mm = 0;                  // mean over stems and directions of view of the median residual along the ray
  double own_along_mm = 0;              // the same about the centre that the returns of each stem have by themselves
  double own_sd_mm = 0;                 // RMS over stems of their shift from the true place
  double wall_mm = 0;                   // median over stems of the robust SD of the radial residual about that centre
  std::vector<double> wall_of_stem_mm;  // 0: too few returns
};
WallFigures wall_figures(const std::vector<StemReturn>& returns, std::size_t stems);

}  // namespace bole
