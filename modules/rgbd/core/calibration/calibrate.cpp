#include "rgbd/core/calibration/calibrate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "base/error.h"
#include "camera/camera_json.h"

namespace bole::rgbd {
namespace {

constexpr double interval = 1.96;  // standard deviations of 95 %
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// The rows of the table of parameters.
class ParameterRows {
 public:
  void add(const std::string& name, double value, double sd, const std::string& unit) {
    names_.push_back(name);
    values_.push_back(value);
    const bool known = sd > 0 && std::isfinite(sd);
    sds_.push_back(known ? sd : missing);
    lows_.push_back(known ? value - interval * sd : missing);
    highs_.push_back(known ? value + interval * sd : missing);
    units_.push_back(unit);
  }
  void add_camera(const std::string& prefix, const CameraModel& camera, const std::array<double, 9>& sd) {
    const auto& d = camera.distortion;
    const std::array values{camera.fx, camera.fy, camera.cx, camera.cy, d[0], d[1], d[2], d[3], d[4]};
    for (std::size_t i = 0; i < values.size(); ++i)
      add(prefix + intrinsic_names[i], values[i], sd[i], i < 4 ? "px" : "");
  }
  void add_pose(const Pose& pose, const Vector6d& sd) {
    const Eigen::Vector3d turn = so3_log(Eigen::Quaterniond(pose.linear()));
    constexpr std::array axes{"x", "y", "z"};
    for (int i = 0; i < 3; ++i)
      add(std::string("depth_to_color_r") + axes[static_cast<std::size_t>(i)], deg_per_rad * turn[i],
          deg_per_rad * sd[i], "deg");
    for (int i = 0; i < 3; ++i)
      add(std::string("depth_to_color_t") + axes[static_cast<std::size_t>(i)], 1000 * pose.translation()[i],
          1000 * sd[i + 3], "mm");
  }
  Table table() && {
    Table table;
    table.set("parameter", std::move(names_));
    table.set("value", std::move(values_));
    table.set("sd", std::move(sds_));
    table.set("low", std::move(lows_));
    table.set("high", std::move(highs_));
    table.set("unit", std::move(units_));
    return table;
  }

