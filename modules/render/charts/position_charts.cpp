#include "render/charts/position_charts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

std::vector<Eigen::Vector2d> matched_errors(const Table& matches) {
  std::vector<Eigen::Vector2d> errors;
  const auto kind = texts_or_empty(matches, "kind");
  const auto dx = numbers_or_nan(matches, "dx_m"), dy = numbers_or_nan(matches, "dy_m");
  for (std::size_t i = 0; i < matches.rows(); ++i)
    if ((kind[i] == "matched" || kind[i].empty()) && std::isfinite(dx[i]) && std::isfinite(dy[i]))
      errors.emplace_back(dx[i], dy[i]);
  return errors;
}

struct ErrorSeries {
  std::string name;
  Color color, mean_color;
  std::vector<Eigen::Vector2d> cm;
};

void draw_cloud(Canvas& canvas, const Frame& frame, const ErrorSeries& series, const ErrorSpread& spread) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(spread.covariance);
  const double k = std::sqrt(5.991) * frame.mm_per_unit_x();  // 95 % of a chi-square law with 2 degrees of freedom
  const Eigen::Vector2d axis = eigen.eigenvectors().col(1);
  const Eigen::Vector2d half = eigen.eigenvalues().cwiseMax(0).cwiseSqrt() * k;
  canvas.ellipse(frame.map(spread.mean.x(), spread.mean.y()), half.y(), half.x(), std::atan2(axis.y(), axis.x()),
                 series.mean_color.with_alpha(0.10), Stroke{series.mean_color, 0.3});
  for (const auto& e : series.cm)
    canvas.circle(frame.map(e.x(), e.y()), 0.75, series.color.with_alpha(0.65), Stroke{ink::paper, 0.1});
  canvas.cross(frame.map(spread.mean.x(), spread.mean.y()), 1.2, Stroke{series.mean_color, 0.45});
}

std::vector<std::string> position_statistics(const ErrorSeries& series, const ErrorSpread& spread) {
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (const auto& e : series.cm) squares += e.cwiseAbs2();
  const double n = std::max<double>(1, static_cast<double>(series.cm.size()));
  const Eigen::Vector2d rmse = (squares / n).cwiseSqrt();
  return {"n = " + std::to_string(series.cm.size()),
          "mean = (" + fixed(spread.mean.x(), 1) + ", " + fixed(spread.mean.y(), 1) + ") cm",
          "RMSE = (" + fixed(rmse.x(), 1) + ", " + fixed(rmse.y(), 1) + ") cm",
          "σ max = " + fixed(spread.max_sigma, 1) + " cm"};
}

void draw_position_errors(Canvas& canvas, const std::vector<ErrorSeries>& all) {
  double most = 1;
  for (const auto& series : all)
    for (const auto& e : series.cm) most = std::max(most, e.cwiseAbs().maxCoeff());
  const Interval range = nice_interval({-1.1 * most, 1.1 * most}, 6);
  const double side = canvas.width_mm() - axis_space_left_mm - 3;
  const Frame frame{{axis_space_left_mm, 3, axis_space_left_mm + side, 3 + side}, range, range};
  AxesStyle axes{"Error in x (cm)", "Error in y (cm)"};
  draw_grid(canvas, frame, axes);
  canvas.line(frame.map(range.lo, 0), frame.map(range.hi, 0), Stroke{ink::muted, 0.2});
  canvas.line(frame.map(0, range.lo), frame.map(0, range.hi), Stroke{ink::muted, 0.2});
  {
    const auto clip = canvas.clip(frame.box);
    for (const auto& series : all) draw_cloud(canvas, frame, series, error_spread(series.cm));
  }
  draw_axes(canvas, frame, axes);
  double y = frame.box.y0 + 2.2;
  TextStyle style{7.5};
  style.halo_mm = 0.4;
  const auto write = [&](double x, const std::string& line) {
    canvas.text({x, y}, line, style.aligned(HAlign::left, VAlign::top));
    y += 3.9;
  };
  const double x = frame.box.x0 + 2.5;
  for (const auto& series : all) {
    if (!series.name.empty()) {
      draw_symbol(canvas, Symbol::disc, {x + 1, y + 1.5}, 1.8, series.color);
      style.bold = true;
      write(x + 3, series.name);
      style.bold = false;
    }
    for (const auto& line : position_statistics(series, error_spread(series.cm)))
      write(series.name.empty() ? x : x + 3, line);
    y += 1.2;
  }
}

