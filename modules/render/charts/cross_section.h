// A slab of a survey from the side: its points in their colours, the terrain, the stems that stand in it and what was
// measured there. True to scale.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/draw/axes.h"
#include "render/draw/cloud_key.h"
#include "render/draw/figure.h"

namespace bole::render {

// Places are metres: along the line from its beginning, and z.
struct SectionStem {
  std::int64_t tree_id = 0;
  std::vector<Eigen::Vector2d> outline;  // closed
  std::string quality;
};

struct SectionMark {
  std::vector<std::vector<Eigen::Vector2d>> lines;
  std::string label;  // at `label_at`; none when empty
  Eigen::Vector2d label_at = Eigen::Vector2d::Zero();
  bool strong = false;
};

struct CrossSectionData {
  std::vector<Eigen::Vector2d> points;
  std::vector<std::uint8_t> rgb;                      // three bytes for each point; empty: all in one colour
  std::vector<std::vector<Eigen::Vector2d>> terrain;  // pieces; broken where nothing is known of it
  std::vector<SectionStem> stems;
  std::vector<SectionMark> marks;
  std::vector<CloudKey> clouds;  // of which the points are, where there are several
  std::int64_t selected = 0;     // tree
  double length_m = 0;           // of the line
};

// What of it is shown: the middle of the picture and its scale.
struct SectionSight {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double mm_per_m = 10;
};

// All of it, but for the strays above and below, on a sheet of that size.
SectionSight whole_section(const CrossSectionData& data, double width_mm, double height_mm);

// Where it comes to lie on the sheet.
Frame section_frame(const SectionSight& sight, double width_mm, double height_mm);

// `dot_px`: side of a point in pixels of the `dpi` that the figure will be drawn at.
Figure cross_section(const CrossSectionData& data, const SectionSight& sight, double width_mm, double height_mm,
                     double dpi, int dot_px);

}  // namespace bole::render
