#include "render/maps/comparison_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double comparison_furniture_mm = 23;  // labels below a map, scale bar and legend

struct Extent {
  Eigen::Vector2d lo{inf, inf}, hi{-inf, -inf};
  void include(const Eigen::Vector2d& p) {
    if (!p.allFinite()) return;
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  bool empty() const { return !(lo.x() <= hi.x()); }
};

// A map of `extent` with a margin, `width_mm` wide, its left upper corner at `corner`.
Frame map_frame(Extent extent, const Eigen::Vector2d& corner, double width_mm) {
  if (extent.empty()) {
    extent.include({-1, -1});
    extent.include({1, 1});
  }
  const double margin = 0.03 * std::max((extent.hi - extent.lo).maxCoeff(), 1.0) + 0.3;
  const Eigen::Vector2d lo = extent.lo.array() - margin, size = (extent.hi - extent.lo).array() + 2 * margin;
  const double height_mm = width_mm * std::clamp(size.y() / size.x(), 0.4, 1.4);
  const double mm_per_m = std::min(width_mm / size.x(), height_mm / size.y());
  const Eigen::Vector2d middle = lo + size / 2, half(width_mm / mm_per_m / 2, height_mm / mm_per_m / 2);
  return {{corner.x(), corner.y(), corner.x() + width_mm, corner.y() + height_mm},
          {middle.x() - half.x(), middle.x() + half.x()},
          {middle.y() - half.y(), middle.y() + half.y()}};
}

AxesStyle map_axes() {
  AxesStyle axes{"x (m)", "y (m)"};
  axes.frame = true;
  axes.x_ticks = axes.y_ticks = 8;
  return axes;
}

void draw_below(Canvas& canvas, const Frame& frame, const std::vector<LegendEntry>& entries) {
  const double y = frame.box.y1 + 16.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 30);
  draw_legend_row(canvas, {frame.box.x0 + bar_mm + 14, y - 2.6}, frame.box.width() - bar_mm - 14, entries);
}

struct TreeMark {
  Eigen::Vector2d at, reference;  // of an extra tree: twice its place
  bool extra = false;
};

struct MarkSeries {
  std::string name;
  Color color;
  std::vector<TreeMark> marks;
};

struct PositionMap {
  std::vector<Eigen::Vector2d> reference, outline;
  std::vector<MarkSeries> runs;
  double enlarge = 1;
};

MarkSeries marks_of(const MatchGroup& group, std::map<std::pair<double, double>, int>& reference) {
  MarkSeries series{group.name, group.color, {}};
  const auto& m = *group.matches;
  const auto kind = texts_or_empty(m, "kind");
  const auto x = numbers_or_nan(m, "x_m"), y = numbers_or_nan(m, "y_m"), rx = numbers_or_nan(m, "ref_x_m"),
             ry = numbers_or_nan(m, "ref_y_m");
  for (std::size_t i = 0; i < m.rows(); ++i) {
    if (kind[i] != "false" && std::isfinite(rx[i] + ry[i])) reference[{rx[i], ry[i]}] = 1;
    if (kind[i] == "matched") series.marks.push_back({{x[i], y[i]}, {rx[i], ry[i]}, false});
    if (kind[i] == "false") series.marks.push_back({{x[i], y[i]}, {x[i], y[i]}, true});
  }
  return series;
}

// A nice factor that draws the usual error a millimetre and a half long; 1 where it is that long already.
double visible_factor(const PositionMap& map, double mm_per_m) {
  double squares = 0;
  std::size_t n = 0;
  for (const auto& run : map.runs)
    for (const auto& mark : run.marks)
      if (!mark.extra) {
        squares += (mark.at - mark.reference).squaredNorm();
        ++n;
      }
  const double rms_m = n > 0 ? std::sqrt(squares / static_cast<double>(n)) : 0;
  if (!(rms_m > 0)) return 1;
  const double wanted = 1.5 / (rms_m * mm_per_m);
  double best = 1;
  for (const double factor : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (factor <= wanted) best = factor;
  return best;
}

void draw_mark(Canvas& canvas, const Eigen::Vector2d& p, std::size_t series, const Color& color) {
  const Stroke stroke{color, 0.3};
  const double r = 1.1;
  if (series % 2 == 1) return canvas.cross(p, r * 0.75, stroke);
  canvas.line({p.x() - r, p.y()}, {p.x() + r, p.y()}, stroke);
  canvas.line({p.x(), p.y() - r}, {p.x(), p.y() + r}, stroke);
}

void draw_positions(Canvas& canvas, const PositionMap& map, const Frame& frame) {
  draw_grid(canvas, frame, map_axes());
  {
    const auto clip = canvas.clip(frame.box);
    std::vector<Eigen::Vector2d> outline;
    for (const auto& p : map.outline) outline.push_back(frame.map(p.x(), p.y()));
    if (!outline.empty()) canvas.polygon(outline, {}, Stroke{ink::axis, 0.35, {1.6, 1.0}});
    for (const auto& p : map.reference) canvas.circle(frame.map(p.x(), p.y()), 1.2, {}, Stroke{ink::axis, 0.25});
    for (std::size_t k = 0; k < map.runs.size(); ++k)
      for (const auto& mark : map.runs[k].marks) {
        const Eigen::Vector2d drawn = mark.reference + map.enlarge * (mark.at - mark.reference);
        const auto from = frame.map(mark.reference.x(), mark.reference.y()), to = frame.map(drawn.x(), drawn.y());
        if (map.enlarge > 1 && !mark.extra) canvas.line(from, to, Stroke{map.runs[k].color.with_alpha(0.7), 0.2});
        draw_mark(canvas, to, k, map.runs[k].color);
      }
  }
  draw_axes(canvas, frame, map_axes());
  const double y = frame.box.y1 + 16.5;
  double x = frame.box.x0 + draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 30) + 14;
  // The marks themselves stand in the legend: upright and diagonal crosses.
  const auto entry = [&](const std::string& name, const auto& draw_at) {
    const TextStyle style{7};
    draw_at(Eigen::Vector2d(x + 1.5, y - 0.6));
    canvas.text({x + 4, y - 0.6}, name, style.aligned(HAlign::left, VAlign::middle));
    x += 9 + canvas.text_size(name, style).x();
  };
  entry("reference", [&](const Eigen::Vector2d& p) { canvas.circle(p, 1.2, {}, Stroke{ink::axis, 0.25}); });
  for (std::size_t k = 0; k < map.runs.size(); ++k)
    entry(map.runs[k].name, [&](const Eigen::Vector2d& p) { draw_mark(canvas, p, k, map.runs[k].color); });
}

