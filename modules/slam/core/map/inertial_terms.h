// What an inertial unit adds to the adjustment of the whole path: turns between neighbouring nodes, and velocities that
// change as measured, with gravity and slowly varying biases as unknowns.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "slam/core/inertial/inertial_filter.h"
#include "slam/core/map/banded_system.h"
#include "slam/core/map/path.h"

namespace bole::slam {

// The nodes have no velocities of their own. With p0, p1, p2 three places of the unit after each other, T0 and T1
// seconds between them, and the pre-integrated velocity V and shift S of both stretches, the unknown velocities drop
// out of
//   (p2 - p1) / T1 - (p1 - p0) / T0 = g (T0 + T1) / 2 + R0 (V0 - S0 / T0) + R1 S1 / T1.
// Biases are linear between knots. They stand in the border of the banded system, after them gravity, and, where the
// mount of the unit was estimated, its turn and lever arm and the offset of its clock.
class InertialTerms {
 public:
  // `trust`: as SlamOptions::inertial_trust.
  InertialTerms(const InertialUnit& unit, const InertialState& state, double begin_s, double end_s, double trust);

  std::size_t unknowns() const { return 6 * knots_.size() + 3 + calibrated(); }
  // How many of the last unknowns are the mount.
  std::size_t calibrated() const { return unit_.mount_sigmas ? 7 : 0; }
  // How many of the last unknowns have their covariance asked for: gravity, and the mount where it is estimated.
  std::size_t judged() const { return 3 + calibrated(); }
  void add(const Path& path, BandedSystem& system);
  // `covariance`: of the last judged() unknowns, or empty.
  void move(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance);

  // As they are now. `mount_sigmas` only where the mount is estimated.
  const Pose& T_sensor_imu() const { return T_sensor_imu_; }
  double time_offset_s() const { return unit_.time_offset_s + later_s_; }
  const std::optional<MountSigmas>& mount_sigmas() const { return sigmas_; }

  InertialBias bias_at(double time_s) const;
  const Eigen::Vector3d& gravity() const { return gravity_; }
  // Standard deviation of the vertical per axis; nothing before a move that had the covariance.
  std::optional<double> level_sigma_rad() const { return level_sigma_rad_; }
  // Root mean square of the terms in the last add(): turn in rad, change of velocity in m/s.
  double turn_rms() const { return turn_rms_; }
  double velocity_rms() const { return velocity_rms_; }

  // The left side less the right one, for poses of the sensor at three nodes.
  static Eigen::Vector3d velocity_error(const Pose& T_sensor_imu, const Eigen::Vector3d& gravity,
                                        const std::array<Pose, 3>& T_map_sensor, const Preintegration& before,
                                        const Preintegration& after);
  // Its derivatives by turn (map axes) and shift of the three poses.
  static std::array<Eigen::Matrix<double, 3, 6>, 3> velocity_jacobians(const Pose& T_sensor_imu,
                                                                       const std::array<Pose, 3>& T_map_sensor,
                                                                       const Preintegration& before,
                                                                       const Preintegration& after);
  // Its derivatives by a turn of the unit in the sensor (axes of the unit) and by the lever arm.
  static Eigen::Matrix<double, 3, 6> velocity_by_mount(const Pose& T_sensor_imu,
                                                       const std::array<Pose, 3>& T_map_sensor,
                                                       const Preintegration& before, const Preintegration& after);

 private:
  struct Knot {
    std::size_t first = 0;  // the knot before the time; its neighbour follows
    double share = 0;       // of the neighbour
  };
  Knot knot_at(double time_s) const;
  void add_turn(const Path& path, std::size_t node, const Preintegration& by, BandedSystem& system);
  void add_velocity(const Path& path, std::size_t node, const Preintegration& before, const Preintegration& after,
                    BandedSystem& system);
  void add_priors(BandedSystem& system) const;
  void add_mount_prior(BandedSystem& system) const;
  Preintegration integrated(double begin_s, double end_s, double later_s) const;
  Eigen::Vector3d rate_at(double time_s) const;
  // The equation error + B x = 0 on unknowns of the border, with the derivatives by nodes from `first_node` on.
  void add_equation(std::size_t first_node, std::span<const Eigen::Matrix<double, 3, 6>> by_nodes, double time_s,
                    const Eigen::Matrix<double, 3, 6>& by_bias, const Eigen::Matrix<double, 3, 3>& by_gravity,
                    const Eigen::Matrix<double, 3, 7>& by_mount, const Eigen::Vector3d& error,
                    const Eigen::Matrix3d& weight, BandedSystem& system) const;

  const InertialUnit& unit_;
  Pose T_sensor_imu_;
  double later_s_ = 0;  // beside the offset that is in the data already
  std::optional<MountSigmas> sigmas_;
  double begin_s_, spacing_s_, trust_;
  std::vector<InertialBias> knots_;
  Eigen::Vector3d gravity_;
  std::optional<double> level_sigma_rad_;
  double turn_rms_ = 0, velocity_rms_ = 0;
};

}  // namespace bole::slam
