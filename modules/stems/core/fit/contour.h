// The outline of a stem across its axis, where it is no circle.
#pragma once

#include <optional>
#include <vector>

namespace bole::stems {

// What a point on the bark says: bearing from the axis and distance from the fitted surface (outside positive).
struct OutlinePoint {
  double bearing_rad = 0;
  double deviation_m = 0;
};

struct Contour {
  double girth_m = 0;  // length of the outline: what a tape reads where it has no hollows
  double ovality = 0;  // widest less narrowest diameter through the axis, by their mean
};

// Fourier series of order 4 through the medians of 10 degree sectors, about a circle of `radius_m` that fits the
// points. Nothing when fewer than 32 of the 36 sectors are seen: an outline cannot be guessed.
std::optional<Contour> fit_contour(const std::vector<OutlinePoint>& points, double radius_m);

}  // namespace bole::stems
