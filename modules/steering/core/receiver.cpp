#include "steering/core/receiver.h"

#include <cmath>

namespace bole::steering {

namespace {
constexpr std::uint64_t receiver_stream = 1;
}

Receiver::Receiver(const ReceiverOptions& options, std::uint64_t seed) : o_(options), random_(seed, receiver_stream) {
  drift_ = o_.drift * normals();  // the process is old when the drive begins
}

Eigen::Vector2d Receiver::normals() {
  const double x = random_.normal();
  return {x, random_.normal()};
}

void Receiver::advance() {
  const double dt = 1 / o_.rate, keep = std::exp(-dt / o_.drift_time);
  drift_ = keep * drift_ + o_.drift * std::sqrt(1 - keep * keep) * normals();
  jump_ *= std::exp(-dt / o_.jump_time);
  if (random_.chance(o_.jumps_per_hour / 3600 * dt)) jump_ += o_.jump_size * normals();
  outage_left_s_ -= dt;
  if (random_.chance(o_.outages_per_hour / 3600 * dt))
    outage_left_s_ = -o_.outage_length * std::log(1 - random_.uniform());
}

std::optional<Eigen::Vector2d> Receiver::fix(const Eigen::Vector2d& antenna_nav) {
  advance();
  const Eigen::Vector2d seen = antenna_nav + drift_ + jump_ + o_.white_noise * normals();
  if (outage_left_s_ > 0) return std::nullopt;
  return seen;
}

}  // namespace bole::steering
