#include "survey/core/georeference/georeference.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "cloud/table_columns.h"
#include "survey/core/georeference/blunders.h"
#include "survey/core/georeference/control_level.h"
#include "survey/core/georeference/grid_scale.h"
#include "survey/core/georeference/plan_fit.h"
#include "survey/core/georeference/residual_table.h"
#include "survey/core/georeference/unit_weight.h"

namespace bole::survey {
namespace {

class Placing {
 public:
  Placing(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs, const LocalPlot& plot,
          const GeoreferenceOptions& options, Report report)
      : points_(points), crs_(crs), plot_(plot), o_(options) {
    out_.report = std::move(report);
    used_.assign(points.size(), true);
    misfit_.assign(points.size(), {no_number, 0, 0, 0});
    for (auto& m : misfit_) m.limit_m = no_number;
    stated_ = o_.control_sd || std::ranges::all_of(points, [](const auto& p) { return std::isfinite(p.sd_m); });
  }

  Georeference place() {
    check_distances(points_);
    level_ = control_level(points_, o_, out_.report);
    note_ = level_.notes;
    known_ = known_turn();
    check_number();
    refuse_mirrored();
    judge_bearing();
    find_blunders();
    adjust();
    check_residuals();
    finish();
    return std::move(out_);
  }

 private:
  // --- plan

  std::vector<PlanPair> pairs() const {
    std::vector<PlanPair> all;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (used_[i]) all.push_back(pair(i));
    return all;
  }
  PlanPair pair(std::size_t i) const {
    const auto& p = points_[i];
    const double sd = std::hypot(or_usual(p.sd_m, o_.control_sd, usual_control_sd_m), o_.map_sd);
    return {level_.levelled(p.local).head<2>(), p.global.head<2>(), sd};
  }
  std::vector<std::size_t> used_rows() const {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (used_[i]) rows.push_back(i);
    return rows;
  }

  std::optional<KnownTurn> known_turn() {
    if (points_.empty()) return std::nullopt;
    const auto at = crs_.inverse(points_[0].global.x(), points_[0].global.y());
    const double convergence_deg = crs_.forward(at).convergence_deg;
    out_.report.metrics["convergence"] = {convergence_deg, Unit::degree};
    if (!o_.bearing_deg) return std::nullopt;
    double grid_deg = *o_.bearing_deg;
    if (o_.bearing_kind == BearingKind::magnetic) grid_deg += o_.declination_deg.value_or(0);
    if (o_.bearing_kind != BearingKind::grid) grid_deg -= convergence_deg;
    out_.report.metrics["grid_bearing"] = {grid_deg, Unit::degree};
    return KnownTurn{wrapped(std::numbers::pi / 2 - radians(grid_deg) - plot_.bearing_target_rad),
                     radians(o_.bearing_sd_deg)};
  }

  void check_number() const {
    if (points_.empty())
      throw bad_input("no control point has both coordinates and a place in the map",
                      "two points, or one and a bearing",
                      "Give the points the names of targets (centre, north), or x_m and y_m beside them");
    if (points_.size() == 1 && !known_)
      throw bad_input(fmt::format("there is one control point ('{}'): it gives no direction", points_[0].name),
                      "two points, or one and a bearing", "Measure a second point, or set bearing");
    double widest = 0;
    for (const auto& a : points_)
      for (const auto& b : points_) widest = std::max(widest, (a.local - b.local).head<2>().norm());
    constexpr double min_apart_m = 1;
    if (points_.size() > 1 && widest < min_apart_m && !known_)
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
    if (!known_ || points_.size() < 2) return;
    const auto fit = fit_plan(pairs());
    const double off = wrapped(known_->turn_rad - fit.turn_rad), sd = std::hypot(known_->sd_rad, fit.turn_se_rad);
    constexpr double limit = 3.3;
    if (std::abs(off) <= limit * sd) return;
    out_.report.find(
        Severity::look, "bearing_contradicts",
        fmt::format("the bearing differs by {:+.2f} deg from the direction of the control points (standard "
                    "deviation {:.2f} deg) and is not used. Check declination, its sign, and which point is "
                    "which",
                    degrees(off), degrees(sd)));
    known_.reset();
  }

