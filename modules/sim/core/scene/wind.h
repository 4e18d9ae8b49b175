// Sway of trees in the wind, as a displacement of their axis by height and time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/core/plot/forest.h"
#include "sim/core/scene/low_plant.h"

namespace bole::sim {

struct WindParameters {
  double speed_m_s = 0;  // at the height of the crowns
  double from_rad = 0;   // where it comes from, clockwise from north
};

// A tree bends like a beam that is clamped at its foot and loaded at its top. Its top is moved by the mean wind, by
// gusts that travel through the stand with the wind, and by its own oscillation at its natural frequency. Branches
// follow with a delay that grows with their distance from the stem. The motion is sampled every `step_s` and
// interpolated between. Low plants bend and swing likewise in the slower wind below the crowns.
class Wind {
 public:
  static constexpr double step_s = 0.05;

  Wind(const std::vector<Tree>& trees, const std::vector<LowPlant>& low_plants, const WindParameters& parameters,
       double duration_s, std::uint64_t seed);

  struct Swaying {
    int id = 0;  // of a tree, or below 0 of a low plant
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();  // metres per metre
    double height_m = 0;
    double flutter_m = 0, flutter_phase = 0;  // of the branches
    std::vector<Eigen::Vector2f> top_m;       // displacement of the top, one per step
    double top_reach_m = 0;                   // the top moves no further
  };
  // Trees in their order, then low plants.
  const std::vector<Swaying>& trees() const { return trees_; }

  // Share of the top's displacement that a height has.
  static double bending(double height_m, double tree_height_m);
  // Displacement of what lies `off_axis_m` beside the axis in a height above the foot, horizontal, metres.
  static Eigen::Vector2d displacement(const Swaying& tree, double height_m, double off_axis_m, double time_s);

  // No part of the tree in a height moves further.
  static double reach_m(const Swaying& tree, double height_m);

  // After Moore and Maguire, Trees 18 (2004) 195: natural frequency of conifers, used for all trees here.
  static double natural_frequency_hz(double dbh_cm, double height_m);

 private:
  struct Body;
  void add(const Body& body, const WindParameters& parameters, double duration_s, std::uint64_t seed);

  std::vector<Swaying> trees_;
};

}  // namespace bole::sim
