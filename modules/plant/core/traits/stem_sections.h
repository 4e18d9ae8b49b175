// The diameter of the main stem from the soil to where leaves hide it, and the volume of the whole stem.
#pragma once

#include <optional>
#include <vector>

#include "plant/core/leaves/axis_curve.h"
#include "plant/core/leaves/leaf_traits.h"
#include "plant/core/traits/stem_fit.h"
#include "plant/core/traits/trait_tables.h"

namespace bole::plant {

// A piece of the stem, seen in the pictures.
struct StemSection {
  double arc = 0;  // from the soil, along the stem
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double diameter = 0, standard_error = 0;
  std::size_t views = 0;
};

struct SectionInputs {
  const ViewSource& views;
  const Trajectory& poses;
  const std::vector<std::uint32_t>& which;  // views that are looked at
  const Pose& T_plant_world;
  const Points3& solid;       // plant axes: everything that may hide the stem
  double spacing = 0;         // of its points
  const StemFit& known;       // at the height of measurement
  const StripSearch& search;  // that it was found with: light and point spread
  double stretch = 0.024;     // length of a piece, metres
  double pose_sigma_px = 1;
};

// Pieces of `stretch` above and below the one that is known, which is among them, upwards. Pieces that too few views
// see, that lie flatter than 45 degrees, that views see less alike than the one that is known (stalks lie along them),
// or that are wider than those below them (where a leaf or a branch begins) are left out.
std::vector<StemSection> measure_sections(const SectionInputs& inputs, const AxisCurve& stem, const Run& run);

// Between the sections, and half a piece beyond them. It is seen up to half a piece from a section.
DiameterThere diameter_at(const std::vector<StemSection>& sections, double arc, double stretch);

// Volume of the stem from the soil to its tip (cubic metres): frusta between the sections, the lowest one thickening on
// down to the soil, and above the highest one a form between a cone and a cylinder. `shared_sd`: error of all diameters
// together; `length_sd`: of the stem. Nothing where the sections cover less than half of the stem.
std::optional<Interval> stem_volume(const std::vector<StemSection>& sections, double length, double shared_sd,
                                    double length_sd);

}  // namespace bole::plant
