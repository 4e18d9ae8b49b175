// How softly the outline of a stem ends across the rays: what tells poses that scatter from ranges that do.
#pragma once

#include <vector>

namespace bole::stems {

// Rays fall evenly across a stem, so that the number of returns by the distance of their ray from the axis falls from
// its plateau to nothing at the radius: at once where the map is sharp, over twice the blur where poses scatter
// sideways. Ranges that are wrong leave the edge where it is. Fits a plateau that ends by a normal distribution, over a
// background of other things, to the distances `impact_m` (metres, not negative) of the rays of one stem. The standard
// deviation of the edge, metres; 0 where too few rays pass near it, or where it does not stand out.
double edge_softness_m(const std::vector<double>& impact_m, double radius_m);

}  // namespace bole::stems
