// Random numbers that depend on a key alone: (seed, stream, counter) gives the same numbers at any thread count and in
// any order of work. The generator is SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
// OOPSLA 2014).
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace bole {
inline namespace base {

constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter = 0)
      : state_(mix64(mix64(mix64(seed) ^ stream) ^ counter)) {}

  std::uint64_t next() {
    const std::uint64_t value = mix64(state_);
    state_ += 0x9E3779B97F4A7C15ull;
    return value;
  }
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }  // in [0, 1)
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double angle() { return uniform(0, 2 * std::numbers::pi); }
  bool chance(double probability) { return uniform() < probability; }
  int index(int count) { return static_cast<int>(uniform() * count); }
  double normal() {  // Box-Muller
    const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return r * std::cos(angle());
  }
  double normal(double mean, double sd) { return mean + sd * normal(); }
  // A normal deviate kept within `most` standard deviations.
  double bounded_normal(double most = 2.5) {
    for (;;)
      if (const double z = normal(); std::abs(z) <= most) return z;
  }

 private:
  std::uint64_t state_;
};

}  // namespace base
}  // namespace bole
