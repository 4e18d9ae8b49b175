#include "render/maps/stem_map.h"

#include <algorithm>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"
#include "render/draw/labels.h"
#include "render/maps/stem_map_content.h"

namespace bole::render {
namespace {

constexpr double margin_left = axis_space_left_mm, margin_right = 2, margin_top = 2, margin_below = 11,
                 furniture_mm = 12;
constexpr double min_radius_mm = 0.45;  // a stem stays visible on a small map

void draw_stem(Canvas& canvas, const Frame& frame, const MapStem& stem) {
  const auto p = frame.map(stem.at.x(), stem.at.y());
  const double r = std::max(min_radius_mm, stem.dbh_m / 2 * frame.mm_per_unit_x());
  canvas.circle(p, r, stem.color.with_alpha(0.85), Stroke{mix(stem.color, ink::text, 0.5), 0.15});
  if (stem.is_false) canvas.cross(p, r + 0.9, Stroke{ink::accent, 0.35});
}

void draw_labels(Canvas& canvas, const Frame& frame, const StemMapContent& content) {
  const double size_pt = content.stems.size() > 250 ? 4.5 : content.stems.size() > 120 ? 5.2 : 6;
  TextStyle style{size_pt, ink::text};
  style.halo_mm = 0.3;
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  std::vector<Color> colors;
  const auto request = [&](const Eigen::Vector2d& at, double radius, const std::string& text, const Color& color) {
    const auto size = canvas.text_size(text, style);
    requests.push_back({at, radius, {size.x(), 0.75 * size.y()}});
    texts.push_back(text);
    colors.push_back(color);
  };
  for (const auto& t : content.targets) request(frame.map(t.at.x(), t.at.y()), 1.4, t.name, ink::primary);
  for (const auto& m : content.missed) request(frame.map(m.at.x(), m.at.y()), 1.1, m.name, ink::accent);
  for (const auto& s : content.stems)
    request(frame.map(s.at.x(), s.at.y()), std::max(min_radius_mm, s.dbh_m / 2 * frame.mm_per_unit_x()), s.id,
            ink::text);
  const auto places = place_labels(requests, {}, frame.box.grown(-0.4));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto c = places[i].box.centre();
    if (places[i].leader) canvas.line(requests[i].anchor, c, Stroke{ink::muted, 0.12});
    TextStyle own = style.aligned(HAlign::centre, VAlign::middle);
    own.color = colors[i];
    own.bold = i < content.targets.size();
    canvas.text(c, texts[i], own);
  }
}

std::vector<LegendEntry> legend_of(const StemMapContent& content) {
  std::vector<LegendEntry> entries{{Symbol::disc, ink::good, "stem, good fit"},
                                   {Symbol::disc, ink::fair, "fair"},
                                   {Symbol::disc, ink::poor, "poor"}};
  if (std::none_of(content.stems.begin(), content.stems.end(),
                   [](const MapStem& s) { return s.color.r != ink::muted.r; }))
    entries = {{Symbol::disc, ink::muted, "stem"}};
  if (content.compared) {
    entries.push_back({Symbol::ring, ink::accent, "missed"});
    entries.push_back({Symbol::cross, ink::accent, "false"});
  }
  if (!content.targets.empty()) entries.push_back({Symbol::star, ink::primary, "target"});
  if (!content.path.empty()) entries.push_back({Symbol::line, ink::path, "walk"});
  if (!content.outline.empty()) entries.push_back({Symbol::dashed_line, ink::axis, "plot boundary"});
  return entries;
}

void draw_stem_map(Canvas& canvas, const StemMapContent& content, const Frame& frame) {
  AxesStyle axes;
  axes.x_label = content.north_known ? "East (m)" : "x (m)";
  axes.y_label = content.north_known ? "North (m)" : "y (m)";
  axes.frame = true;
  axes.x_ticks = axes.y_ticks = 8;
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    std::vector<Eigen::Vector2d> line;
    for (const auto& p : content.path) line.push_back(frame.map(p.x(), p.y()));
    canvas.polyline(line, Stroke{ink::path.with_alpha(0.8), 0.22});
    line.clear();
    for (const auto& p : content.outline) line.push_back(frame.map(p.x(), p.y()));
    if (!line.empty()) canvas.polygon(line, {}, Stroke{ink::axis, 0.35, {1.6, 1.0}});
    for (const auto& s : content.stems) draw_stem(canvas, frame, s);
    for (const auto& m : content.missed)
      canvas.circle(frame.map(m.at.x(), m.at.y()), 1.0, {}, Stroke{ink::accent, 0.35});
    for (const auto& t : content.targets)
      draw_symbol(canvas, Symbol::star, frame.map(t.at.x(), t.at.y()), 2.8, ink::primary);
  }
  draw_labels(canvas, frame, content);
  draw_axes(canvas, frame, axes);
  const double y = frame.box.y1 + margin_below + 5.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 40);
  if (content.north_known) draw_north_arrow(canvas, {frame.box.x0 + 1 + bar_mm + 12, y + 0.6}, 8);
  draw_legend_row(canvas, {frame.box.x0 + 1 + bar_mm + 20, y - 5.2}, frame.box.x1 - frame.box.x0 - bar_mm - 20,
                  legend_of(content), 7);
}

}  // namespace

Figure stem_map(const StemMapData& data, double width_mm) {
  auto content = stem_map_content(data);
  const auto frame = stem_map_frame(content, {margin_left, margin_top}, width_mm - margin_left - margin_right);
  const auto all = content.stems.size();
  std::erase_if(content.stems, [&](const MapStem& s) {
    return s.at.x() < frame.x.lo || s.at.x() > frame.x.hi || s.at.y() < frame.y.lo || s.at.y() > frame.y.hi;
  });
  Figure figure;
  figure.name = "stem_map";
  figure.title = "Stem map";
  figure.caption =
      "Stems at breast height, drawn to scale and coloured by the quality of their fit; the numbers are the tree ids.";
  if (content.stems.size() < all)
    figure.caption +=
        " " + std::to_string(all - content.stems.size()) + " stems further outside the plot are not shown.";
  figure.width_mm = width_mm;
  figure.height_mm = frame.box.y1 + margin_below + furniture_mm;
  figure.draw = [content = std::move(content), frame](Canvas& canvas) { draw_stem_map(canvas, content, frame); };
  return figure;
}

}  // namespace bole::render
