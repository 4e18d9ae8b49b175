#include "render/maps/paths_on_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "render/maps/map_frame.h"

namespace bole::render {
namespace {

struct PathLines {
  std::string name;
  Color color;
  std::vector<Eigen::Vector2d> points;
};

struct PathsOnCloud {
  Image picture;
  Eigen::Vector2d lo, hi;  // of the picture
  std::vector<PathLines> lines;
  Eigen::Vector2d place;  // of the zoom
  double reach_m = 1.5, apart_m = 0;
  bool zooms = false;
};

void draw_paths(Canvas& canvas, const PathsOnCloud& p, const Frame& frame, double width_mm) {
  draw_grid(canvas, frame, map_axes());
  const auto clip = canvas.clip(frame.box);
  const auto a = frame.map(p.lo.x(), p.hi.y()), b = frame.map(p.hi.x(), p.lo.y());
  if (p.picture.width > 0) canvas.image(p.picture, {a.x(), a.y(), b.x(), b.y()});
  for (std::size_t k = 0; k < p.lines.size(); ++k) {
    std::vector<Eigen::Vector2d> drawn;
    for (const auto& at : p.lines[k].points) drawn.push_back(frame.map(at.x(), at.y()));
    // Later ones are thinner, so that a path below another one is seen.
    canvas.polyline(drawn, Stroke{p.lines[k].color, width_mm / (1 + 0.8 * static_cast<double>(k))});
  }
}

}  // namespace

FurthestApart furthest_apart(const Trajectory& a, const Trajectory& b) {
  FurthestApart found;
  if (a.poses.empty() || b.poses.empty()) return found;
  for (const auto& pose : a.poses) {
    if (pose.time_s < b.poses.front().time_s || pose.time_s > b.poses.back().time_s) continue;
    const Eigen::Vector2d at = pose.T_target_sensor.translation().head<2>(),
                          there = b.at(pose.time_s).translation().head<2>();
    if ((at - there).norm() > found.distance_m) found = {(at + there) / 2, (at - there).norm()};
  }
  return found;
}

Figure paths_on_cloud(const std::vector<ComparedPath>& paths, const PlanDensity& cloud, double width_mm) {
  if (paths.empty()) throw bad_input("there is no path to draw", "the trajectory of a run");
  PathsOnCloud p;
  p.picture = density_image(cloud);
  p.lo = cloud.corner;
  p.hi = cloud.opposite();
  MapExtent extent;
  for (const auto& path : paths) {
    PathLines line{path.name, path.color, {}};
    for (const auto& pose : path.path.poses) {
      line.points.emplace_back(pose.T_target_sensor.translation().head<2>());
      extent.include(line.points.back());
    }
    p.lines.push_back(std::move(line));
  }
  // The cloud about the paths; what was scanned from afar would make them small.
  constexpr double around_m = 6;
  if (cloud.width > 1 && !extent.empty()) {
    const Eigen::Vector2d lo = extent.lo.array() - around_m, hi = extent.hi.array() + around_m;
    extent.include(lo.cwiseMax(p.lo));
    extent.include(hi.cwiseMin(p.hi));
  }
  if (paths.size() > 1 && paths[0].path.poses.size() > 1 && paths[1].path.poses.size() > 1) {
    const auto apart = furthest_apart(paths[0].path, paths[1].path);
    p.apart_m = apart.distance_m;
    p.place = apart.place;
    p.zooms = apart.distance_m > 0;
  }
  p.reach_m = std::clamp(6 * p.apart_m, 0.06, 5.0);
  const double gap_mm = 6, side_mm = p.zooms ? 0.3 * width_mm : 0;
  const auto frame =
      map_frame(extent, {axis_space_left_mm, 2},
                width_mm - axis_space_left_mm - 2 - (p.zooms ? side_mm + gap_mm + axis_space_left_mm : 0));
  Figure figure;
  figure.name = "paths";
  figure.title = "Paths of the scanner on the cloud";
  figure.caption = "The path of each run from above over the points of the first (grey)." +
                   (p.zooms ? fmt::format(" Right: the place where the first two paths are furthest apart ({:.1f} cm).",
                                          100 * p.apart_m)
                            : std::string());
  figure.width_mm = width_mm;
  figure.height_mm = frame.box.y1 + map_furniture_mm;
  figure.draw = [p = std::move(p), frame, side_mm](Canvas& canvas) {
    draw_paths(canvas, p, frame, 0.5);
    draw_axes(canvas, frame, map_axes());
    if (p.zooms) {
      const Box box{canvas.width_mm() - side_mm - 2, 2, canvas.width_mm() - 2, 2 + side_mm};
      const Frame zoom{
          box, {p.place.x() - p.reach_m, p.place.x() + p.reach_m}, {p.place.y() - p.reach_m, p.place.y() + p.reach_m}};
      const auto a = frame.map(zoom.x.lo, zoom.y.hi), b = frame.map(zoom.x.hi, zoom.y.lo);
      canvas.rectangle({a.x(), a.y(), b.x(), b.y()}, {}, Stroke{ink::text, 0.35});
      draw_paths(canvas, p, zoom, 0.6);
      AxesStyle axes = map_axes();
      axes.x_ticks = axes.y_ticks = 4;
      draw_axes(canvas, zoom, axes);
    }
    std::vector<LegendEntry> entries;
    for (const auto& line : p.lines) entries.push_back({Symbol::line, line.color, line.name});
    draw_below(canvas, frame, entries);
  };
  return figure;
}

}  // namespace bole::render
