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
#include "base/statistics.h"
#include "cloud/table_columns.h"
#include "survey/core/georeference/blunders.h"
#include "survey/core/georeference/height_fit.h"
#include "survey/core/georeference/plan_fit.h"

namespace bole::survey {
namespace {

constexpr double normal_975 = 1.959964;
constexpr int min_own_freedom = 3;  // residuals with less do not give a standard deviation of their own

double or_usual(double stated, const std::optional<double>& option, double usual) {
  return std::isfinite(stated) ? stated : option.value_or(usual);
}

// By how much standard errors from stated standard deviations grow.
struct Unit {
  double factor = 1;
  bool failed = false;  // residuals much larger than stated
};

// Of the sum of squares in chance, one in a thousand (Wilson and Hilferty 1931).
double chi2_limit(int freedom) {
  constexpr double normal_999 = 3.0902;
  const double f = freedom, part = 2 / (9 * f);
  return f * std::pow(1 - part + normal_999 * std::sqrt(part), 3);
}

// Stated standard deviations hold unless the residuals contradict them. Assumed ones give way to the residuals where
// these have enough redundancy: then a 95 % interval is that of Student's t, and the factor contains the difference.
Unit unit_of(double chi2, int redundancy, bool stated) {
  if (redundancy <= 0) return {};
  if (stated) {
    if (chi2 <= chi2_limit(redundancy)) return {};
    return {std::sqrt(chi2 / redundancy), true};
  }
  if (redundancy >= min_own_freedom)
    return {std::sqrt(chi2 / redundancy) * student_975(redundancy) / normal_975, false};
  const double freedom = assumed_freedom + redundancy;
  return {std::sqrt((assumed_freedom + chi2) / freedom) * student_975(freedom) / normal_975, false};
}

class Placing {
 public:
  Placing(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs, const LocalPlot& plot,
          const GeoreferenceOptions& options, Report report)
      : points_(points), crs_(crs), plot_(plot), o_(options) {
    out_.report = std::move(report);
    used_.assign(points.size(), true);
    note_.assign(points.size(), "");
    misfit_.assign(points.size(), {no_number, 0, 0, 0});
    for (auto& m : misfit_) m.limit_m = no_number;
    stated_ = o_.control_sd || std::ranges::all_of(points, [](const auto& p) { return std::isfinite(p.sd_m); });
  }

  Georeference place() {
    check_distances(points_);
    adjust_heights();
    known_ = known_turn();
    check_number();
    refuse_mirrored();
    judge_bearing();
    find_blunders();
    choose_scale();
    check_residuals();
    finish();
    return std::move(out_);
  }

 private:
  // --- heights and level

  std::vector<HeightPair> height_pairs() const {
    std::vector<HeightPair> pairs;
    for (const auto i : height_rows_) {
      const auto& p = points_[i];
      const double sd = or_usual(p.height_sd_m, o_.height_sd, usual_height_sd_m);
      pairs.push_back({p.local, p.global.z(), std::hypot(sd, o_.map_sd)});
    }
    return pairs;
  }

  void adjust_heights() {
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (std::isfinite(points_[i].global.z()) && std::isfinite(points_[i].local.z())) height_rows_.push_back(i);
    tilt_se_rad_ = radians(o_.level_sd_deg);
    if (height_rows_.empty()) {
      const bool given = std::ranges::any_of(points_, [](const auto& p) { return std::isfinite(p.global.z()); });
      out_.report.find(Severity::note, "heights_local",
                       given ? "the heights of the control points are not used: the map has no height for them"
                             : "the control points have no heights: heights stay those of the plot");
      return;
    }
    height_stated_ = o_.height_sd || std::ranges::all_of(height_rows_, [&](std::size_t i) {
                       return std::isfinite(points_[i].height_sd_m);
                     });
    drop_height_blunders();
    level_by_heights();
  }

  void drop_height_blunders() {
    constexpr int most = 3;
    for (int k = 0; k < most; ++k) {
      const auto pairs = height_pairs();
      const int worst = height_blunder(pairs, free_level_rad, o_.level, height_stated_);
      if (worst < 0) return;
      const auto row = height_rows_[static_cast<std::size_t>(worst)];
      auto others = pairs;
      others.erase(others.begin() + worst);
      const double off =
          points_[row].global.z() - fit_heights(others, free_level_rad, o_.level).height_of(points_[row].local);
      out_.report.find(Severity::look, "control_height_blunder",
                       fmt::format("the height of control point '{}' is {:+.3f} m off where the others put it{}. Check "
                                   "its height, and whether it was measured on the target or on the ground (height_of)",
                                   points_[row].name, off, o_.leave_out_blunders ? ": it is left out" : ""));
      note_[row] = fmt::format("height {:+.3f} m off", off);
      if (!o_.leave_out_blunders) return;
      height_rows_.erase(height_rows_.begin() + worst);
    }
  }

