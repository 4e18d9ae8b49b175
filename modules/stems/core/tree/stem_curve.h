// The stem above the layer that it was found in, and its volume.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/tree/assign_points.h"

namespace bole::stems {

// Follows every stem upwards from its highest section, circle by circle every 0.5 m, as long as the bark is seen: adds
// sections with `curve` set and `used` not set, and sets `curve` of the sections that the diameter comes from. A stem
// that cannot be followed has no curve, and the report is warned.
void follow_stems(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, double breast_height_m,
                  const MeasureOptions& options, const Run& run, Report& report);

struct CurvePoint {
  double height_m = 0, radius_m = 0;
};

struct StemVolume {
  double m3 = 0;
  std::string method;  // in words
};

// Frustums between the points of a stem curve, from the ground (the taper of `curve` carried on) to its highest point,
// and a form half way between paraboloid and cone from there to the top. `curve` by increasing height, two points at
// least, below the top.
StemVolume volume_of(const std::vector<CurvePoint>& curve, double top_m);

// Heights and radii of the stem curve: circles less what they are too wide at breast height against the joint fit, each
// the median of three.
std::vector<CurvePoint> stem_curve(const Stem& stem, double breast_height_m);

// Sets volume_m3 and volume_method of the stems whose top was seen, those left out that the report is warned of.
void measure_volumes(std::vector<Stem>& stems, double breast_height_m, const Run& run, Report& report);

}  // namespace bole::stems
