#include "sim/core/walk/scan.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/option.h"
#include "sim/core/scene/rosette.h"

namespace bole::sim {
namespace {

constexpr std::int64_t batch_sequences = 1024;
// Pulses of each beam of a scanner without lines in a sequence: short beside the motion of a hand.
constexpr int rosette_pulses = 8;

// The walk during one firing sequence of some 50 us: uniform motion, with a rotation so small (below 1e-3 rad) that its
// first order is exact to far below a micrometre at 100 m.
class SequenceMotion {
 public:
  SequenceMotion(const Walk& walk, double start_s, double period_s) : start_(walk.pose(start_s)) {
    const Pose end = walk.pose(start_s + period_s);
    velocity_ = (end.translation() - start_.translation()) / period_s;
    turn_ = start_.linear() * skew(so3_log(Eigen::Quaterniond(start_.linear().transpose() * end.linear()))) / period_s;
  }
  Pose at(double within_s) const {
    Pose T = start_;
    T.translation() += within_s * velocity_;
    T.linear() += within_s * turn_;
    return T;
  }

 private:
  Pose start_;
  Eigen::Vector3d velocity_;
  Eigen::Matrix3d turn_;
};

// One batch of sequences, and what they are filled with.
class Scanner {
 public:
  Scanner(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene, const Walk& walk,
          double rotation_hz, std::uint64_t seed)
      : sensor_(sensor),
        walk_(walk),
        beam_(sensor, parameters, scene, seed),
        turn_rad_s_(two_pi * rotation_hz),
        pulses_(sensor.rosette ? static_cast<std::size_t>(sensor.rosette->beams * rosette_pulses)
                               : sensor.channels.size()),
        period_s_(sensor.rosette ? static_cast<double>(pulses_) / sensor.rosette->points_per_s
                                 : sensor.sequence_period_s),
        dual_(parameters.dual) {
    const std::size_t size = static_cast<std::size_t>(batch_sequences) * pulses_;
    echoes_.resize(size);
    if (dual_) last_.resize(size);
    if (sensor.rosette) aims_.resize(size);
  }

  double period_s() const { return period_s_; }
  std::size_t pulses() const { return pulses_; }

  void fire(std::int64_t sequence, std::int64_t place) {
    const double start = static_cast<double>(sequence) * period_s_;
    const SequenceMotion motion(walk_, start, period_s_);
    const std::size_t at = static_cast<std::size_t>(place) * pulses_;
    for (std::size_t c = 0; c < pulses_; ++c) {
      const std::uint64_t pulse = static_cast<std::uint64_t>(sequence) * pulses_ + c;
      Echoes echoes;
      if (sensor_.rosette) {
        const double within = static_cast<double>(c) / sensor_.rosette->points_per_s;
        const auto [azimuth, elevation] = rosette_angles(*sensor_.rosette, static_cast<std::int64_t>(pulse));
        aims_[at + c] = {azimuth, elevation};
        echoes = beam_.fire(motion.at(within), c % static_cast<std::size_t>(sensor_.rosette->beams), aims_[at + c],
                            pulse, start + within);
      } else {
        const double within = sensor_.channels[c].firing_time_s;
        const double azimuth =
            first_azimuth_rad + turn_rad_s_ * (start + within) + sensor_.channels[c].azimuth_offset_rad;
        echoes = beam_.fire(motion.at(within), c, azimuth, pulse, start + within);
      }
      echoes_[at + c] = echoes.strongest;
      if (dual_) last_[at + c] = echoes.last;
    }
  }

  FiringSequence sequence(std::int64_t index, std::int64_t place) const {
    const double time = static_cast<double>(index) * period_s_, azimuth = first_azimuth_rad + turn_rad_s_ * time;
    const auto part = [&](const auto& all) {
      using Value = typename std::decay_t<decltype(all)>::value_type;
      return all.empty() ? std::span<const Value>()
                         : std::span<const Value>(all.data() + static_cast<std::size_t>(place) * pulses_, pulses_);
    };
    return {
        index,       time,        azimuth - two_pi * std::floor(azimuth / two_pi),        turn_rad_s_, part(echoes_),
        part(last_), part(aims_), sensor_.rosette ? 1 / sensor_.rosette->points_per_s : 0};
  }

 private:
  const sensor::SensorModel& sensor_;
  const Walk& walk_;
  Beam beam_;
  double turn_rad_s_;
  std::size_t pulses_;
  double period_s_;
  bool dual_;
  std::vector<sensor::LaserEcho> echoes_, last_;
  std::vector<Aim> aims_;
};

}  // namespace

Aim FiringSequence::aim(const sensor::SensorModel& sensor, std::size_t pulse) const {
  if (!aims.empty()) return aims[pulse];
  // A laser that fires within the sequence does so at a rotor turned further.
  const auto& laser = sensor.channels[pulse];
  return {azimuth_rad + turn_rad_s * laser.firing_time_s + laser.azimuth_offset_rad, laser.elevation_rad};
}

double FiringSequence::delay_s(const sensor::SensorModel& sensor, std::size_t pulse) const {
  return aims.empty() ? sensor.channels[pulse].firing_time_s : static_cast<double>(pulse) * pulse_period_s;
}

ScanStatistics scan(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene,
                    const Walk& walk, double rotation_hz, std::uint64_t seed, const Run& run,
                    const std::function<void(const FiringSequence&)>& sink) {
  Scanner scanner(sensor, parameters, scene, walk, rotation_hz, seed);
  const double period = scanner.period_s();
  const auto total = static_cast<std::int64_t>(std::floor(walk.duration_s() / period));
  ScanStatistics statistics;
  for (std::int64_t first = 0; first < total && !run.asked_to_finish(); first += batch_sequences) {
    const std::int64_t count = std::min(batch_sequences, total - first);
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, 8), [&](const auto& range) {
      for (auto i = range.begin(); i < range.end() && !run.cancelled(); ++i) scanner.fire(first + i, i);
    });
    run.check_cancel();
    for (std::int64_t i = 0; i < count; ++i) {
      const FiringSequence sequence = scanner.sequence(first + i, i);
      statistics.returns +=
          std::ranges::count_if(sequence.echoes, [](const sensor::LaserEcho& e) { return e.range_m > 0; });
      for (std::size_t c = 0; c < sequence.last.size(); ++c)
        statistics.returns += sequence.last[c].range_m > 0 && sequence.last[c].range_m != sequence.echoes[c].range_m;
      sink(sequence);
    }
    statistics.pulses += count * static_cast<std::int64_t>(scanner.pulses());
    const double done = static_cast<double>(first + count) * period;
    run.report(
        static_cast<double>(first + count) / static_cast<double>(total),
        "scanning: " + number_text(std::round(done)) + " of " + number_text(std::round(walk.duration_s())) + " s");
  }
  return statistics;
}

}  // namespace bole::sim