  // The level of the map is an observation too, unless the heights contradict it.
  void level_by_heights() {
    const auto pairs = height_pairs();
    const double known_rad = radians(o_.level_sd_deg);
    heights_ = fit_heights(pairs, known_rad, o_.level);
    if (heights_->levelled) {
      const auto free = fit_heights(pairs, free_level_rad, true);
      const auto unit = unit_of(free.chi2, static_cast<int>(pairs.size()) - 3, height_stated_);
      const double se = std::sqrt(free.rise_covariance.trace() / 2) * std::max(1.0, unit.factor);
      constexpr double limit = 3.7;
      if (free.rise.norm() > limit * std::hypot(known_rad, se)) {
        heights_ = free;
        out_.report.find(
            Severity::look, "level_changed",
            fmt::format("the control heights tilt the plot by {:.2f} deg +- {:.2f}, more than its level "
                        "was thought to be off (level_sd {} deg). They were followed; if a height is wrong, "
                        "correct it or set level=false",
                        degrees(free.rise.norm()), degrees(se), number_text(o_.level_sd_deg)));
      }
      tilt_se_rad_ = std::sqrt(heights_->rise_covariance.trace() / 2);
      out_.report.metrics["tilt"] = {degrees(heights_->rise.norm()), bole::Unit::degree};
      out_.report.metrics["tilt_se"] = {degrees(tilt_se_rad_), bole::Unit::degree};
    } else if (o_.level) {
      out_.report.facts["level"] =
          pairs.size() < 3 ? "kept: fewer than three control heights" : "kept: the control heights lie on a line";
    }
    const auto unit = unit_of(heights_->chi2, heights_->redundancy, height_stated_);
    out_.report.metrics["height_se"] = {heights_->shift_se_m * unit.factor, bole::Unit::metre};
    if (unit.failed)
      out_.report.find(
          Severity::look, "height_residuals_large",
          fmt::format("the residuals of the control heights are {:.1f} times as large as height_sd says", unit.factor));
    for (const double r : heights_->residuals_m)
      if (std::abs(r) > o_.max_residual)
        throw bad_input(fmt::format("a control height is {:.2f} m off the adjusted plot", r),
                        fmt::format("residuals of at most {} m (max_residual)", number_text(o_.max_residual)),
                        "Check the heights, and whether they were measured on the target or on the ground (height_of)");
  }

  Eigen::Vector3d levelled(Eigen::Vector3d p) const {
    if (!heights_ || !heights_->levelled) return p;
    const Eigen::Vector3d& c = heights_->centre_local;
    if (!std::isfinite(p.z())) p.z() = c.z();
    return c + heights_->R_level_local() * (p - c);
  }

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
    return {levelled(p.local).head<2>(), p.global.head<2>(), sd};
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
    out_.report.metrics["convergence"] = {convergence_deg, bole::Unit::degree};
    if (!o_.bearing_deg) return std::nullopt;
    double grid_deg = *o_.bearing_deg;
    if (o_.bearing_kind == BearingKind::magnetic) grid_deg += o_.declination_deg.value_or(0);
    if (o_.bearing_kind != BearingKind::grid) grid_deg -= convergence_deg;
    out_.report.metrics["grid_bearing"] = {grid_deg, bole::Unit::degree};
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

