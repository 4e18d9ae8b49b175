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
#include "survey/core/georeference/chosen_control.h"
#include "survey/core/georeference/grid_scale.h"
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
  }

  Georeference place() {
    control_ = choose_control(points_, crs_, plot_.bearing_target_rad, o_, out_.report);
    adjust();
    check_residuals();
    finish();
    return std::move(out_);
  }

 private:
  void adjust() {
    const double height = control_.level.heights ? control_.level.heights->centre_height_m : 0;
    ScaleQuestion question{control_.pairs, control_.known, control_.stated, 1, 0};
    fit_ = fit_plan(question.pairs, 1, control_.known);
    question.grid = crs_.ground_scale(fit_.centre_global.x(), fit_.centre_global.y(), height);
    for (const auto& stem : plot_.stems)
      question.reach_m = std::max(question.reach_m, (stem.head<2>() - fit_.centre_local).norm());
    const auto scale = choose_scale(question, fit_, o_.scale, out_.report);
    if (scale.value != 1) fit_ = fit_plan(question.pairs, scale.value, control_.known);
    out_.uncertainty.scale_doubt = scale.doubt;
  }

  void check_residuals() {
    const auto& rows = control_.rows;
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
      if (i == worst || !control_.used[i] || ++told > max_told) continue;
      distances += fmt::format("{}to '{}' {:.2f} m by coordinates, {:.2f} m in the map", distances.empty() ? "" : "; ",
                               points_[i].name, (points_[i].global - points_[worst].global).head<2>().norm(),
                               (points_[i].local - points_[worst].local).head<2>().norm());
    }
    return fmt::format("the distances between the control points do not fit the plot: '{}' is left with {:.2f} m ({})",
                       points_[worst].name, residual, distances);
  }

  // --- result

  void finish() {
    const auto unit = unit_weight(fit_.chi2, fit_.redundancy, control_.stated);
    if (unit.failed)
      out_.report.find(Severity::look, "control_residuals_large",
                       fmt::format("the residuals of the control points are {:.1f} times as large as control_sd and "
                                   "map_sd say; the standard errors were raised by this factor",
                                   unit.factor));
    const double factor = control_.stated ? unit.factor : open_factor(unit.factor);
    set_frame();
    auto& u = out_.uncertainty;
    u.centre_local = fit_.centre_local;
    u.centre_z_m = control_.level.heights ? control_.level.heights->centre_local.z() : mean_control_z();
    u.shift_se_m = fit_.shift_se_m * factor;
    u.turn_se_rad = fit_.turn_se_rad * factor;
    u.tilt_se_rad = control_.level.tilt_se_rad;
    set_table();
    tell();
  }

  // Where control_sd is open the residuals alone tell the size of the errors, however few they are; what map_sd says
  // is there in any case.
  double open_factor(double assumed) {
    if (fit_.redundancy <= 0) return assumed;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& p : control_.pairs) least = std::min(least, o_.map_sd / p.sd_m);
    const double factor = std::max(least, residual_factor(fit_.chi2, fit_.redundancy));
    if (fit_.redundancy < min_own_freedom)
      out_.report.find(
          Severity::note, "control_sd_open",
          fmt::format("control_sd is open and the control points have {} redundanc{}: the standard error of the place "
                      "({:.1f} cm) rests on that alone and is wide. State control_sd (or sd_m per point) where the "
                      "survey of the points tells it",
                      fit_.redundancy, fit_.redundancy == 1 ? "y" : "ies", 100 * fit_.shift_se_m * factor));
    return factor;
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
    const Eigen::Matrix3d level = control_.level.heights && control_.level.heights->levelled
                                      ? control_.level.heights->R_level_local()
                                      : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(fit_.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d scale(fit_.scale, fit_.scale, 1);
    frame.A_global_local = scale.asDiagonal() * turn * level;
    frame.centre_local = control_.level.heights ? control_.level.heights->centre_local
                                                : Eigen::Vector3d(fit_.centre_local.x(), fit_.centre_local.y(), 0);
    const Eigen::Vector2d at = fit_.to_global(frame.centre_local.head<2>());
    frame.shift_global = {at.x(), at.y(), control_.level.heights ? control_.level.heights->centre_height_m : 0};
    frame.heights_known = control_.level.heights.has_value();
    frame.crs_wkt = crs_.wkt();
  }

  void set_table() {
    out_.control = residual_table({points_, control_.used, control_.notes, control_.misfits, fit_, control_.level});
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
    report.counts["control_points_used"] = static_cast<std::int64_t>(control_.rows.size());
    report.counts["redundancy"] = fit_.redundancy;
    report.facts["crs"] = crs_.title();
    double worst = 0;
    for (const auto& s : plot_.stems) worst = std::max(worst, out_.uncertainty.at(s));
    report.metrics["frame_se_max"] = {worst, Unit::metre};
    report.message = fmt::format(
        "{}: {} of {} control points, residuals {:.1f} cm, turn {:.2f} +- {:.2f} deg, place of "
        "the farthest stem +- {:.1f} cm",
        crs_.title(), control_.rows.size(), points_.size(), 100 * report.metrics["residual_rms"].value, turn_deg,
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
  ChosenControl control_;
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
