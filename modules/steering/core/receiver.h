// A satellite receiver as a tractor meets it: noise, slow drift, jumps and outages of precise point positioning.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/random.h"
#include "steering/core/drive_options.h"

namespace bole::steering {

// Horizontal error of a receiver over time. The slow part is a first-order Gauss-Markov process, as long-term PPP
// errors are usually modelled; a jump is a step that decays; in an outage there is no fix at all.
class Receiver {
 public:
  Receiver(const ReceiverOptions& options, std::uint64_t seed);

  // The next fix of an antenna at `antenna_nav` (metres), 1 / rate seconds after the last; nothing in an outage.
  std::optional<Eigen::Vector2d> fix(const Eigen::Vector2d& antenna_nav);

 private:
  Eigen::Vector2d normals();
  void advance();
  ReceiverOptions o_;
  Random random_;
  Eigen::Vector2d drift_ = Eigen::Vector2d::Zero(), jump_ = Eigen::Vector2d::Zero();
  double outage_left_s_ = 0;
};

}  // namespace bole::steering
