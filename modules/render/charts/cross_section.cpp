#include "render/charts/cross_section.h"

#include <algorithm>
#include <cmath>

#include "render/draw/color.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double filled = 0.88, min_span_m = 0.5;
const Color terrain_ink = hex(0x9a6b3f), section_hand = hex(0x0073e6);

Interval middle_of(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const std::size_t strays = values.size() / 2000;
  return {values[strays], values[values.size() - 1 - strays]};
}

// The points as a picture of the box: many would be slow as dots, and large as vectors.
Image picture_of_points(const CrossSectionData& data, const Frame& frame, double dpi, int dot_px) {
  const double px_per_mm = dpi / mm_per_inch;
  Image image;
  image.width = std::max(1, static_cast<int>(std::lround(frame.box.width() * px_per_mm)));
  image.height = std::max(1, static_cast<int>(std::lround(frame.box.height() * px_per_mm)));
  image.rgba.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Eigen::Vector2d mm = frame.map(data.points[i].x(), data.points[i].y());
    const int left = static_cast<int>(std::floor((mm.x() - frame.box.x0) * px_per_mm - (dot_px - 1) / 2.0)),
              top = static_cast<int>(std::floor((mm.y() - frame.box.y0) * px_per_mm - (dot_px - 1) / 2.0));
    for (int y = std::max(0, top); y < std::min(image.height, top + dot_px); ++y)
      for (int x = std::max(0, left); x < std::min(image.width, left + dot_px); ++x) {
        auto* pixel = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                               static_cast<std::size_t>(x));
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = data.rgb.empty() ? 0x6f : data.rgb[3 * i + c];
        pixel[3] = 255;
      }
  }
  return image;
}

void draw_terrain(Canvas& canvas, const CrossSectionData& data, const Frame& frame) {
  for (const auto& piece : data.terrain) {
    std::vector<Eigen::Vector2d> line;
    for (const auto& p : piece) line.push_back(frame.map(p.x(), p.y()));
    canvas.polyline(line, Stroke{terrain_ink, 0.5});
  }
}

void draw_section_stems(Canvas& canvas, const CrossSectionData& data, const Frame& frame) {
  for (const auto& stem : data.stems) {
    std::vector<Eigen::Vector2d> outline;
    Eigen::Vector2d top(0, 1e9);
    for (const auto& p : stem.outline) {
      outline.push_back(frame.map(p.x(), p.y()));
      if (outline.back().y() < top.y()) top = outline.back();
    }
    const bool chosen = stem.tree_id == data.selected;
    const Color color = chosen ? section_hand : quality_color(stem.quality);
    canvas.polygon(outline, color.with_alpha(0.2), Stroke{color, chosen ? 0.6 : 0.4});
    TextStyle number{7, color, true};
    number.halo_mm = 0.5;
    canvas.text({top.x(), std::max(top.y() - 1, frame.box.y0 + 3.2)}, std::to_string(stem.tree_id),
                number.aligned(HAlign::centre, VAlign::baseline));
  }
}

void draw_marks(Canvas& canvas, const CrossSectionData& data, const Frame& frame) {
  for (const auto& mark : data.marks) {
    for (const auto& line : mark.lines) {
      std::vector<Eigen::Vector2d> places;
      for (const auto& p : line) places.push_back(frame.map(p.x(), p.y()));
      canvas.polyline(places, Stroke{section_hand, mark.strong ? 0.6 : 0.4});
      for (const auto& p : places) canvas.circle(p, 0.6, section_hand);
    }
    if (mark.label.empty()) continue;
    TextStyle label{7, section_hand};
    label.halo_mm = 0.5;
    canvas.text(frame.map(mark.label_at.x(), mark.label_at.y()) + Eigen::Vector2d(1, -1), mark.label, label);
  }
}

}  // namespace

SectionSight whole_section(const CrossSectionData& data, double width_mm, double height_mm) {
  std::vector<double> heights;
  for (const auto& p : data.points) heights.push_back(p.y());
  for (const auto& stem : data.stems)
    for (const auto& p : stem.outline) heights.push_back(p.y());
  const Interval z = middle_of(std::move(heights));
  const Frame sheet = section_frame({}, width_mm, height_mm);
  return {{data.length_m / 2, (z.lo + z.hi) / 2},
          filled * std::min(sheet.box.width() / std::max(data.length_m, min_span_m),
                            sheet.box.height() / std::max(z.length(), min_span_m))};
}

Frame section_frame(const SectionSight& sight, double width_mm, double height_mm) {
  const Box box{axis_space_left_mm, 2, std::max(width_mm - 2, axis_space_left_mm + 1),
                std::max(height_mm - axis_space_below_mm, 3.0)};
  const double half_x = box.width() / sight.mm_per_m / 2, half_z = box.height() / sight.mm_per_m / 2;
  return {box,
          {sight.centre.x() - half_x, sight.centre.x() + half_x},
          {sight.centre.y() - half_z, sight.centre.y() + half_z}};
}

Figure cross_section(const CrossSectionData& data, const SectionSight& sight, double width_mm, double height_mm,
                     double dpi, int dot_px) {
  Figure figure;
  figure.name = "cross_section";
  figure.width_mm = width_mm;
  figure.height_mm = height_mm;
  figure.vector = false;
  figure.draw = [data, sight, width_mm, height_mm, dpi, dot_px](Canvas& canvas) {
    const Frame frame = section_frame(sight, width_mm, height_mm);
    AxesStyle axes{"Along the line (m)", "z (m)"};
    axes.x_ticks = std::max(2, static_cast<int>(frame.box.width() / 22));
    axes.y_ticks = std::max(2, static_cast<int>(frame.box.height() / 8));
    draw_grid(canvas, frame, axes);
    {
      const auto clip = canvas.clip(frame.box);
      for (const double end : {0.0, data.length_m})
        canvas.line(frame.map(end, frame.y.lo), frame.map(end, frame.y.hi), Stroke{ink::muted, 0.2, {1, 1}});
      canvas.image(picture_of_points(data, frame, dpi, dot_px), frame.box);
      draw_terrain(canvas, data, frame);
      draw_section_stems(canvas, data, frame);
      draw_marks(canvas, data, frame);
      draw_cloud_keys(canvas, {frame.box.x1 - 1.5, frame.box.y0 + 1.5}, data.clouds);
    }
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

}  // namespace bole::render