  void find_blunders() {
    while (true) {
      const auto rows = used_rows();
      const auto tests = leave_one_out(pairs(), 1, known_, stated_);
      for (std::size_t k = 0; k < tests.size(); ++k) misfit_[rows[k]] = tests[k];
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
        note_[row] = "does not fit";
        out_.report.find(Severity::look, "control_blunder_unclear",
                         said + ", but an error of " + others +
                             " would explain it as well: too few points to tell. Measure them again, or add one");
        return;
      }
      const bool leave_out = o_.leave_out_blunders;
      out_.report.find(
          Severity::look, "control_blunder",
          said + (leave_out ? ": it is left out" : "") + ". Check its coordinates, its name and its place in the map");
      note_[row] = leave_out ? "left out: does not fit the others" : "does not fit the others";
      if (!leave_out) return;
      used_[row] = false;
    }
  }

  void adjust() {
    const double height = level_.heights ? level_.heights->centre_height_m : 0;
    ScaleQuestion question{pairs(), known_, stated_, 1, 0};
    fit_ = fit_plan(question.pairs, 1, known_);
    question.grid = crs_.ground_scale(fit_.centre_global.x(), fit_.centre_global.y(), height);
    for (const auto& stem : plot_.stems)
      question.reach_m = std::max(question.reach_m, (stem.head<2>() - fit_.centre_local).norm());
    const auto scale = choose_scale(question, fit_, o_.scale, out_.report);
    if (scale.value != 1) fit_ = fit_plan(question.pairs, scale.value, known_);
    out_.uncertainty.scale_doubt = scale.doubt;
  }

  void check_residuals() {
    const auto rows = used_rows();
    std::size_t worst = 0;
    double most = -1, sum = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double r = fit_.residuals[k].norm();
      sum += r * r;
      if (r > most) {
        most = r;
        worst = rows[k];
      }
    }
    out_.report.metrics["residual_rms"] = {std::sqrt(sum / static_cast<double>(rows.size())), Unit::metre};
    out_.report.metrics["residual_max"] = {most, Unit::metre};
    if (most > o_.max_residual)
      throw bad_input(misfit_text(worst, most), fits_needed(), "Check the names of the points and their coordinates");
  }

  std::string fits_needed() const {
    return fmt::format("residuals of at most {} m (max_residual)", number_text(o_.max_residual));
  }

