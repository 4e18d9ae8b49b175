// Sections of one stem: circles by height along it, and the line through them.
#pragma once

#include <vector>

#include "stems/core/fit/stem_points.h"

namespace bole::stems {

struct MeasuredSection {
  int number = 0;              // round(z / step): 0 at breast height
  double x = 0, y = 0, z = 0;  // centre in stem axes
  bool good = false;           // enough points and arc, near the expected surface
  Section section;
};

// Start of the joint fit: straight axis and linear taper through the good sections in the window, in stem axes at z =
// 0.
struct SectionLine {
  double x = 0, y = 0, slope_x = 0, slope_y = 0, radius = 0, taper = 0;
  int sections = 0;
};

// What the sections are expected to be.
struct SectionPlan {
  double radius = 0, taper = 0;  // at breast height; metres of radius per metre
  double step = 0.1;             // spacing and thickness
  double breast_height = usual_breast_height_m;
};
std::vector<MeasuredSection> measure_sections(const std::vector<BarkPoint>& points, const StemAxes& axes,
                                              const SectionPlan& plan, const MeasureOptions& options);

// Marks as used the sections that agree with one another, those within the window around breast height when there are
// enough, else the nearest ones.
SectionLine join_sections(std::vector<MeasuredSection>& sections, const MeasureOptions& options);

const MeasuredSection* find_section(const std::vector<MeasuredSection>& sections, int number);

}  // namespace bole::stems
