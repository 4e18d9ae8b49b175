#include "render/charts/stem_slice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr int sectors = 36;
constexpr double line_mm = 4, band_m_share = 0.05, full_color_m = 0.02;
constexpr double near_rim = 0.35;  // of the radius: points further off do not count as of the stem
const Color hand = hex(0x0073e6);

void draw_slice_points(Canvas& canvas, const StemSliceData& data, const SliceScale& scale) {
  for (const auto& cloud : data.beside) {
    std::vector<Eigen::Vector2d> dots;
    for (const auto& p : cloud.points) dots.push_back(scale.to_sheet(p));
    if (cloud.key.color) canvas.dots(dots, cloud.points.size() < 400 ? 0.6 : 0.4, cloud.key.color->with_alpha(0.8));
  }
  std::map<int, std::vector<Eigen::Vector2d>> by_pass;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    by_pass[i < data.pass.size() ? data.pass[i] : 0].push_back(scale.to_sheet(data.points[i]));
  for (const auto& [pass, dots] : by_pass)
    canvas.dots(dots, data.points.size() < 400 ? 0.6 : 0.4,
                by_pass.size() > 1 ? id_color(pass + 1) : ink::primary.with_alpha(0.7));
}

// A band around the picture: where bark was seen, and whether it lies within (blue) or outside (red) of the circle.
void draw_band(Canvas& canvas, const StemSliceData& data, const SliceScale& scale) {
  if (!data.stem || data.stem->radius_m <= 0) return;
  const auto residuals = sector_residuals(data.points, *data.stem);
  const double outer = data.reach_m * scale.mm_per_metre, inner = outer * (1 - band_m_share);
  const auto& map = ColorMap::diverging();
  for (int k = 0; k < sectors; ++k) {
    const auto& r = residuals[static_cast<std::size_t>(k)];
    std::vector<Eigen::Vector2d> outline;
    const auto at = [&](double radius, double sector) -> Eigen::Vector2d {
      const double a = 2 * std::numbers::pi * sector / sectors;
      return scale.middle_mm + radius * Eigen::Vector2d(std::cos(a), -std::sin(a));
    };
    for (int s = 0; s <= 4; ++s) outline.push_back(at(outer, k + 0.06 + 0.22 * s));
    for (int s = 4; s >= 0; --s) outline.push_back(at(inner, k + 0.06 + 0.22 * s));
    canvas.polygon(outline, r.points > 0 ? map.at(0.5 + 0.5 * r.median_m / full_color_m) : ink::paper,
                   Stroke{hex(0xc9d0d5), 0.1});
  }
}

void draw_slice_circle(Canvas& canvas, const SliceScale& scale, const SliceCircle& circle, const Stroke& stroke) {
  canvas.circle(scale.to_sheet(circle.centre), circle.radius_m * scale.mm_per_metre, {}, stroke);
}

void draw_stem(Canvas& canvas, const StemSliceData& data, const SliceScale& scale) {
  const Color color = quality_color(data.quality);
  const auto& stem = *data.stem;
  if (std::isfinite(stem.lo_m + stem.hi_m) && stem.hi_m > 0)
    canvas.ring(scale.to_sheet(stem.centre), std::max(0.0, stem.lo_m * scale.mm_per_metre),
                stem.hi_m * scale.mm_per_metre, color.with_alpha(0.25));
  draw_slice_circle(canvas, scale, stem, Stroke{color, 0.4});
  canvas.cross(scale.to_sheet(stem.centre), 1.1, Stroke{color, 0.3});
}

}  // namespace

std::vector<SectorResidual> sector_residuals(const std::vector<Eigen::Vector2d>& points, const SliceCircle& circle) {
  std::vector<std::vector<double>> values(sectors);
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - circle.centre;
    const double residual = d.norm() - circle.radius_m;
    if (std::abs(residual) > near_rim * circle.radius_m) continue;
    const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi);
    const int k = static_cast<int>(std::floor((turn < 0 ? turn + 1 : turn) * sectors));
    values[static_cast<std::size_t>(std::clamp(k, 0, sectors - 1))].push_back(residual);
  }
  std::vector<SectorResidual> result(sectors);
  for (std::size_t k = 0; k < values.size(); ++k) {
    auto& v = values[k];
    if (v.empty()) continue;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    result[k] = {static_cast<int>(v.size()), v[v.size() / 2]};
  }
  return result;
}

SliceScale slice_scale(double width_mm, double height_mm, std::size_t lines, double reach_m) {
  const double top = line_mm * static_cast<double>(lines) + 2;
  const double side = std::max(1.0, std::min(width_mm, height_mm - top) - 2);
  return {{width_mm / 2, top + (height_mm - top) / 2}, side / 2 / reach_m};
}

Figure stem_slice(const StemSliceData& data, double width_mm, double height_mm) {
  Figure figure;
  figure.name = "stem_slice";
  figure.width_mm = width_mm;
  figure.height_mm = height_mm;
  figure.draw = [data, width_mm, height_mm](Canvas& canvas) {
    const auto scale = slice_scale(width_mm, height_mm, data.lines.size(), data.reach_m);
    const double half = data.reach_m * scale.mm_per_metre;
    const Box box{scale.middle_mm.x() - half, scale.middle_mm.y() - half, scale.middle_mm.x() + half,
                  scale.middle_mm.y() + half};
    {
      const auto clip = canvas.clip(box);
      draw_slice_points(canvas, data, scale);
      draw_band(canvas, data, scale);
      for (const auto& neighbour : data.neighbours) {
        draw_slice_circle(canvas, scale, neighbour, Stroke{ink::muted, 0.25});
        TextStyle label{6.5, ink::muted};
        label.halo_mm = 0.4;
        canvas.text(scale.to_sheet(neighbour.centre), std::to_string(neighbour.tree_id),
                    label.aligned(HAlign::centre, VAlign::middle));
      }
      if (data.stem) draw_stem(canvas, data, scale);
      if (data.drawn) {
        draw_slice_circle(canvas, scale, *data.drawn, Stroke{hand, 0.25, {1.2, 0.9}});
        canvas.cross(scale.to_sheet(data.drawn->centre), 1.1, Stroke{hand, 0.25});
      }
      if (data.refit) draw_slice_circle(canvas, scale, *data.refit, Stroke{hand, 0.5});
    }
    canvas.rectangle(box, {}, Stroke{hex(0xc9d0d5), 0.2});
    draw_cloud_keys(canvas, {box.x1 - 1, box.y0 + 1}, data.beside);
    draw_scale_bar(canvas, {box.x0 + 3, box.y1 - 2}, scale.mm_per_metre, 0.3 * box.width(), 0.4);
    for (std::size_t i = 0; i < data.lines.size(); ++i)
      canvas.text({1.5, 1 + line_mm * static_cast<double>(i)}, data.lines[i],
                  TextStyle{i == 0 ? 8.5 : 7.0, ink::text, i == 0}.aligned(HAlign::left, VAlign::top));
    if (data.points.empty())
      canvas.text(box.centre() + Eigen::Vector2d(0, 6), "no points at this height",
                  TextStyle{7, ink::muted}.aligned(HAlign::centre, VAlign::middle));
  };
  return figure;
}

}  // namespace bole::render
