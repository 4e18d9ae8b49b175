#include "survey/core/georeference/residual_table.h"

#include <cmath>

#include "base/no_number.h"

namespace bole::survey {

Table residual_table(const AdjustedPoints& a) {
  std::vector<std::string> names;
  std::vector<double> x, y, z, e, n, h, re, rn, rh, misfit, limit;
  std::vector<std::int64_t> used;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const auto& p = a.points[i];
    names.push_back(p.name);
    x.push_back(p.local.x());
    y.push_back(p.local.y());
    z.push_back(p.local.z());
    e.push_back(p.global.x());
    n.push_back(p.global.y());
    h.push_back(p.global.z());
    const Eigen::Vector2d r = p.global.head<2>() - a.fit.to_global(a.level.levelled(p.local).head<2>());
    re.push_back(r.x());
    rn.push_back(r.y());
    rh.push_back(a.level.heights && std::isfinite(p.local.z()) ? p.global.z() - a.level.heights->height_of(p.local)
                                                               : no_number);
    misfit.push_back(a.misfits[i].distance_m);
    limit.push_back(std::isfinite(a.misfits[i].limit_m) ? a.misfits[i].limit_m : no_number);
    used.push_back(a.used[i] ? 1 : 0);
  }
  Table t;
  t.set("name", std::move(names));
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  t.set("z_m", std::move(z));
  t.set("easting_m", std::move(e));
  t.set("northing_m", std::move(n));
  t.set("height_m", std::move(h));
  t.set("residual_east_m", std::move(re));
  t.set("residual_north_m", std::move(rn));
  t.set("residual_height_m", std::move(rh));
  t.set("misfit_m", std::move(misfit));
  t.set("misfit_limit_m", std::move(limit));
  t.set("used", std::move(used));
  t.set("note", a.notes);
  return t;
}

}  // namespace bole::survey
