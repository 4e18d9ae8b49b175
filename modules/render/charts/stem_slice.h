// One stem cut across: its points, the fitted circle, how the points lie about it, and a circle that a person draws.
#pragma once

#include <cstdint>
#include <optional>

#include "render/draw/cloud_key.h"
#include "render/draw/figure.h"

namespace bole::render {

// Plan coordinates in metres, relative to the middle of the view.
struct SliceCircle {
  std::int64_t tree_id = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0, lo_m = 0, hi_m = 0;  // radii of the 95 % interval; NaN or 0 without one
};

struct StemSliceData {
  std::vector<Eigen::Vector2d> points;
  std::vector<int> pass;          // of the points; empty when not known
  std::vector<CloudDots> beside;  // other clouds, in their colours; nothing is fitted to them
  std::optional<SliceCircle> stem;
  std::vector<SliceCircle> neighbours;
  std::optional<SliceCircle> drawn, refit;  // by the person; fitted to the points from there
  std::string quality;
  std::vector<std::string> lines;  // above the picture
  double reach_m = 0.3;            // from the middle of the view to its edge
};

// How the points lie about a circle, by sectors of 10 degrees from east counter-clockwise.
struct SectorResidual {
  int points = 0;
  double median_m = 0;  // outwards positive
};
std::vector<SectorResidual> sector_residuals(const std::vector<Eigen::Vector2d>& points, const SliceCircle& circle);

// The picture is the largest square below the lines; this maps its metres to the sheet.
struct SliceScale {
  Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero();
  double mm_per_metre = 1;
  Eigen::Vector2d to_sheet(const Eigen::Vector2d& metres) const {
    return middle_mm + mm_per_metre * Eigen::Vector2d(metres.x(), -metres.y());
  }
  Eigen::Vector2d to_metres(const Eigen::Vector2d& mm) const {
    const Eigen::Vector2d d = (mm - middle_mm) / mm_per_metre;
    return {d.x(), -d.y()};
  }
};
SliceScale slice_scale(double width_mm, double height_mm, std::size_t lines, double reach_m);

Figure stem_slice(const StemSliceData& data, double width_mm, double height_mm);

}  // namespace bole::render