Image grey_image(const PlanDensity& cloud) {
  std::vector<float> counts;
  for (const float n : cloud.points)
    if (n > 0) counts.push_back(n);
  std::ranges::sort(counts);
  const double dense = counts.empty() ? 1 : counts[counts.size() * 99 / 100];
  Image image{cloud.width, cloud.height, {}};
  for (int y = cloud.height - 1; y >= 0; --y)
    for (int x = 0; x < cloud.width; ++x) {
      const double n = cloud.points[static_cast<std::size_t>(y) * static_cast<std::size_t>(cloud.width) +
                                    static_cast<std::size_t>(x)];
      const double t = std::min(1.0, std::log1p(n) / std::log1p(std::max(1.0, dense)));
      const auto grey = static_cast<std::uint8_t>(std::lround(255 - 130 * t));
      image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
    }
  return image;
}

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

Figure position_map(const std::vector<MatchGroup>& runs, const PlotArea& area, double width_mm, double enlarge) {
  PositionMap map;
  std::map<std::pair<double, double>, int> reference;
  Extent extent;
  for (const auto& group : runs) map.runs.push_back(marks_of(group, reference));
  for (const auto& [at, one] : reference) map.reference.emplace_back(at.first, at.second);
  map.outline = area.outline();
  for (const auto* points : {&map.reference, &map.outline})
    for (const auto& p : *points) extent.include(p);
  const auto frame = map_frame(extent, {axis_space_left_mm, 2}, width_mm - axis_space_left_mm - 2);
  map.enlarge = enlarge > 0 ? enlarge : visible_factor(map, frame.mm_per_unit_x());
  Figure figure;
  figure.name = "position_map";
  figure.title = "Stem positions";
  figure.caption = "Reference positions (rings) and those of each run (crosses)." +
                   (map.enlarge > 1 ? fmt::format(" The errors are drawn {:g} times as long as they are.", map.enlarge)
                                    : std::string());
  figure.width_mm = width_mm;
  figure.height_mm = frame.box.y1 + comparison_furniture_mm;
  figure.draw = [map = std::move(map), frame](Canvas& canvas) { draw_positions(canvas, map, frame); };
  return figure;
}

void PlanDensity::add(const Eigen::Vector2d& at) {
  const Eigen::Vector2d cell = (at - corner) / cell_m;
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < width && cell.y() < height)) return;
  points[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell.x())] +=
      1;
}

PlanDensity plan_density(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell_m) {
  constexpr double max_cells = 2000;  // a side
  const double longest = std::max((max - min).maxCoeff(), 0.1);
  PlanDensity plan;
  plan.cell_m = std::max(cell_m, longest / max_cells);
  plan.corner = min;
  plan.width = std::max(1, static_cast<int>(std::ceil((max.x() - min.x()) / plan.cell_m)));
  plan.height = std::max(1, static_cast<int>(std::ceil((max.y() - min.y()) / plan.cell_m)));
  plan.points.assign(static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height), 0);
  return plan;
}

Figure paths_on_cloud(const std::vector<ComparedPath>& paths, const PlanDensity& cloud, double width_mm) {
  if (paths.empty()) throw bad_input("there is no path to draw", "the trajectory of a run");
  PathsOnCloud p;
  p.picture = grey_image(cloud);
  p.lo = cloud.corner;
  p.hi = cloud.corner + cloud.cell_m * Eigen::Vector2d(cloud.width, cloud.height);
  Extent extent;
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
    const auto& other = paths[1].path;
    for (const auto& pose : paths[0].path.poses) {
      if (pose.time_s < other.poses.front().time_s || pose.time_s > other.poses.back().time_s) continue;
      const Eigen::Vector2d at = pose.T_target_sensor.translation().head<2>(),
                            there = other.at(pose.time_s).translation().head<2>();
      if ((at - there).norm() <= p.apart_m) continue;
      p.apart_m = (at - there).norm();
      p.place = (at + there) / 2;
      p.zooms = true;
    }
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
  figure.height_mm = frame.box.y1 + comparison_furniture_mm;
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
