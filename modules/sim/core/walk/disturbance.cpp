#include "sim/core/walk/disturbance.h"

#include <algorithm>
#include <cmath>

#include "sim/core/scene/noise.h"
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

double Disturbance::range_to_person(const Eigen::Vector3d& ray, const Eigen::Vector2d& middle, double radius_m,
                                    double height_m) const {
  const Eigen::Vector2d way = ray.head<2>();
  const double a = way.squaredNorm(), b = way.dot(middle), c = middle.squaredNorm() - radius_m * radius_m,
               root = b * b - a * c;
  if (a < 1e-9 || root < 0 || b < 0) return 0;
  const double range = (b - std::sqrt(root)) / a, height = parameters_.sensor_height_m + range * ray.z();
  return height > 0 && height < height_m ? range : 0;
}

Eigen::Vector2d Disturbance::operator_offset(double time_s) const {
  const bool on_back = walk_.carrier() == Carrier::backpack;
  const double stride = walk_.stride_rad(time_s), pace = walk_.pace(time_s);
  // The arm swings more than a frame on the back.
  const double swing = (on_back ? 0.02 : 0.05) * pace, ahead = on_back ? 0.25 : -0.45,
               along = ahead + 0.4 * swing * std::sin(2 * stride), across = swing * std::sin(stride + 0.6);
  const double heading = walk_.heading_rad(time_s);
  const Eigen::Vector2d forward(std::cos(heading), std::sin(heading)), left(-forward.y(), forward.x());
  return along * forward + across * left;
}

double Disturbance::clock_error_s(double time_s) const {
  if (parameters_.clock_jitter_s <= 0) return 0;
  // Gradient noise of two octaves has a standard deviation of about 0.28.
  constexpr double noise_sd = 0.28;
  const std::uint64_t key = Random(seed_, Stream::clock).next();
  const double wander = fractal_noise(time_s / 1.7, 0.5, 2, 0.5, key) / noise_sd;
  const double packet_s = packet_sequences * std::max(1e-6, sensor_.sequence_period_s);
  const auto packet = static_cast<std::uint64_t>(time_s / packet_s);
  // A packet does not overtake the one before.
  const double own = std::min(0.3 * parameters_.clock_jitter_s, 0.05 * packet_s);
  return parameters_.clock_jitter_s * wander + own * Random(seed_, Stream::clock, packet).bounded_normal();
}

void Disturbance::disturb(const Pulse& pulse, Random& random) const {
  sensor::LaserEcho& echo = *pulse.strongest;
  const auto nearer = [&](double range, std::uint8_t intensity) {
    if (range >= sensor_.min_range_m && (!(echo.range_m > 0) || range < echo.range_m))
      echo = {static_cast<float>(range), intensity};
  };
  const auto noise = [&] { return parameters_.noise * sensor_.range_sigma_m * random.bounded_normal(); };
  // What no light passes: nothing behind it is seen, and too near there is no return.
  const auto blocked = [&](double range) {
    if (pulse.last && pulse.last->range_m > range) *pulse.last = echo;
  };
  if (parameters_.companion)
    if (const double range =
            range_to_person(pulse.ray, companion_offset(pulse.time_s), companion_radius_m, companion_height_m);
        range > 0) {
      nearer(range + noise(), companion_intensity);
      blocked(range);
    }
  if (parameters_.operator_body)
    if (const double range =
            range_to_person(pulse.ray, operator_offset(pulse.time_s), operator_radius_m, operator_height_m);
        range > 0 && (!(echo.range_m > 0) || range < echo.range_m)) {
      const double measured = range + noise();
      echo = measured >= sensor_.min_range_m ? sensor::LaserEcho{static_cast<float>(measured), companion_intensity}
                                             : sensor::LaserEcho{};
      blocked(range);
    }
  if (random.chance(parameters_.rain))
    nearer(sensor_.min_range_m - drop_depth_m * std::log(1 - random.uniform()), drop_intensity);
  if (in_blind_sector(pulse.azimuth_rad)) {
    echo = {};
    if (pulse.last) *pulse.last = {};
  }
}

bool Disturbance::apply(FiringSequence& sequence) {
  const auto packet_begin = sequence.index / packet_sequences * packet_sequences;
  const double period = sequence.aims.empty() ? sensor_.sequence_period_s
                                              : static_cast<double>(sequence.aims.size()) * sequence.pulse_period_s;
  const double packet_s = static_cast<double>(packet_begin) * period, time = sequence.time_s;
  if (packet_s >= parameters_.gap_at_s && packet_s < parameters_.gap_at_s + parameters_.gap_s) return false;
  sequence.time_s += clock_error_s(time);
  const bool people = parameters_.companion || parameters_.operator_body;
  if (parameters_.blind_sector_rad <= 0 && parameters_.rain <= 0 && !people) return true;
  echoes_.assign(sequence.echoes.begin(), sequence.echoes.end());
  last_.assign(sequence.last.begin(), sequence.last.end());
  const Pose T_plot_sensor = people ? walk_.pose(time) : Pose::Identity();
  for (std::size_t c = 0; c < echoes_.size(); ++c) {
    Random random(seed_, Stream::disturbance,
                  static_cast<std::uint64_t>(sequence.index) * echoes_.size() + static_cast<std::uint64_t>(c));
    const auto [azimuth, elevation] = sequence.aim(sensor_, c);
    const double flat = std::cos(elevation);
    const Eigen::Vector3d ray(flat * std::cos(azimuth), -flat * std::sin(azimuth), std::sin(elevation));
    disturb({&echoes_[c], last_.empty() ? nullptr : &last_[c], T_plot_sensor.linear() * ray, azimuth,
             time + sequence.delay_s(sensor_, c)},
            random);
  }
  sequence.echoes = echoes_;
  if (!last_.empty()) sequence.last = last_;
  return true;
}

}  // namespace bole::sim
