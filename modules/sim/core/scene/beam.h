// What one laser pulse measures: a diverging beam, surfaces of different brightness, a detector with noise.
#pragma once

#include <vector>

#include "base/transform.h"
#include "sensor/core/sensor_model.h"
#include "sensor/core/velodyne_encoder.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/ray_scene.h"

namespace bole::sim {

struct BeamParameters {
  double noise = 1;              // multiplies range scatter and laser biases; 0: exact ranges
  double divergence = 1;         // multiplies the size of the beam; 0: a ray
  double dropouts = 0.004;       // share of pulses lost at random
  double laser_bias_m = 0.004;   // standard deviation of the constant range error of a laser
  double pulse_length_m = 0.40;  // surfaces closer together than this give one blended return
  bool bark = true;              // fissures of the bark
  bool bark_facets = false;      // plates of bark at steps, in place of smooth fissures
  double noise_growth = 0;       // added share of the range scatter at grazing incidence and for a beam mostly beside
};

class Beam {
 public:
  Beam(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene, std::uint64_t seed);

  // `T_plot_sensor` at the moment of firing, the laser's azimuth then (offset included). Same arguments, same echo.
  sensor::LaserEcho fire(const Pose& T_plot_sensor, std::size_t channel, double azimuth_rad, std::uint64_t pulse) const;

 private:
  struct Return {
    double range_m = 0, signal = 0, brightness = 0, retro_share = 0, bark_depth_m = 0, cos_incidence = 1,
           share = 1;  // of the beam that met the surface
  };
  Return strongest(const RayHit hits[RayBundle::size]) const;
  std::uint8_t intensity(const Return& r, Random& random) const;

  const sensor::SensorModel& sensor_;
  BeamParameters parameters_;
  const RayScene& scene_;
  std::uint64_t seed_;
  struct Laser {
    double cos_elevation = 1, sin_elevation = 0, bias_m = 0;
  };
  std::vector<Laser> lasers_;
};

}  // namespace bole::sim