 private:
  std::vector<std::string> names_, units_;
  std::vector<double> values_, sds_, lows_, highs_;
};

Table residual_table(const std::vector<BoardShot>& shots, const CameraFit& fit, const std::optional<DepthFit>& depth) {
  std::vector<std::string> names, states;
  std::vector<std::int64_t> corners;
  std::vector<double> rms, distance, tilt, bias;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const auto& shot = shots[i];
    const bool placed = fit.shots[i].rms_px > 0;
    const Pose& T = fit.shots[i].T_camera_board;
    names.push_back(shot.name);
    states.push_back(shot.left_out.empty() ? "used" : shot.left_out);
    corners.push_back(static_cast<std::int64_t>(shot.corners.size()));
    rms.push_back(placed ? fit.shots[i].rms_px : missing);
    distance.push_back(placed ? T.translation().norm() : missing);
    tilt.push_back(placed ? degrees(std::acos(std::min(1.0, std::abs(T.linear()(2, 2))))) : missing);
    bias.push_back(missing);
    if (!depth) continue;
    for (const auto& v : depth->views)
      if (v.shot == i) bias.back() = 1000 * v.bias;
  }
  Table table;
  table.set("view", std::move(names));
  table.set("state", std::move(states));
  table.set("corners", std::move(corners));
  table.set("residual_px", std::move(rms));
  table.set("distance_m", std::move(distance));
  table.set("tilt_deg", std::move(tilt));
  if (depth) table.set("depth_bias_mm", std::move(bias));
  return table;
}

// A guess good enough to find the corners of markers.
CameraModel first_camera(const ViewSource& views) { return views.camera(0).color; }

struct Shots {
  std::vector<BoardShot> shots;
  int width = 0, height = 0;
};

Shots find_shots(const ViewSource& views, const CalibrationOptions& options, const Run& run) {
  Shots out;
  const auto camera = first_camera(views);
  out.width = camera.width;
  out.height = camera.height;
  out.shots = find_boards(views, board_to_find(views, options), camera, run);
  return out;
}

Shots shots_of(const CalibrationInput& input, const CalibrationOptions& options, const Run& run) {
  if (input.views != nullptr) {
    if (input.views->size() == 0) throw bad_input("there are no views", "pictures of a board");
    return find_shots(*input.views, options, run);
  }
  if (input.corners == nullptr)
    throw bad_input("neither views nor corners are connected", "pictures of a board, or a table of its corners");
  if (!options.width || !options.height)
    throw bad_input("the size of the images is not given", "the options width and height, in pixels");
  return {shots_of_table(*input.corners), *options.width, *options.height};
}

// Strong distortion hides markers from a board that is looked for without it: once it is known, more are found.
void look_again(const ViewSource& views, const CalibrationOptions& options, const Run& run, Shots& found,
                CameraFit& fit, Report& report) {
  constexpr double strong_px = 5;
  auto plain = fit.camera;
  plain.distortion = {};
  const Eigen::Vector2d corner(0, 0);
  const auto bent = plain.project(fit.camera.direction(corner));
  if (!bent || (*bent - corner).norm() < strong_px) return;
  auto again = find_boards(views, board_to_find(views, options), fit.camera, run);
  const auto count = [](const std::vector<BoardShot>& shots) {
    std::size_t corners = 0;
    for (const auto& s : shots) corners += s.corners.size();
    return corners;
  };
  if (count(again) <= count(found.shots)) return;
  Report second;
  auto better = fit_camera(again, found.width, found.height, options, run, second);
  found.shots = std::move(again);
  fit = std::move(better);
  report = std::move(second);
}

void tell_camera(const CameraFit& fit, const std::vector<BoardShot>& shots, Report& report) {
  const auto used = std::ranges::count_if(shots, [](const BoardShot& s) { return s.left_out.empty(); });
  report.counts["views"] = static_cast<std::int64_t>(shots.size());
  report.counts["views_used"] = static_cast<std::int64_t>(used);
  report.counts["corners"] = static_cast<std::int64_t>(fit.residuals.size());
  report.metrics["residual"] = {fit.rms_px, Unit::pixel};
  report.metrics["coverage"] = {100 * fit.coverage, Unit::percent};
  report.metrics["spread_of_tilts"] = {degrees(fit.spread_rad), Unit::degree};
  report.facts["distortion"] = choice_name(fit.terms);
}

void tell_depth(const DepthFit& fit, Report& report) {
  report.counts["depth_views"] = static_cast<std::int64_t>(fit.views.size());
  report.metrics["depth_residual_before"] = {1000 * fit.rms_before, Unit::millimetre};
  report.metrics["depth_residual"] = {1000 * fit.rms_after, Unit::millimetre};
  if (fit.degree < 0) return;
  const auto [low, high] = std::ranges::minmax(fit.views, {}, &ViewDepth::distance);
  report.facts["depth_bias_range"] =
      std::to_string(low.distance).substr(0, 5) + " to " + std::to_string(high.distance).substr(0, 5) + " m";
}

// The depth camera by its own pictures of the board.
std::optional<StereoFit> take_infrared(const CalibrationInput& input, const CalibrationOptions& options,
                                       const Shots& color_shots, const CameraFit& color, const Run& run,
                                       ParameterRows& rows, RgbdCamera& camera, Report& report) {
  if (input.infrared == nullptr || input.views == nullptr) return std::nullopt;
  auto found = find_shots(*input.infrared, options, run);
  Report own;
  const auto fit = fit_camera(found.shots, found.width, found.height, options, run, own);
  for (auto& finding : own.findings)
    report.find(finding.severity, finding.code + "_infrared", "depth camera: " + finding.text);
  auto stereo = fit_stereo(*input.views, color_shots.shots, color, *input.infrared, found.shots, fit);
  camera.depth = fit.camera;
  camera.T_color_depth = stereo.T_color_other;
  report.metrics["infrared_residual"] = {fit.rms_px, Unit::pixel};
  report.metrics["stereo_residual"] = {stereo.rms_px, Unit::pixel};
  report.counts["stereo_views"] = static_cast<std::int64_t>(stereo.views);
  if (stereo.left_out > 0)
    report.find(
        Severity::look, "stereo_views_left_out",
        std::to_string(stereo.left_out) + " pairs of views give the depth camera another place and are left out");
  rows.add_camera("depth_", fit.camera, fit.sd);
  rows.add_pose(stereo.T_color_other, stereo.sd);
  return stereo;
}

}  // namespace

Calibration calibrate(const CalibrationInput& input, const CalibrationOptions& options, const Run& run) {
  Calibration out;
  auto found = shots_of(input, options, run.part(0, 0.5));
  auto fit = fit_camera(found.shots, found.width, found.height, options, run.part(0.5, 0.8), out.report);
  if (input.views != nullptr) look_again(*input.views, options, run.part(0.6, 0.8), found, fit, out.report);
  ParameterRows rows;
  rows.add_camera("", fit.camera, fit.sd);
  if (input.views != nullptr) out.camera = input.views->camera(0);
  out.camera.color = fit.camera;
  const auto stereo = take_infrared(input, options, found, fit, run.part(0.8, 0.9), rows, out.camera, out.report);
  if (options.depth && input.views != nullptr && input.views->has_depth()) {
    const DepthUnknowns unknowns{.pose = !stereo, .bias = true};
    out.depth = fit_depth(*input.views, found.shots, fit, out.camera, unknowns, run.part(0.9, 1), out.report);
  }
  std::vector<double> bias;
  if (out.depth) {
    out.camera = out.depth->camera;
    if (out.depth->moved) rows.add_pose(out.camera.T_color_depth, out.depth->sd_pose);
    constexpr std::array units{"m", "", "1/m"};
    for (int k = 0; k <= out.depth->degree; ++k) {
      const auto i = static_cast<std::size_t>(k);
      rows.add("depth_bias_" + std::to_string(k), out.depth->bias[i], out.depth->sd_bias[i], units[i]);
      bias.push_back(out.depth->bias[i]);
    }
    tell_depth(*out.depth, out.report);
  }
  tell_camera(fit, found.shots, out.report);
  out.parameters = std::move(rows).table();
  out.residuals = residual_table(found.shots, fit, out.depth);
  out.camera_json = camera_json(out.camera, bias);
  out.residual_picture = residual_svg(fit);
  out.report.message = std::to_string(out.report.counts["views_used"]) + " of " + std::to_string(found.shots.size()) +
                       " views, residual " + std::to_string(fit.rms_px).substr(0, 5) + " px";
  return out;
}

}  // namespace bole::rgbd
