#include "survey/core/georeference/chosen_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "survey/core/georeference/unit_weight.h"

namespace bole::survey {
namespace {

class ControlChooser {
 public:
  ControlChooser(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs, double bearing_target_rad,
                 const GeoreferenceOptions& options, Report& report)
      : points_(points), crs_(crs), bearing_target_rad_(bearing_target_rad), o_(options), report_(report) {
    out_.used.assign(points.size(), true);
    out_.misfits.assign(points.size(), {no_number, 0, 0, 0});
    for (auto& m : out_.misfits) m.limit_m = no_number;
    out_.stated = o_.control_sd || std::ranges::all_of(points, [](const auto& p) { return std::isfinite(p.sd_m); });
  }

  ChosenControl choose() {
    check_distances(points_);
    out_.level = control_level(points_, o_, report_);
    out_.notes = out_.level.notes;
    out_.known = known_turn();
    check_number();
    refuse_mirrored();
    judge_bearing();
    find_blunders();
    out_.rows = used_rows();
    out_.pairs = pairs();
    return std::move(out_);
  }

 private:
  std::vector<PlanPair> pairs() const {
    std::vector<PlanPair> all;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (out_.used[i]) all.push_back(pair(i));
    return all;
  }
  PlanPair pair(std::size_t i) const {
    const auto& p = points_[i];
    const double sd = std::hypot(or_usual(p.sd_m, o_.control_sd, usual_control_sd_m), o_.map_sd);
    return {out_.level.levelled(p.local).head<2>(), p.global.head<2>(), sd};
  }
  std::vector<std::size_t> used_rows() const {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < out_.used.size(); ++i)
      if (out_.used[i]) rows.push_back(i);
    return rows;
  }

  std::optional<KnownTurn> known_turn() {
    if (points_.empty()) return std::nullopt;
    const auto at = crs_.inverse(points_[0].global.x(), points_[0].global.y());
    const double convergence_deg = crs_.forward(at).convergence_deg;
    report_.metrics["convergence"] = {convergence_deg, Unit::degree};
    if (!o_.bearing_deg) return std::nullopt;
    double grid_deg = *o_.bearing_deg;
    if (o_.bearing_kind == BearingKind::magnetic) grid_deg += o_.declination_deg.value_or(0);
    if (o_.bearing_kind != BearingKind::grid) grid_deg -= convergence_deg;
    report_.metrics["grid_bearing"] = {grid_deg, Unit::degree};
    return KnownTurn{wrapped(std::numbers::pi / 2 - radians(grid_deg) - bearing_target_rad_),
                     radians(o_.bearing_sd_deg)};
  }

  void check_number() const {
    if (points_.empty())
      throw bad_input("no control point has both coordinates and a place in the map",
                      "two points, or one and a bearing",
                      "Give the points the names of targets (centre, north), or x_m and y_m beside them");
    if (points_.size() == 1 && !out_.known)
      throw bad_input(fmt::format("there is one control point ('{}'): it gives no direction", points_[0].name),
                      "two points, or one and a bearing", "Measure a second point, or set bearing");
    double widest = 0;
    for (const auto& a : points_)
      for (const auto& b : points_) widest = std::max(widest, (a.local - b.local).head<2>().norm());
    constexpr double min_apart_m = 1;
    if (points_.size() > 1 && widest < min_apart_m && !out_.known)
      throw bad_input(fmt::format("the control points lie within {:.2f} m of one another in the map: they give no "
                                  "direction",
                                  widest),
                      fmt::format("points more than {:g} m apart, or a bearing", min_apart_m),
                      "Measure a point at the other end of the plot");
  }

  // Easting and northing exchanged mirror the plot, which no turn undoes.
  void refuse_mirrored() const {
    if (points_.size() < 3) return;
    const auto all = pairs();
    const auto fit = fit_plan(all);
    const double rms = std::sqrt(fit.chi2 / static_cast<double>(all.size())) * all[0].sd_m;
    const double mirrored = mirrored_rms_m(all);
    constexpr double much_better = 0.2, min_rms_m = 0.5;
    if (rms > min_rms_m && mirrored < much_better * rms)
      throw bad_input(
          fmt::format("the control points fit the map only when it is mirrored (residuals {:.2f} m, mirrored "
                      "{:.2f} m)",
                      rms, mirrored),
          "the easting in easting_m and the northing in northing_m",
          "Exchange the two columns, or check which point has which name");
  }

  void judge_bearing() {
    if (!out_.known || points_.size() < 2) return;
    const auto fit = fit_plan(pairs());
    const double off = wrapped(out_.known->turn_rad - fit.turn_rad),
                 sd = std::hypot(out_.known->sd_rad, fit.turn_se_rad);
    constexpr double limit = 3.3;
    if (std::abs(off) <= limit * sd) return;
    report_.find(Severity::look, "bearing_contradicts",
                 fmt::format("the bearing differs by {:+.2f} deg from the direction of the control points (standard "
                             "deviation {:.2f} deg) and is not used. Check declination, its sign, and which point is "
                             "which",
                             degrees(off), degrees(sd)));
    out_.known.reset();
  }

  void find_blunders() {
    while (true) {
      const auto rows = used_rows();
      const auto tests = leave_one_out(pairs(), 1, out_.known, out_.stated);
      for (std::size_t k = 0; k < tests.size(); ++k) out_.misfits[rows[k]] = tests[k];
      const auto found = snoop(tests);
      if (found.worst < 0) return;
      const auto row = rows[static_cast<std::size_t>(found.worst)];
      const auto& test = tests[static_cast<std::size_t>(found.worst)];
      const std::string said =
          fmt::format("control point '{}' lies {:.3f} m from where the others put it (limit {:.3f} m)",
                      points_[row].name, test.distance_m, test.limit_m);
      if (!found.also.empty()) {
        std::string others;
        for (const int k : found.also)
          others += fmt::format("{}'{}'", others.empty() ? "" : ", ", points_[rows[static_cast<std::size_t>(k)]].name);
        out_.notes[row] = "does not fit";
        report_.find(Severity::look, "control_blunder_unclear",
                     said + ", but an error of " + others +
                         " would explain it as well: too few points to tell. Measure them again, or add one");
        return;
      }
      const bool leave_out = o_.leave_out_blunders;
      report_.find(
          Severity::look, "control_blunder",
          said + (leave_out ? ": it is left out" : "") + ". Check its coordinates, its name and its place in the map");
      out_.notes[row] = leave_out ? "left out: does not fit the others" : "does not fit the others";
      if (!leave_out) return;
      out_.used[row] = false;
    }
  }

  const std::vector<ControlPoint>& points_;
  const geo::ProjectedCrs& crs_;
  double bearing_target_rad_;
  const GeoreferenceOptions& o_;
  Report& report_;
  ChosenControl out_;
};

}  // namespace

ChosenControl choose_control(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs,
                             double bearing_target_rad, const GeoreferenceOptions& options, Report& report) {
  return ControlChooser(points, crs, bearing_target_rad, options, report).choose();
}

}  // namespace bole::survey
