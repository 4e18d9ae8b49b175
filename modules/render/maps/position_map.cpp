#include "render/maps/position_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/charts/columns.h"
#include "render/maps/map_frame.h"

namespace bole::render {
namespace {

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

MarkSeries match_marks(const MatchGroup& group, std::map<std::pair<double, double>, int>& reference) {
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

}  // namespace

Figure position_map(const std::vector<MatchGroup>& runs, const PlotArea& area, double width_mm, double enlarge) {
  PositionMap map;
  std::map<std::pair<double, double>, int> reference;
  MapExtent extent;
  for (const auto& group : runs) map.runs.push_back(match_marks(group, reference));
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
  figure.height_mm = frame.box.y1 + map_furniture_mm;
  figure.draw = [map = std::move(map), frame](Canvas& canvas) { draw_positions(canvas, map, frame); };
  return figure;
}

}  // namespace bole::render
