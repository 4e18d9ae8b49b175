#include "cloud/raster.h"

#include <algorithm>

namespace bole {
inline namespace cloud {

double Raster::sample(double x, double y) const {
  const double u = (x - origin.x()) / cell_m, v = (y - origin.y()) / cell_m;
  if (!(u >= 0 && v >= 0 && u <= nx && v <= ny)) return std::numeric_limits<double>::quiet_NaN();
  const double cu = std::clamp(u - 0.5, 0.0, nx - 1.0), cv = std::clamp(v - 0.5, 0.0, ny - 1.0);
  const int ix = std::min(static_cast<int>(cu), std::max(0, nx - 2)),
            iy = std::min(static_cast<int>(cv), std::max(0, ny - 2));
  const double fx = cu - ix, fy = cv - iy;
  const int jx = std::min(ix + 1, nx - 1), jy = std::min(iy + 1, ny - 1);
  // A corner of weight zero may be a hole without harm.
  const auto term = [&](int i, int j, double w) { return w == 0 ? 0.0 : w * at(i, j); };
  return term(ix, iy, (1 - fx) * (1 - fy)) + term(jx, iy, fx * (1 - fy)) + term(ix, jy, (1 - fx) * fy) +
         term(jx, jy, fx * fy);
}

}  // namespace cloud
}  // namespace bole
