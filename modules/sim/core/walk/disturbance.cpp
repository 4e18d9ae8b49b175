#include "sim/core/walk/disturbance.h"

#include <algorithm>
#include <cmath>

#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

// Every packet format holds a whole fraction of this many sequences.
constexpr std::int64_t packet_sequences = 24;
constexpr double drop_depth_m = 6;  // mean way to a drop that sends enough light back
constexpr std::uint8_t drop_intensity = 2, companion_intensity = 25;

}  // namespace

Disturbance::Disturbance(const DisturbanceParameters& parameters, const sensor::SensorModel& sensor, const Walk& walk,
                         std::uint64_t seed)
    : parameters_(parameters), sensor_(sensor), walk_(walk), seed_(seed) {}

Eigen::Vector2d Disturbance::companion_offset(double time_s) {
  const double a = two_pi * time_s / 20;
  return 1.2 * Eigen::Vector2d(std::cos(a), std::sin(a));
}

bool Disturbance::in_blind_sector(double azimuth_rad) const {
  return std::abs(std::remainder(azimuth_rad - first_azimuth_rad, two_pi)) < 0.5 * parameters_.blind_sector_rad;
}

double Disturbance::range_to_companion(const Pose& T_plot_sensor, const Eigen::Vector3d& in_sensor,
                                       double time_s) const {
  const Eigen::Vector3d ray = T_plot_sensor.linear() * in_sensor;
  const Eigen::Vector2d middle = companion_offset(time_s), way = ray.head<2>();
  const double a = way.squaredNorm(), b = way.dot(middle),
               c = middle.squaredNorm() - companion_radius_m * companion_radius_m, root = b * b - a * c;
  if (a < 1e-9 || root < 0 || b < 0) return 0;
  const double range = (b - std::sqrt(root)) / a, height = parameters_.sensor_height_m + range * ray.z();
  return height > 0 && height < companion_height_m ? range : 0;
}

bool Disturbance::apply(FiringSequence& sequence) {
  const auto packet_begin = sequence.index / packet_sequences * packet_sequences;
  const double packet_s = static_cast<double>(packet_begin) * sensor_.sequence_period_s;
  if (packet_s >= parameters_.gap_at_s && packet_s < parameters_.gap_at_s + parameters_.gap_s) return false;
  if (parameters_.blind_sector_rad <= 0 && parameters_.rain <= 0 && !parameters_.companion) return true;
  echoes_.assign(sequence.echoes.begin(), sequence.echoes.end());
  const Pose T_plot_sensor = parameters_.companion ? walk_.pose(sequence.time_s) : Pose::Identity();
  for (std::size_t c = 0; c < echoes_.size(); ++c) {
    sensor::LaserEcho& echo = echoes_[c];
    const auto& laser = sensor_.channels[c];
    Random random(seed_, Stream::disturbance,
                  static_cast<std::uint64_t>(sequence.index) * echoes_.size() + static_cast<std::uint64_t>(c));
    const double azimuth = sequence.azimuth_rad + sequence.turn_rad_s * laser.firing_time_s + laser.azimuth_offset_rad;
    const auto nearer = [&](double range, std::uint8_t intensity) {
      if (range >= sensor_.min_range_m && (!(echo.range_m > 0) || range < echo.range_m))
        echo = {static_cast<float>(range), intensity};
    };
    if (parameters_.companion) {
      const double flat = std::cos(laser.elevation_rad);
      const Eigen::Vector3d ray(flat * std::cos(azimuth), -flat * std::sin(azimuth), std::sin(laser.elevation_rad));
      if (const double range = range_to_companion(T_plot_sensor, ray, sequence.time_s + laser.firing_time_s); range > 0)
        nearer(range + parameters_.noise * sensor_.range_sigma_m * random.bounded_normal(), companion_intensity);
    }
    if (random.chance(parameters_.rain))
      nearer(sensor_.min_range_m - drop_depth_m * std::log(1 - random.uniform()), drop_intensity);
    if (in_blind_sector(azimuth)) echo = {};
  }
  sequence.echoes = echoes_;
  return true;
}

}  // namespace bole::sim
