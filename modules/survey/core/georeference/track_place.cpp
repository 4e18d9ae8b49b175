#include "survey/core/georeference/track_place.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "base/statistics.h"
#include "cloud/table_columns.h"
#include "survey/core/georeference/track_fit.h"

namespace bole::survey {
namespace {

// Errors of a position by its quality in GGA sentences: what is left from fix to fix, and what a whole walk shares.
struct FixError {
  double sd_m = 2, shared_m = 3;
};

FixError error_of(double quality) {
  constexpr double rtk = 4, rtk_float = 5, differential = 2;
  if (quality == rtk) return {0.02, 0.02};
  if (quality == rtk_float) return {0.3, 0.5};
  if (quality == differential) return {0.8, 1};
  return {};
}

struct Track {
  std::vector<TrackFix> fixes;
  std::vector<double> shared_m;
};

Track fixes_of(const Table& track, const geo::ProjectedCrs& crs) {
  if (!track.has("time_s"))
    throw bad_input("the track has no times", "a column time_s", "Read it with its times, or give control points");
  const std::vector<std::string> names(track.rows(), "fix of the track");
  const auto plan = plan_coordinates(track, crs, names);
  const auto time = track.numbers("time_s"), height = numbers_or_nan(track, "height_m"),
             quality = numbers_or_nan(track, "quality"), sd_east = numbers_or_nan(track, "sd_east_m"),
             sd_north = numbers_or_nan(track, "sd_north_m");
  Track out;
  for (std::size_t i = 0; i < track.rows(); ++i) {
    if (!plan[i].allFinite() || !std::isfinite(time[i])) continue;
    if (!out.fixes.empty() && !(time[i] > out.fixes.back().time_s)) continue;
    auto error = error_of(quality[i]);
    if (const double sd = std::hypot(sd_east[i], sd_north[i]) / std::sqrt(2.0); sd > 0) error.sd_m = sd;
    out.fixes.push_back({time[i], {plan[i].x(), plan[i].y(), height[i]}, error.sd_m});
    out.shared_m.push_back(error.shared_m);
  }
  return out;
}

void tell_track_fit(const TrackFit& fit, double shared_m, Report& report) {
  report.counts["fixes"] = static_cast<std::int64_t>(fit.fixes);
  report.metrics["clock_offset"] = {fit.clock_offset_s, Unit::second};
  report.metrics["clock_offset_se"] = {fit.clock_offset_se_s, Unit::second};
  const char* axes[] = {"x", "y", "z"};
  for (Eigen::Index k = 0; k < 3; ++k) {
    report.metrics[fmt::format("lever_{}", axes[k])] = {fit.lever_sensor(k), Unit::metre};
    report.metrics[fmt::format("lever_{}_se", axes[k])] = {fit.lever_se_m(k), Unit::metre};
  }
  report.metrics["turn"] = {degrees(fit.turn_rad), Unit::degree};
  report.metrics["turn_se"] = {degrees(fit.turn_se_rad), Unit::degree};
  report.metrics["shift_se"] = {std::hypot(fit.shift_se_m, shared_m), Unit::metre};
  report.metrics["residual_rms"] = {fit.residual_m, Unit::metre};
  report.metrics["track_outliers"] = {100 * fit.outliers, Unit::percent};
  report.metrics["fixes_per_independent"] = {fit.fixes_per_independent, Unit::none};
  if (fit.heights) report.metrics["height_se"] = {std::hypot(fit.height_se_m, 2 * shared_m), Unit::metre};
  constexpr double many = 0.2;
  if (fit.outliers > many)
    report.find(Severity::look, "track_outliers",
                fmt::format("{:.0f} % of the positions of the track do not follow the walk", 100 * fit.outliers));
}

}  // namespace

Table with_plane_columns(const Table& track) {
  Table out = track;
  if (track.has("latitude_deg") || track.has("easting_m") || !track.has("x_m")) return out;
  out.set("easting_m", track.numbers("x_m"));
  out.set("northing_m", track.numbers("y_m"));
  return out;
}

Georeference place_by_track(const Trajectory& walk, const Table& track, const geo::ProjectedCrs& crs,
                            const LocalPlot& plot, const GeoreferenceOptions& o) {
  const auto read = fixes_of(track, crs);
  if (read.fixes.empty() || walk.poses.size() < 2)
    throw bad_input(
        fmt::format("the track has {} positions with times, the walk {} poses", read.fixes.size(), walk.poses.size()),
        "a track of the walk");
  const auto candidates = o.clock_offset ? std::vector<double>{*o.clock_offset} : usual_clock_offsets(walk, read.fixes);
  const auto clock = find_clock_offset(walk, read.fixes, candidates, o.clock_window);
  const auto fit = fit_track(walk, read.fixes, clock.offset_s, {{o.lever_x, o.lever_y, o.lever_z}, o.lever_sd});
  constexpr double max_turn_se_rad = 0.1, min_extent_m = 5;
  if (fit.extent_m < min_extent_m || fit.turn_se_rad > max_turn_se_rad)
    throw bad_input(
        fmt::format("the walk reaches {:.1f} m and the track scatters by {:.2f} m: the direction of the plot "
                    "is known to {:.1f} deg only",
                    fit.extent_m, fit.residual_m, degrees(fit.turn_se_rad)),
        fmt::format("{:.1f} deg", degrees(max_turn_se_rad)), "Give control points, or a better track");

  Georeference out;
  const double shared_m = o.track_sd ? *o.track_sd : median(read.shared_m);
  tell_track_fit(fit, shared_m, out.report);
  if (clock.rival_s)
    out.report.find(
        Severity::look, "clock_by_overlap",
        fmt::format("the track fits the walk with {:.1f} s between the clocks, and with {:.1f} s as well; the "
                    "first was taken, since more of the recordings overlaps. Check it, or set clock_offset",
                    clock.offset_s, *clock.rival_s));
  auto& frame = out.frame;
  frame.A_global_local = Eigen::AngleAxisd(fit.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.centre_local = fit.centre_local;
  frame.shift_global = fit.centre_global;
  frame.heights_known = fit.heights;
  if (!fit.heights) frame.shift_global.z() = fit.centre_local.z();
  frame.crs_wkt = crs.wkt();
  auto& u = out.uncertainty;
  u.centre_local = fit.centre_local.head<2>();
  u.centre_z_m = fit.centre_local.z();
  u.shift_se_m = std::hypot(fit.shift_se_m, shared_m);
  u.turn_se_rad = fit.turn_se_rad;
  u.tilt_se_rad = radians(o.level_sd_deg);
  const double grid = crs.ground_scale(fit.centre_global.x(), fit.centre_global.y(), frame.shift_global.z());
  u.scale_doubt = std::abs(grid - 1);
  out.report.metrics["grid_scale"] = {grid, Unit::none};
  out.report.facts["crs"] = crs.title();
  set_facts(out.control.facts, frame);
  double worst = 0;
  for (const auto& s : plot.stems) worst = std::max(worst, u.at(s));
  out.report.metrics["frame_se_max"] = {worst, Unit::metre};
  out.report.message = fmt::format(
      "{}: {} positions of the track, scatter {:.2f} m, clocks {:.2f} +- {:.2f} s apart, antenna at ({:.2f}, {:.2f}, "
      "{:.2f}) m of the sensor, turn {:.2f} +- {:.2f} deg, place +- {:.2f} m",
      crs.title(), fit.fixes, fit.residual_m, fit.clock_offset_s, fit.clock_offset_se_s, fit.lever_sensor.x(),
      fit.lever_sensor.y(), fit.lever_sensor.z(), degrees(fit.turn_rad), degrees(fit.turn_se_rad), worst);
  if (fit.heights)
    out.report.find(Severity::note, "track_heights",
                    "heights are those of the track: above the ellipsoid, or above the sea where the receiver gives no "
                    "height of the geoid");
  return out;
}

}  // namespace bole::survey
