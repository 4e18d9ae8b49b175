// Bark stands out from what lies beside it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::stems {

// How much denser the points lie on the surface than beside it: bark stands out, leaves do not.
class RingDensity {
 public:
  explicit RingDensity(double radius) : radius_(radius) {}
  void add(double distance) {
    on_ += std::abs(distance) < ring_m;
    beside_ += distance >= outer_low_m && distance < outer_high_m;
    beside_ += distance <= -outer_low_m && distance > -outer_high_m;
  }
  double contrast() const {
    const auto area = [&](double from, double to) { return std::numbers::pi * (to * to - from * from); };
    const double on_area = area(std::max(0.0, radius_ - ring_m), radius_ + ring_m);
    const double beside_area = area(radius_ + outer_low_m, radius_ + outer_high_m) +
                               area(std::max(0.0, radius_ - outer_high_m), std::max(0.0, radius_ - outer_low_m));
    return (on_ / on_area) / ((beside_ + 1) / beside_area);
  }

 private:
  static constexpr double ring_m = 0.025, outer_low_m = 0.05, outer_high_m = 0.08;
  double radius_, on_ = 0, beside_ = 0;
};

}  // namespace bole::stems
