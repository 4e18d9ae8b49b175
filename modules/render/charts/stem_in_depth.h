// The foot of a stem as a colour picture shows it, and as the depth camera does.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// Edges of the stem in one view, from the soil upwards; pixels of the colour picture.
struct StemEdges {
  std::int64_t view = 0;
  std::string name;
  std::vector<Eigen::Vector2d> left, right;
  double width_px = 0;  // median
};

// The view that shows the stem largest, of those that the fit trusts and that have eight rows at least. The table is
// the output `contours` of plant.traits. Nothing where none has so many.
std::optional<StemEdges> largest_stem(const Table& contours);

// What depth makes of the stem.
struct StemInDepth {
  std::size_t rows = 0;  // of the edges
  std::size_t seen = 0;  // of them, those whose middle has the depth of the stem
  double width_mm = 0;   // median over the rows seen; no number where none is
};

// `depth` in metres (0: none) as the colour camera sees it (registered_depth()). `diameter_m` tells how far the
// stem is.
StemInDepth stem_in_depth(const StemEdges& edges, const DepthImage& depth, const CameraModel& color, double diameter_m);

// Neither picture may be empty; `color` has the size that its camera says.
Figure stem_in_depth_figure(const StemEdges& edges, const ColorImage& color, const DepthImage& depth,
                            const RgbdCamera& camera, double diameter_m, double width_mm);

}  // namespace bole::render
