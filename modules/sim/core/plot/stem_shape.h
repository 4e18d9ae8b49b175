// The analytic surface of a stem, from which its mesh and its true diameter are both taken.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/core/plot/terrain.h"

namespace bole::sim {

// h is the vertical height above the ground under the axis' foot. A section at h is perpendicular to the axis there and
// has the polar radius radius(h, theta): taper and butt flare times a low-order Fourier series, with root lobes near
// the ground.
struct StemShape {
  static constexpr int first_order = 2, orders = 4;  // Fourier terms 2 .. 5

  Eigen::Vector3d foot = Eigen::Vector3d::Zero();  // the axis at the ground, plot axes
  double height_m = 15;                            // of the tip (a broken stem ends below it)
  double end_m = 15;                               // where the wood ends
  double radius_m = 0.1;                           // mean radius at 1.3 m, without flare
  double taper_exponent = 0.8;
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();  // metres per metre
  Eigen::Vector2d bow = Eigen::Vector2d::Zero();   // largest departure of the axis from the straight, metres
  double bow_length_m = 8;                         // half a wave of the bow
  double flare = 0.2;                              // relative widening at the ground
  double flare_length_m = 0.28;
  std::array<double, orders> amplitude{}, phase{};  // relative
  int lobes = 5;
  double lobe_amplitude = 0.1, lobe_phase = 0;  // relative, at the ground
  double bark_depth_m = 0.003;                  // fissures lie up to this far inside the surface

  Eigen::Vector3d axis(double h) const;
  Eigen::Vector3d tangent(double h) const;                   // unit
  Eigen::Matrix<double, 3, 2> section_axes(double h) const;  // orthonormal, perpendicular to the tangent
  double mean_radius(double h) const;                        // of the Fourier series: taper times flare
  double radius(double h, double theta) const;
  Eigen::Vector3d surface(double h, double theta) const;
  // Height h at which the axis has run `length_m` since h0 (arc length).
  double height_along(double h0, double length_m) const;
};

// What a forester measures: 1.3 m along the stem above the highest ground that touches it, tape across the axis.
struct TapedStem {
  double ground_z_m = 0;                             // the uphill ground that breast height is counted from
  double h = 0;                                      // breast height as a parameter of the shape
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // centroid of the section
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   // direction of the stem there
  double diameter_m = 0;                             // girth of the section's convex hull / pi
};

TapedStem tape(const StemShape& stem, const Terrain& terrain, double breast_height_m = 1.3);

// Perimeter of the convex hull and area centroid of a section given as points in its plane.
struct Girth {
  double length_m = 0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
};
Girth hull_girth(std::vector<Eigen::Vector2d> points);

}  // namespace bole::sim
