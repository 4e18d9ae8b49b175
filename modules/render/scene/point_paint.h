// Colours of points by any of their arrays.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "render/draw/axes.h"
#include "render/draw/color.h"

namespace bole::render {

inline const Color ground_grey = hex(0xb9b1a4);
// Heights between which the grey of the ground gives way to the map.
inline constexpr double ground_below_m = 0.08, plants_above_m = 0.5;

struct PointPaint {
  enum class Kind { map, ids, photo, plain };
  std::string array;  // a column, or "z"
  Kind kind = Kind::plain;
  Interval range;                 // of Kind::map; what lies beyond takes the colour of the end
  const ColorMap* map = nullptr;  // of Kind::map
  bool quiet_ground = false;      // heights above ground: the ground itself is grey
  std::string title;              // of the legend, with the unit
  Color color = hex(0xb9b1a4);    // of Kind::plain
};

// What a cloud can be coloured by, in the order of the vocabulary: heights first, "photo" where it has red, green and
// blue, "z" always.
std::vector<std::string> paintable_arrays(const PointCloud& cloud);

// Ids (trees, passes, key frames, classes, rings) get one stable colour each, numbers a perceptual map from the 2nd to
// the 98th percentile (heights above ground: 0 to the 99.5th). Falls back to "z" where the cloud lacks the array.
PointPaint paint_by(const PointCloud& cloud, const std::string& array);

// Three bytes for each of `indices`.
void paint_points(const PointCloud& cloud, std::span<const std::uint32_t> indices, const PointPaint& paint,
                  std::uint8_t* rgb);

}  // namespace bole::render
