// What one laser pulse measures: a diverging beam, surfaces of different brightness, a detector with noise.
#pragma once

#include <array>
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
  double wet = 0;                // 0 dry to 1 soaked: darker surfaces, more pulses lost on bark and leaves
  double angle_error_rad = 0;    // standard deviation of the constant elevation and azimuth errors of a laser
  bool dual = false;             // two returns of each pulse
  bool by_strength = false;      // with `dual`: the two strongest, in place of the strongest and the last
};

// Where a laser points: azimuth clockwise from the sensor's forward axis.
struct Aim {
  double azimuth_rad = 0, elevation_rad = 0;
};

// What a sensor tells of one pulse. Without dual return `last` is no echo. With it, `strongest` is the strongest
// return, or the second strongest where the strongest is the last one too; both are the same where there is one return.
// With `by_strength` they are the strongest and the second strongest.
struct Echoes {
  sensor::LaserEcho strongest, last;
};

class Beam {
 public:
  // Throws Error{bad_input} for a calibration that corrects ranges at two distances: it is not simulated.
  Beam(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene, std::uint64_t seed);

  // `T_plot_sensor` at the moment of firing, the laser's azimuth then (offset included). Same arguments, same echo.
  sensor::LaserEcho fire(const Pose& T_plot_sensor, std::size_t channel, double azimuth_rad, std::uint64_t pulse) const;
  Echoes fire(const Pose& T_plot_sensor, std::size_t channel, double azimuth_rad, std::uint64_t pulse,
              double time_s) const;
  // The same for a scanner without lines: `laser` counts its beams.
  Echoes fire(const Pose& T_plot_sensor, std::size_t laser, const Aim& aim, std::uint64_t pulse, double time_s) const;

 private:
  struct Return {
    double range_m = 0, signal = 0, brightness = 0, retro_share = 0, bark_depth_m = 0, cos_incidence = 1,
           share = 1;  // of the beam that met the surface
  };
  // Surfaces that one pulse tells apart, nearest first.
  struct Returns {
    std::array<Return, RayBundle::size> list;
    std::size_t count = 0, strongest = 0;
  };
  // The direction of a pulse as its laser really points, and its constant error.
  struct Shot {
    double cos_elevation = 1, sin_elevation = 0, azimuth_rad = 0, bias_m = 0;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the laser, in the sensor's axes
  };
  Echoes measure(const Pose& T_plot_sensor, const Shot& shot, std::uint64_t pulse, double time_s) const;
  RayBundle rays_of(const Pose& T_plot_sensor, const Shot& shot, const Eigen::Vector3d& axis, double spin) const;
  Returns returns_of(const RayHit hits[RayBundle::size]) const;
  // Detection, bark and noise.
  sensor::LaserEcho echo_of(Return r, const RayHit hits[RayBundle::size], const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& axis, double bias_m, Random& random) const;
  void soak(RayHit& hit) const;
  bool lost_in_water(const RayHit hits[RayBundle::size], std::uint64_t pulse) const;
  std::uint8_t intensity(const Return& r, Random& random) const;

  const sensor::SensorModel& sensor_;
  BeamParameters parameters_;
  const RayScene& scene_;
  std::uint64_t seed_;
  struct Laser {
    double cos_elevation = 1, sin_elevation = 0, bias_m = 0;
    double elevation_error_rad = 0, azimuth_error_rad = 0, elevation_rad = 0;
    sensor::LaserOffsets offsets;
    bool off_centre = false;
  };
  std::vector<Laser> lasers_;
};

}  // namespace bole::sim