  // The scale is 1 unless asked for otherwise, or unless the residuals contradict 1 and agree with the grid's.
  void choose_scale() {
    const auto all = pairs();
    fit_ = fit_plan(all, 1, known_);
    const Eigen::Vector2d at = fit_.centre_global;
    const double height = heights_ ? heights_->centre_height_m : 0;
    const double grid = crs_.ground_scale(at.x(), at.y(), height);
    out_.report.metrics["grid_scale"] = {grid, bole::Unit::none};
    const bool free_known = std::isfinite(fit_.free_scale) && all.size() >= 2;
    bool one_fits = true, grid_fits = true, decided = false;
    double se = no_number;
    if (free_known) {
      const double z = (fit_.free_scale - 1) / fit_.free_scale_se;
      const int freedom = fit_.redundancy - 1;
      double unit = 1, limit = std::sqrt(2 * f2_limit(0.01, std::numeric_limits<double>::infinity()));
      bool can_tell = true;
      if (!stated_) {
        can_tell = freedom >= 2;
        constexpr double min_sd_m = 1e-4;  // exact coordinates have digits to 0.1 mm
        if (can_tell) {
          unit = std::max(std::sqrt(std::max(0.0, fit_.chi2 - z * z) / freedom), min_sd_m / all[0].sd_m);
          limit = std::sqrt(2 * f2_limit(0.01, freedom));
        }
      }
      se = fit_.free_scale_se * unit;
      out_.report.metrics["free_scale"] = {fit_.free_scale, bole::Unit::none};
      if (can_tell) {
        out_.report.metrics["free_scale_se"] = {se, bole::Unit::none};
        one_fits = std::abs(fit_.free_scale - 1) <= limit * se;
        grid_fits = std::abs(fit_.free_scale - grid) <= limit * se;
        decided = one_fits != grid_fits;
      }
    }
    const bool take_grid = o_.scale ? *o_.scale == GridScale::grid : decided && grid_fits;
    if (take_grid) fit_ = fit_plan(all, grid, known_);
    if (!o_.scale && !decided) out_.uncertainty.scale_doubt = std::abs(grid - 1);
    tell_scale(take_grid, grid, se, one_fits, grid_fits);
  }

  void tell_scale(bool take_grid, double grid, double se, bool one_fits, bool grid_fits) {
    auto& report = out_.report;
    report.facts["scale"] = take_grid ? "grid" : "one";
    double reach = 0;
    for (const auto& s : plot_.stems) reach = std::max(reach, (s.head<2>() - fit_.centre_local).norm());
    const double effect_mm = 1000 * std::abs(grid - 1) * reach;
    if (!one_fits && !grid_fits)
      report.find(Severity::look, "scale_unexplained",
                  fmt::format("the control points ask for a scale of {:.5f} +- {:.5f}; neither 1 nor that of the grid "
                              "({:.5f}) fits. Check the points farthest out, and the range scale of the sensor",
                              fit_.free_scale, se, grid));
    else if (take_grid && !o_.scale)
      report.find(
          Severity::note, "grid_scale_used",
          fmt::format("the residuals speak for the scale of the grid ({:.6f}: projection and height): it is used",
                      grid));
    else if (o_.scale && (take_grid ? !grid_fits : !one_fits))
      report.find(Severity::look, "scale_contradicts",
                  fmt::format("the control points ask for a scale of {:.5f} +- {:.5f}, which speaks against scale={}",
                              fit_.free_scale, se, choice_name(*o_.scale)));
    else if (constexpr double told_mm = 3; !take_grid && !o_.scale && effect_mm > told_mm)
      report.find(Severity::note, "grid_scale_not_used",
                  fmt::format("a metre in the plot is {:.6f} m on the plane of the coordinate system (projection and "
                              "height). The scale 1 is used: trees at the edge would move by up to {:.0f} mm{}; "
                              "scale=grid applies it",
                              grid, effect_mm, out_.uncertainty.scale_doubt > 0 ? " (part of position_se_m)" : ""));
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
    out_.report.metrics["residual_rms"] = {std::sqrt(sum / static_cast<double>(rows.size())), bole::Unit::metre};
    out_.report.metrics["residual_max"] = {most, bole::Unit::metre};
    if (most > o_.max_residual)
      throw bad_input(misfit_text(worst, most), fits_needed(), "Check the names of the points and their coordinates");
  }

  std::string fits_needed() const {
    return fmt::format("residuals of at most {} m (max_residual)", number_text(o_.max_residual));
  }

  std::string misfit_text(std::size_t worst, double residual) const {
    std::string distances;
    int told = 0;
    constexpr int most_told = 4;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i == worst || !used_[i] || ++told > most_told) continue;
      distances += fmt::format("{}to '{}' {:.2f} m by coordinates, {:.2f} m in the map", distances.empty() ? "" : "; ",
                               points_[i].name, (points_[i].global - points_[worst].global).head<2>().norm(),
                               (points_[i].local - points_[worst].local).head<2>().norm());
    }
    return fmt::format("the distances between the control points do not fit the plot: '{}' is left with {:.2f} m ({})",
                       points_[worst].name, residual, distances);
  }

