#include "render/charts/trajectory_charts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double max_points = 3000;  // of a line: more than a printer shows
constexpr Color reference_color = ink::muted, estimate_color = ink::primary;

struct Revisit {
  Eigen::Vector2d from, to;
  Color color;
};

struct Overlay {
  std::vector<Eigen::Vector2d> estimate, reference;
  std::vector<Revisit> revisits;
  bool judged = false;  // revisits are coloured by whether they are right
  double length_m = 0;
};

struct ErrorCurve {
  std::vector<double> way_m, all_cm, flat_cm, up_cm;
  double rmse_cm = 0, max_cm = 0;
};

std::vector<Eigen::Vector2d> plan_of(const Trajectory& trajectory) {
  const double step_m = std::max(0.01, trajectory.length_m() / max_points);
  std::vector<Eigen::Vector2d> points;
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector2d p = pose.T_target_sensor.translation().head<2>();
    if (points.empty() || (p - points.back()).norm() >= step_m) points.push_back(p);
  }
  points.emplace_back(trajectory.poses.back().T_target_sensor.translation().head<2>());
  return points;
}

bool covers(const Trajectory& t, double time_s) {
  return time_s >= t.poses.front().time_s && time_s <= t.poses.back().time_s;
}

std::vector<Revisit> revisits_of(const Table& loops, const Trajectory& estimate, bool& judged) {
  const auto from_s = loops.numbers("from_time_s"), to_s = loops.numbers("to_time_s");
  const std::string judge = loops.has("true_pose") ? "true_pose" : "right";
  judged = loops.has(judge);
  const auto right = numbers_or_nan(loops, judge);
  std::vector<Revisit> out;
  for (std::size_t i = 0; i < from_s.size(); ++i)
    if (covers(estimate, from_s[i]) && covers(estimate, to_s[i]))
      out.push_back({estimate.at(from_s[i]).translation().head<2>(), estimate.at(to_s[i]).translation().head<2>(),
                     judged && right[i] == 0 ? ink::poor : ink::good});
  return out;
}

void check(const TrajectoryComparison& c) {
  for (const auto* t : {c.estimate, c.reference})
    if (t == nullptr || t->poses.size() < 2)
      throw bad_input("a trajectory of " + std::to_string(t == nullptr ? 0 : t->poses.size()) + " poses", "at least 2");
}

Overlay overlay_of(const TrajectoryComparison& c) {
  Overlay o;
  o.estimate = plan_of(*c.estimate);
  o.reference = plan_of(*c.reference);
  o.length_m = c.estimate->length_m();
  if (c.loops != nullptr) o.revisits = revisits_of(*c.loops, *c.estimate, o.judged);
  return o;
}

ErrorCurve errors_of(const TrajectoryComparison& c) {
  ErrorCurve e;
  const double step_m = c.estimate->length_m() / max_points;
  double way_m = 0, squares = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < c.estimate->poses.size(); ++i) {
    const auto& pose = c.estimate->poses[i];
    const Eigen::Vector3d p = pose.T_target_sensor.translation();
    if (i > 0) way_m += (p - c.estimate->poses[i - 1].T_target_sensor.translation()).norm();
    if (!covers(*c.reference, pose.time_s)) continue;
    const Eigen::Vector3d d = 100 * (p - c.reference->at(pose.time_s).translation());
    squares += d.squaredNorm();
    ++n;
    e.max_cm = std::max(e.max_cm, d.norm());
    if (!e.way_m.empty() && way_m - e.way_m.back() < step_m && i + 1 < c.estimate->poses.size()) continue;
    e.way_m.push_back(way_m);
    e.all_cm.push_back(d.norm());
    e.flat_cm.push_back(d.head<2>().norm());
    e.up_cm.push_back(std::abs(d.z()));
  }
  if (n > 0) e.rmse_cm = std::sqrt(squares / static_cast<double>(n));
  return e;
}

