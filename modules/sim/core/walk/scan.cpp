#include "sim/core/walk/scan.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/option.h"

namespace bole::sim {
namespace {

constexpr std::int64_t batch_sequences = 1024;

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

}  // namespace

ScanStatistics scan(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene,
                    const Walk& walk, double rotation_hz, std::uint64_t seed, const Run& run,
                    const std::function<void(const FiringSequence&)>& sink) {
  const Beam beam(sensor, parameters, scene, seed);
  const std::size_t lasers = sensor.channels.size();
  const double turn_rad_s = two_pi * rotation_hz, period = sensor.sequence_period_s;
  const auto total = static_cast<std::int64_t>(std::floor(walk.duration_s() / period));
  std::vector<sensor::LaserEcho> echoes(static_cast<std::size_t>(batch_sequences) * lasers);
  ScanStatistics statistics;
  const auto fire = [&](std::int64_t sequence, sensor::LaserEcho* out) {
    const double start = static_cast<double>(sequence) * period;
    const SequenceMotion motion(walk, start, period);
    for (std::size_t c = 0; c < lasers; ++c) {
      const double within = sensor.channels[c].firing_time_s;
      const double azimuth = first_azimuth_rad + turn_rad_s * (start + within) + sensor.channels[c].azimuth_offset_rad;
      out[c] = beam.fire(motion.at(within), c, azimuth, static_cast<std::uint64_t>(sequence) * lasers + c);
    }
  };
  for (std::int64_t first = 0; first < total && !run.asked_to_finish(); first += batch_sequences) {
    const std::int64_t count = std::min(batch_sequences, total - first);
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, 8), [&](const auto& range) {
      for (auto i = range.begin(); i < range.end() && !run.cancelled(); ++i)
        fire(first + i, echoes.data() + static_cast<std::size_t>(i) * lasers);
    });
    run.check_cancel();
    for (std::int64_t i = 0; i < count; ++i) {
      const std::span<const sensor::LaserEcho> sequence(echoes.data() + static_cast<std::size_t>(i) * lasers, lasers);
      statistics.returns += std::ranges::count_if(sequence, [](const sensor::LaserEcho& e) { return e.range_m > 0; });
      const double time = static_cast<double>(first + i) * period, azimuth = first_azimuth_rad + turn_rad_s * time;
      sink({first + i, time, azimuth - two_pi * std::floor(azimuth / two_pi), turn_rad_s, sequence});
    }
    statistics.pulses += count * static_cast<std::int64_t>(lasers);
    const double done = static_cast<double>(first + count) * period;
    run.report(
        static_cast<double>(first + count) / static_cast<double>(total),
        "scanning: " + number_text(std::round(done)) + " of " + number_text(std::round(walk.duration_s())) + " s");
  }
  return statistics;
}

}  // namespace bole::sim
