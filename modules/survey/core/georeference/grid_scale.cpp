#include "survey/core/georeference/grid_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/no_number.h"
#include "survey/core/georeference/blunders.h"

namespace bole::survey {
namespace {

// What the points say about the scale.
struct FreeScale {
  double value = no_number, se = no_number;
  bool one_fits = true, grid_fits = true;
  bool decides() const { return one_fits != grid_fits; }
};

FreeScale free_scale(const ScaleQuestion& q, const PlanFit& fit) {
  constexpr double scale_alpha = 0.01;
  FreeScale free{fit.free_scale};
  if (!std::isfinite(fit.free_scale)) return free;
  double unit = 1, freedom = std::numeric_limits<double>::infinity();
  if (!q.sd_stated) {
    freedom = fit.redundancy - 1;
    constexpr double min_freedom = 2, min_sd_m = 1e-4;  // exact coordinates have digits to 0.1 mm
    if (freedom < min_freedom) return free;
    const double z = (fit.free_scale - 1) / fit.free_scale_se;
    unit = std::max(std::sqrt(std::max(0.0, fit.chi2 - z * z) / freedom), min_sd_m / q.pairs[0].sd_m);
  }
  free.se = fit.free_scale_se * unit;
  const double limit = std::sqrt(2 * f2_limit(scale_alpha, freedom)) * free.se;
  free.one_fits = std::abs(free.value - 1) <= limit;
  free.grid_fits = std::abs(free.value - q.grid) <= limit;
  return free;
}

void tell_scale(const ScaleQuestion& q, const FreeScale& free, bool take_grid, const std::optional<GridScale>& asked,
                bool doubtful, Report& report) {
  const double effect_mm = 1000 * std::abs(q.grid - 1) * q.reach_m;
  constexpr double told_mm = 3;
  if (!free.one_fits && !free.grid_fits)
    report.find(Severity::look, "scale_unexplained",
                fmt::format("the control points ask for a scale of {:.5f} +- {:.5f}; neither 1 nor that of the grid "
                            "({:.5f}) fits. Check the points farthest out, and the range scale of the sensor",
                            free.value, free.se, q.grid));
  else if (asked && (take_grid ? !free.grid_fits : !free.one_fits))
    report.find(Severity::look, "scale_contradicts",
                fmt::format("the control points ask for a scale of {:.5f} +- {:.5f}, which speaks against scale={}",
                            free.value, free.se, choice_name(*asked)));
  else if (take_grid && !asked)
    report.find(Severity::note, "grid_scale_used",
                fmt::format("the residuals speak for the scale of the grid ({:.6f}: projection and height): it is used",
                            q.grid));
  else if (!take_grid && !asked && effect_mm > told_mm)
    report.find(Severity::note, "grid_scale_not_used",
                fmt::format("a metre in the plot is {:.6f} m on the plane of the coordinate system (projection and "
                            "height). The scale 1 is used: trees at the edge would move by up to {:.0f} mm{}; "
                            "scale=grid applies it",
                            q.grid, effect_mm, doubtful ? " (part of position_se_m)" : ""));
}

}  // namespace

ChosenScale choose_scale(const ScaleQuestion& q, const PlanFit& fit, const std::optional<GridScale>& asked,
                         Report& report) {
  const auto free = free_scale(q, fit);
  const bool take_grid = asked ? *asked == GridScale::grid : free.decides() && free.grid_fits;
  const bool doubtful = !asked && !free.decides();
  report.metrics["grid_scale"] = {q.grid, Unit::none};
  if (std::isfinite(free.value)) report.metrics["free_scale"] = {free.value, Unit::none};
  if (std::isfinite(free.se)) report.metrics["free_scale_se"] = {free.se, Unit::none};
  report.facts["scale"] = take_grid ? "grid" : "one";
  tell_scale(q, free, take_grid, asked, doubtful, report);
  return {take_grid ? q.grid : 1, doubtful ? std::abs(q.grid - 1) : 0};
}

}  // namespace bole::survey