// The plan in a box whose left upper corner is at (axis_space_left_mm, top_mm).
Frame overlay_frame(const Overlay& o, double width_mm, double top_mm) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lo(inf, inf), hi(-inf, -inf);
  for (const auto* points : {&o.estimate, &o.reference})
    for (const auto& p : *points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const double span = std::max({hi.x() - lo.x(), 1.2 * (hi.y() - lo.y()), 0.5}), half_x = 0.53 * span + 0.2,
               half_y = std::max(0.53 * (hi.y() - lo.y()) + 0.2, 0.25 * half_x), w = width_mm - axis_space_left_mm - 3;
  const Eigen::Vector2d mid = (lo + hi) / 2;
  return {{axis_space_left_mm, top_mm, axis_space_left_mm + w, top_mm + w * half_y / half_x},
          {mid.x() - half_x, mid.x() + half_x},
          {mid.y() - half_y, mid.y() + half_y}};
}

double overlay_height(const Frame& frame) { return frame.box.height() + 20; }

void draw_overlay(Canvas& canvas, const Overlay& o, const Frame& frame) {
  AxesStyle axes{"x (m)", "y (m)"};
  axes.frame = true;
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    const auto draw = [&](const std::vector<Eigen::Vector2d>& points, const Stroke& stroke) {
      std::vector<Eigen::Vector2d> line;
      for (const auto& p : points) line.push_back(frame.map(p.x(), p.y()));
      canvas.polyline(line, stroke);
    };
    draw(o.reference, Stroke{reference_color.with_alpha(0.55), 1.0});
    draw(o.estimate, Stroke{estimate_color, 0.3});
    for (const auto& r : o.revisits) {
      const Eigen::Vector2d a = frame.map(r.from.x(), r.from.y()), b = frame.map(r.to.x(), r.to.y());
      canvas.line(a, b, Stroke{r.color.with_alpha(0.8), 0.35});
      canvas.circle(b, 0.5, r.color, Stroke{ink::paper, 0.1});
    }
    draw_symbol(canvas, Symbol::triangle, frame.map(o.estimate.front().x(), o.estimate.front().y()), 2.6, ink::fair);
    draw_symbol(canvas, Symbol::square, frame.map(o.estimate.back().x(), o.estimate.back().y()), 2.2, ink::accent);
  }
  draw_axes(canvas, frame, axes);
  std::vector<LegendEntry> entries{{Symbol::triangle, ink::fair, "start"},
                                   {Symbol::square, ink::accent, "end"},
                                   {Symbol::line, reference_color, "reference"},
                                   {Symbol::line, estimate_color, "estimate"}};
  const auto wrong = std::ranges::count_if(o.revisits, [](const Revisit& r) { return r.color.r == ink::poor.r; });
  const auto right = static_cast<std::ptrdiff_t>(o.revisits.size()) - wrong;
  if (!o.revisits.empty())
    entries.push_back({Symbol::line, ink::good, std::to_string(right) + (o.judged ? " loops right" : " loops")});
  if (o.judged && wrong > 0) entries.push_back({Symbol::line, ink::poor, std::to_string(wrong) + " loops wrong"});
  const double y = frame.box.y1 + 16.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 30);
  draw_legend_row(canvas, {frame.box.x0 + bar_mm + 14, y - 2.6}, frame.box.width() - bar_mm - 14, entries);
}

constexpr double error_height_mm = 62;

void draw_error_curve(Canvas& canvas, const ErrorCurve& e, double top_mm) {
  const Interval x = {0, e.way_m.empty() ? 1 : std::max(e.way_m.back(), 0.1)},
                 y = nice_interval({0, std::max(0.1, 1.05 * e.max_cm)}, 5);
  const Frame frame{
      {axis_space_left_mm, top_mm + 2, canvas.width_mm() - 3, top_mm + error_height_mm - axis_space_below_mm - 6},
      x,
      y};
  AxesStyle axes{"Distance walked (m)", "Error (cm)"};
  axes.x_ticks = 8;
  axes.y_ticks = 5;
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    const auto draw = [&](const std::vector<double>& values, const Stroke& stroke) {
      std::vector<Eigen::Vector2d> line;
      for (std::size_t i = 0; i < values.size(); ++i) line.push_back(frame.map(e.way_m[i], values[i]));
      canvas.polyline(line, stroke);
    };
    draw(e.up_cm, Stroke{ink::fair, 0.25});
    draw(e.flat_cm, Stroke{ink::good, 0.25});
    draw(e.all_cm, Stroke{estimate_color, 0.4});
    canvas.line(frame.map(x.lo, e.rmse_cm), frame.map(x.hi, e.rmse_cm), Stroke{ink::accent, 0.3, {1.5, 1}});
  }
  draw_axes(canvas, frame, axes);
  draw_legend_row(canvas, {frame.box.x0, top_mm + error_height_mm - 5}, frame.box.width(),
                  {{Symbol::line, estimate_color, "error"},
                   {Symbol::line, ink::good, "horizontal"},
                   {Symbol::line, ink::fair, "vertical"},
                   {Symbol::dashed_line, ink::accent, "RMSE " + fixed(e.rmse_cm, 1) + " cm"}});
}