  // --- result

  void finish() {
    const auto unit = unit_of(fit_.chi2, fit_.redundancy, stated_);
    if (unit.failed)
      out_.report.find(Severity::look, "control_residuals_large",
                       fmt::format("the residuals of the control points are {:.1f} times as large as control_sd and "
                                   "map_sd say; the standard errors were raised by this factor",
                                   unit.factor));
    set_frame();
    auto& u = out_.uncertainty;
    u.centre_local = fit_.centre_local;
    u.centre_z_m = heights_ ? heights_->centre_local.z() : mean_control_z();
    u.shift_se_m = fit_.shift_se_m * unit.factor;
    u.turn_se_rad = fit_.turn_se_rad * unit.factor;
    u.tilt_se_rad = tilt_se_rad_;
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
    const Eigen::Matrix3d level =
        heights_ && heights_->levelled ? heights_->R_level_local() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(fit_.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d scale(fit_.scale, fit_.scale, 1);
    frame.A_global_local = scale.asDiagonal() * turn * level;
    frame.centre_local =
        heights_ ? heights_->centre_local : Eigen::Vector3d(fit_.centre_local.x(), fit_.centre_local.y(), 0);
    const Eigen::Vector2d at = fit_.to_global(frame.centre_local.head<2>());
    frame.shift_global = {at.x(), at.y(), heights_ ? heights_->centre_height_m : 0};
    frame.heights_known = heights_.has_value();
    frame.crs_wkt = crs_.wkt();
  }

  void set_table() {
    std::vector<std::string> names;
    std::vector<double> x, y, z, e, n, h, re, rn, rh, misfit, limit;
    std::vector<std::int64_t> used;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto& p = points_[i];
      names.push_back(p.name);
      x.push_back(p.local.x());
      y.push_back(p.local.y());
      z.push_back(p.local.z());
      e.push_back(p.global.x());
      n.push_back(p.global.y());
      h.push_back(p.global.z());
      const Eigen::Vector2d r = p.global.head<2>() - fit_.to_global(levelled(p.local).head<2>());
      re.push_back(r.x());
      rn.push_back(r.y());
      rh.push_back(heights_ && std::isfinite(p.local.z()) ? p.global.z() - heights_->height_of(p.local) : no_number);
      misfit.push_back(misfit_[i].distance_m);
      limit.push_back(std::isfinite(misfit_[i].limit_m) ? misfit_[i].limit_m : no_number);
      used.push_back(used_[i]);
    }
    auto& t = out_.control;
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
    t.set("note", note_);
    set_fact(t.facts, facts::axes, axes_name(plot_.axes));
    set_facts(t.facts, out_.frame);
  }

  void tell() {
    auto& report = out_.report;
    const double turn_deg = degrees(fit_.turn_rad);
    report.metrics["turn"] = {turn_deg, bole::Unit::degree};
    report.metrics["turn_se"] = {degrees(out_.uncertainty.turn_se_rad), bole::Unit::degree};
    report.metrics["shift_se"] = {out_.uncertainty.shift_se_m, bole::Unit::metre};
    report.metrics["easting"] = {out_.frame.shift_global.x(), bole::Unit::metre};
    report.metrics["northing"] = {out_.frame.shift_global.y(), bole::Unit::metre};
    report.counts["control_points"] = static_cast<std::int64_t>(points_.size());
    report.counts["control_points_used"] = static_cast<std::int64_t>(used_rows().size());
    report.counts["redundancy"] = fit_.redundancy;
    report.facts["crs"] = crs_.title();
    double worst = 0;
    for (const auto& s : plot_.stems) worst = std::max(worst, out_.uncertainty.at(s));
    report.metrics["frame_se_max"] = {worst, bole::Unit::metre};
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

  static constexpr double free_level_rad = 1;

  const std::vector<ControlPoint>& points_;
  const geo::ProjectedCrs& crs_;
  const LocalPlot& plot_;
  const GeoreferenceOptions& o_;
  Georeference out_;
  std::vector<bool> used_;
  std::vector<std::string> note_;
  std::vector<LeftOut> misfit_;
  std::vector<std::size_t> height_rows_;
  bool stated_ = false, height_stated_ = false;
  double tilt_se_rad_ = 0;
  std::optional<HeightFit> heights_;
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