std::vector<Eigen::Vector2d> in_centimetres(std::vector<Eigen::Vector2d> errors_m) {
  for (auto& e : errors_m) e *= 100;
  return errors_m;
}

struct Walk {
  std::vector<Eigen::Vector2d> at, reference;
  std::vector<double> value;  // seconds, or centimetres of error
  Interval range;
  bool compared = false;
};

void take_errors(const Trajectory& trajectory, const Trajectory& reference, Walk& walk) {
  walk.compared = true;
  for (const auto& pose : reference.poses) walk.reference.emplace_back(pose.T_target_sensor.translation().head<2>());
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const auto& pose = trajectory.poses[i];
    const bool covered = pose.time_s >= reference.poses.front().time_s && pose.time_s <= reference.poses.back().time_s;
    walk.value[i] = covered
                        ? 100 * (pose.T_target_sensor.translation() - reference.at(pose.time_s).translation()).norm()
                        : std::nan("");
  }
}

constexpr double max_segments = 1500;  // each has its own colour, hence its own line in the vector files

// Keeps points at least a step apart, and the last.
void thin(Walk& walk, double step_m) {
  Walk kept;
  for (std::size_t i = 0; i < walk.at.size(); ++i)
    if (kept.at.empty() || i + 1 == walk.at.size() || (walk.at[i] - kept.at.back()).norm() >= step_m) {
      kept.at.push_back(walk.at[i]);
      kept.value.push_back(walk.value[i]);
    }
  walk.at = std::move(kept.at);
  walk.value = std::move(kept.value);
}

Walk walk_of(const Trajectory& trajectory, const Trajectory* reference) {
  Walk walk;
  for (const auto& pose : trajectory.poses) {
    walk.at.emplace_back(pose.T_target_sensor.translation().head<2>());
    walk.value.push_back(pose.time_s - trajectory.poses.front().time_s);
  }
  if (reference != nullptr && reference->poses.size() >= 2) take_errors(trajectory, *reference, walk);
  thin(walk, std::max(0.02, trajectory.length_m() / max_segments));
  double most = 0;
  for (const double v : walk.value)
    if (std::isfinite(v)) most = std::max(most, v);
  walk.range = {0, most > 0 ? most : 1};
  return walk;
}

Frame walk_frame(const Walk& walk, double width_mm) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lo(inf, inf), hi(-inf, -inf);
  for (const auto* points : {&walk.at, &walk.reference})
    for (const auto& p : *points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  if (!(lo.x() <= hi.x())) lo = {-1, -1}, hi = {1, 1};
  const double span = std::max({hi.x() - lo.x(), 0.8 * (hi.y() - lo.y()), 0.5});
  const double pad = 0.05 * span + 0.2, w = width_mm - axis_space_left_mm - 20;
  const double mid_x = (lo.x() + hi.x()) / 2, mid_y = (lo.y() + hi.y()) / 2;
  const double half_x = span / 2 + pad, half_y = std::max((hi.y() - lo.y()) / 2 + pad, 0.35 * half_x);
  return {{axis_space_left_mm, 2, axis_space_left_mm + w, 2 + w * half_y / half_x},
          {mid_x - half_x, mid_x + half_x},
          {mid_y - half_y, mid_y + half_y}};
}