constexpr const char* overlay_caption =
    "The estimated path over the reference, from above; lines join the two places of each revisit that closed a loop.";
constexpr const char* error_caption =
    "Distance between estimate and reference at equal times along the walk, its horizontal and its vertical part.";

}  // namespace

std::optional<Pose> alignment_to(const Trajectory& estimate, const Trajectory& reference) {
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(estimate.poses.size())), to = from;
  Eigen::Index n = 0;
  if (reference.poses.size() > 1)
    for (const auto& pose : estimate.poses)
      if (covers(reference, pose.time_s)) {
        from.col(n) = pose.T_target_sensor.translation();
        to.col(n++) = reference.at(pose.time_s).translation();
      }
  if (n < 3) return std::nullopt;
  Pose motion = Pose::Identity();
  motion.matrix() = Eigen::umeyama(from.leftCols(n), to.leftCols(n), false);
  return motion;
}

Trajectory aligned_to(const Trajectory& estimate, const Trajectory& reference) {
  const auto motion = alignment_to(estimate, reference);
  Trajectory aligned = estimate;
  if (!motion) return aligned;
  for (auto& pose : aligned.poses) pose.T_target_sensor = *motion * pose.T_target_sensor;
  aligned.axes = reference.axes;
  return aligned;
}

Figure trajectory_overlay(const TrajectoryComparison& comparison, double width_mm) {
  check(comparison);
  auto overlay = overlay_of(comparison);
  const auto frame = overlay_frame(overlay, width_mm, 2);
  Figure figure{"trajectory_overlay",
                "Estimated path and reference",
                overlay_caption,
                width_mm,
                overlay_height(frame) + 2,
                true,
                {}};
  figure.draw = [overlay = std::move(overlay), frame](Canvas& canvas) { draw_overlay(canvas, overlay, frame); };
  return figure;
}

double greatest_error_cm(const TrajectoryComparison& comparison) {
  check(comparison);
  return errors_of(comparison).max_cm;
}

Figure trajectory_error_chart(const TrajectoryComparison& comparison, double width_mm, double min_top_cm) {
  check(comparison);
  Figure figure{"trajectory_error", "Error along the way", error_caption, width_mm, error_height_mm, true, {}};
  auto errors = errors_of(comparison);
  errors.max_cm = std::max(errors.max_cm, min_top_cm);
  figure.draw = [errors = std::move(errors)](Canvas& canvas) { draw_error_curve(canvas, errors, 0); };
  return figure;
}

Figure trajectory_sheet(const TrajectoryComparison& comparison, double width_mm) {
  check(comparison);
  auto overlay = overlay_of(comparison);
  const auto frame = overlay_frame(overlay, width_mm, 2);
  const double top_mm = overlay_height(frame) + 2;
  Figure figure{"trajectory",
                "Estimated path and reference",
                std::string(overlay_caption) + " " + error_caption,
                width_mm,
                top_mm + error_height_mm,
                true,
                {}};
  figure.draw = [overlay = std::move(overlay), frame, errors = errors_of(comparison), top_mm](Canvas& canvas) {
    draw_overlay(canvas, overlay, frame);
    draw_error_curve(canvas, errors, top_mm);
  };
  return figure;
}

}  // namespace bole::render
