#include "render/scene/view_furniture.h"

#include <algorithm>

#include "render/draw/furniture.h"

namespace bole {
namespace {

constexpr double margin_mm = 4, halo_mm = 0.45;

void draw_legend(Canvas& canvas, const PointPaint& paint) {
  if (paint.kind == PointPaint::Kind::map && paint.map != nullptr) {
    const double height = std::min(45.0, 0.4 * canvas.height_mm()), x = canvas.width_mm() - margin_mm - 26;
    const Box bar{x, canvas.height_mm() - margin_mm - height, x + 3.5, canvas.height_mm() - margin_mm};
    canvas.rectangle({bar.x0 - 2, bar.y0 - 6.5, canvas.width_mm() - margin_mm + 2, bar.y1 + 2},
                     ink::paper.with_alpha(0.8), {}, 1);
    draw_color_bar(canvas, bar, *paint.map, paint.range, paint.title, 7);
    return;
  }
  TextStyle style{7, ink::text};
  style.halo_mm = halo_mm;
  if (!paint.title.empty())
    canvas.text({canvas.width_mm() - margin_mm, canvas.height_mm() - margin_mm}, "a colour for each " + paint.title,
                style.aligned(HAlign::right, VAlign::bottom));
}

void draw_notes(Canvas& canvas, const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  const TextStyle style{7.5, ink::text};
  double width = 0;
  for (const auto& note : notes) width = std::max(width, canvas.text_size(note, style).x());
  const double line = 4;
  canvas.rectangle(
      {margin_mm, margin_mm, margin_mm + width + 4, margin_mm + line * static_cast<double>(notes.size()) + 2.4},
      ink::paper.with_alpha(0.85), Stroke{ink::grid, 0.2}, 1);
  for (std::size_t i = 0; i < notes.size(); ++i)
    canvas.text({margin_mm + 2, margin_mm + 1.2 + line * static_cast<double>(i)}, notes[i],
                style.aligned(HAlign::left, VAlign::top));
}

}  // namespace

Figure view_furniture(const ViewFurniture& furniture) {
  Figure figure;
  figure.name = "view", figure.width_mm = furniture.width_mm, figure.height_mm = furniture.height_mm;
  figure.draw = [f = furniture](Canvas& canvas) {
    if (f.paint) draw_legend(canvas, *f.paint);
    if (f.mm_per_metre > 0) {
      const Eigen::Vector2d at(margin_mm + 2, canvas.height_mm() - margin_mm);
      const double length = draw_scale_bar(canvas, at, f.mm_per_metre, 40, halo_mm);
      TextStyle said{6, ink::muted};
      said.halo_mm = halo_mm;
      if (f.perspective) canvas.text(at + Eigen::Vector2d(length + 7, 0), "at the centre", said);
    }
    if (f.north_known)
      draw_north_arrow(canvas, {canvas.width_mm() - margin_mm - 5, margin_mm + 12}, 9, f.north_rad, halo_mm);
    draw_notes(canvas, f.notes);
    if (f.mark_mm) {
      canvas.circle(*f.mark_mm, 1.6, {}, Stroke{ink::paper, 0.9});
      canvas.circle(*f.mark_mm, 1.6, {}, Stroke{ink::accent, 0.4});
    }
  };
  return figure;
}

}  // namespace bole