  std::string misfit_text(std::size_t worst, double residual) const {
    std::string distances;
    int told = 0;
    constexpr int max_told = 4;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i == worst || !used_[i] || ++told > max_told) continue;
      distances += fmt::format("{}to '{}' {:.2f} m by coordinates, {:.2f} m in the map", distances.empty() ? "" : "; ",
                               points_[i].name, (points_[i].global - points_[worst].global).head<2>().norm(),
                               (points_[i].local - points_[worst].local).head<2>().norm());
    }
    return fmt::format("the distances between the control points do not fit the plot: '{}' is left with {:.2f} m ({})",
                       points_[worst].name, residual, distances);
  }

  // --- result

  void finish() {
    const auto unit = unit_weight(fit_.chi2, fit_.redundancy, stated_);
    if (unit.failed)
      out_.report.find(Severity::look, "control_residuals_large",
                       fmt::format("the residuals of the control points are {:.1f} times as large as control_sd and "
                                   "map_sd say; the standard errors were raised by this factor",
                                   unit.factor));
    set_frame();
    auto& u = out_.uncertainty;
    u.centre_local = fit_.centre_local;
    u.centre_z_m = level_.heights ? level_.heights->centre_local.z() : mean_control_z();
    u.shift_se_m = fit_.shift_se_m * unit.factor;
    u.turn_se_rad = fit_.turn_se_rad * unit.factor;
    u.tilt_se_rad = level_.tilt_se_rad;
    set_table();
    tell();
  }

  double mean_control_z() const {
    double sum = 0;
    int n = 0;
    for (const auto& p : points_)
      if (std::isfinite(p.local.z())) {
        sum += p.local.z();
        ++n;
      }
    return n > 0 ? sum / n : 0;
  }

  void set_frame() {
    auto& frame = out_.frame;
    const Eigen::Matrix3d level = level_.heights && level_.heights->levelled
                                      ? level_.heights->R_level_local()
                                      : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(fit_.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d scale(fit_.scale, fit_.scale, 1);
    frame.A_global_local = scale.asDiagonal() * turn * level;
    frame.centre_local = level_.heights ? level_.heights->centre_local
                                        : Eigen::Vector3d(fit_.centre_local.x(), fit_.centre_local.y(), 0);
    const Eigen::Vector2d at = fit_.to_global(frame.centre_local.head<2>());
    frame.shift_global = {at.x(), at.y(), level_.heights ? level_.heights->centre_height_m : 0};
    frame.heights_known = level_.heights.has_value();
    frame.crs_wkt = crs_.wkt();
  }

  void set_table() {
    out_.control = residual_table({points_, used_, note_, misfit_, fit_, level_});
    set_fact(out_.control.facts, facts::axes, axes_name(plot_.axes));
    set_facts(out_.control.facts, out_.frame);
  }

  void tell() {
    auto& report = out_.report;
    const double turn_deg = degrees(fit_.turn_rad);
    report.metrics["turn"] = {turn_deg, Unit::degree};
    report.metrics["turn_se"] = {degrees(out_.uncertainty.turn_se_rad), Unit::degree};
    report.metrics["shift_se"] = {out_.uncertainty.shift_se_m, Unit::metre};
    report.metrics["easting"] = {out_.frame.shift_global.x(), Unit::metre};
    report.metrics["northing"] = {out_.frame.shift_global.y(), Unit::metre};
    report.counts["control_points"] = static_cast<std::int64_t>(points_.size());
    report.counts["control_points_used"] = static_cast<std::int64_t>(used_rows().size());
    report.counts["redundancy"] = fit_.redundancy;
    report.facts["crs"] = crs_.title();
    double worst = 0;
    for (const auto& s : plot_.stems) worst = std::max(worst, out_.uncertainty.at(s));
    report.metrics["frame_se_max"] = {worst, Unit::metre};
    report.message = fmt::format(
        "{}: {} of {} control points, residuals {:.1f} cm, turn {:.2f} +- {:.2f} deg, place of "
        "the farthest stem +- {:.1f} cm",
        crs_.title(), used_rows().size(), points_.size(), 100 * report.metrics["residual_rms"].value, turn_deg,
        degrees(out_.uncertainty.turn_se_rad), 100 * worst);
    if (fit_.redundancy == 0)
      report.find(Severity::look, "control_unchecked",
                  "the control points have no redundancy: an error in one of them would not be seen. Measure one more");
    constexpr double large_se_m = 0.5, odd_turn_deg = 30;
    if (worst > large_se_m)
      report.find(Severity::look, "place_uncertain",
                  fmt::format("the standard error of the place reaches {:.2f} m at the edge of the plot: the control "
                              "points are too near together, or the bearing is too uncertain",
                              worst));
    if (plot_.axes == Axes::plot && std::abs(turn_deg) > odd_turn_deg)
      report.find(
          Severity::note, "north_target_off_north",
          fmt::format("the y axis of the plot points {:.1f} deg from grid north. This is right where the north "
                      "target was not set to the north (survey.frame: north_bearing); else centre and north may "
                      "be exchanged",
                      turn_deg));
  }

  const std::vector<ControlPoint>& points_;
  const geo::ProjectedCrs& crs_;
  const LocalPlot& plot_;
  const GeoreferenceOptions& o_;
  Georeference out_;
  std::vector<bool> used_;
  std::vector<std::string> note_;
  std::vector<LeftOut> misfit_;
  bool stated_ = false;
  ControlLevel level_;
  std::optional<KnownTurn> known_;
  PlanFit fit_;
};

}  // namespace

double FrameUncertainty::at(const Eigen::Vector3d& local) const {
  const double d2 = (local.head<2>() - centre_local).squaredNorm();
  const double dz = std::isfinite(local.z()) ? local.z() - centre_z_m : 0;
  const double turned = turn_se_rad * turn_se_rad + scale_doubt * scale_doubt;
  return std::sqrt(shift_se_m * shift_se_m + turned * d2 / 2 + tilt_se_rad * tilt_se_rad * dz * dz);
}

double bearing_target_rad(const Table* targets) {
  constexpr double y_axis_rad = std::numbers::pi / 2;
  if (targets == nullptr || !targets->has("name")) return y_axis_rad;
  const auto x = targets->numbers("x_m"), y = targets->numbers("y_m");
  std::optional<Eigen::Vector2d> centre, north;
  for (std::size_t i = 0; i < targets->rows(); ++i) {
    const auto name = targets->text("name", i);
    if (name == "centre") centre.emplace(x[i], y[i]);
    if (name == "north") north.emplace(x[i], y[i]);
  }
  if (!centre || !north) return y_axis_rad;
  const Eigen::Vector2d d = *north - *centre;
  return std::atan2(d.y(), d.x());
}

Georeference georeference(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs, const LocalPlot& plot,
                          const GeoreferenceOptions& options, Report report) {
  return Placing(points, crs, plot, options, std::move(report)).place();
}

}  // namespace bole::survey