void draw_walk(Canvas& canvas, const Walk& walk, const Frame& frame) {
  AxesStyle axes{"x (m)", "y (m)"};
  axes.frame = true;
  draw_grid(canvas, frame, axes);
  const auto& map = walk.compared ? ColorMap::viridis() : ColorMap::cividis();
  {
    const auto clip = canvas.clip(frame.box);
    std::vector<Eigen::Vector2d> line;
    for (const auto& p : walk.reference) line.push_back(frame.map(p.x(), p.y()));
    canvas.polyline(line, Stroke{ink::muted, 0.9});
    for (std::size_t i = 0; i + 1 < walk.at.size(); ++i)
      canvas.line(frame.map(walk.at[i].x(), walk.at[i].y()), frame.map(walk.at[i + 1].x(), walk.at[i + 1].y()),
                  Stroke{map.at(walk.value[i] / walk.range.hi), 0.5});
    if (!walk.at.empty()) {
      draw_symbol(canvas, Symbol::triangle, frame.map(walk.at.front().x(), walk.at.front().y()), 2.6, ink::good);
      draw_symbol(canvas, Symbol::square, frame.map(walk.at.back().x(), walk.at.back().y()), 2.2, ink::accent);
    }
  }
  draw_axes(canvas, frame, axes);
  draw_color_bar(canvas,
                 {frame.box.x1 + 5, frame.box.y0 + 6, frame.box.x1 + 8, std::min(frame.box.y1, frame.box.y0 + 46)}, map,
                 walk.range, walk.compared ? "Error (cm)" : "Time (s)");
  std::vector<LegendEntry> entries{{Symbol::triangle, ink::good, "start"}, {Symbol::square, ink::accent, "end"}};
  if (walk.compared) entries.push_back({Symbol::line, ink::muted, "reference"});
  const double y = frame.box.y1 + 16.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 30);
  draw_legend_row(canvas, {frame.box.x0 + bar_mm + 14, y - 2.6}, frame.box.width() - bar_mm - 14, entries);
}

}  // namespace

ErrorSpread error_spread(const std::vector<Eigen::Vector2d>& errors) {
  ErrorSpread spread;
  if (errors.empty()) return spread;
  const double n = static_cast<double>(errors.size());
  for (const auto& e : errors) spread.mean += e / n;
  for (const auto& e : errors) spread.covariance += (e - spread.mean) * (e - spread.mean).transpose() / n;
  spread.max_sigma =
      std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread.covariance, Eigen::EigenvaluesOnly)
                                  .eigenvalues()
                                  .maxCoeff()));
  return spread;
}

Figure position_errors(const Table& matches, double width_mm) {
  return position_errors(std::vector<MatchGroup>{{"", ink::primary, &matches}}, width_mm);
}

Figure position_errors(const std::vector<MatchGroup>& groups, double width_mm) {
  Figure figure{"position_errors",
                "Position errors of stems",
                "Estimated minus reference position of every matched stem; cross: mean, ellipse: 95 % of a normal law "
                "of the same covariance.",
                width_mm,
                3 + (width_mm - axis_space_left_mm - 3) + axis_space_below_mm + 1,
                true,
                {}};
  std::vector<ErrorSeries> all;
  for (const auto& g : groups)  // a series alone has its mean in another ink
    all.push_back(
        {g.name, g.color, groups.size() > 1 ? g.color : ink::accent, in_centimetres(matched_errors(*g.matches))});
  figure.draw = [all = std::move(all)](Canvas& canvas) { draw_position_errors(canvas, all); };
  return figure;
}

Figure trajectory_plan(const Trajectory& trajectory, const Trajectory* reference, double width_mm) {
  auto walk = walk_of(trajectory, reference);
  const auto frame = walk_frame(walk, width_mm);
  Figure figure{"trajectory",
                "Walk of the scanner",
                walk.compared
                    ? "Path of the scanner from above, coloured by its distance from the reference at equal times."
                    : "Path of the scanner from above, coloured by time.",
                width_mm,
                frame.box.y1 + 20,
                true,
                {}};
  figure.draw = [walk = std::move(walk), frame](Canvas& canvas) { draw_walk(canvas, walk, frame); };
  return figure;
}

}  // namespace bole::render
