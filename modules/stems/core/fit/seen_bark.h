// What of a stem's bark took part in a fit, by bearing, and what that leaves open of the diameter.
#pragma once

#include <array>
#include <cstddef>

namespace bole::stems {

class SeenBark {
 public:
  // A point of the bark at this bearing from the axis.
  void add(double bearing_rad);

  // Standard deviation, as a share of the radius, that an oval or three-sided section gives the circle fitted to what
  // was seen: nothing where all sides count alike, and more the more one of them does. At most 0.03.
  double shape_sd() const;

 private:
  static constexpr std::size_t count = 36;
  std::array<double, count> points_{};
};

}  // namespace bole::stems
