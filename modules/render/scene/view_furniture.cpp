#include "render/scene/view_furniture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double margin_mm = 4, halo_mm = 0.45, bar_mm = 40, scale_bar_mm = 9;
constexpr double north_side_mm = 22;
constexpr double note_pt = 7.5, note_line_mm = 4, label_pt = 7.5;

// Enough for a text of a sans serif face; what is too much stays transparent.
double room_mm(const std::string& text, double size_pt) {
  return 0.62 * size_pt * 0.3528 * static_cast<double>(text.size());
}

FurniturePatch patch(std::string state, const Box& box, std::function<void(Canvas&)> draw) {
  return {std::move(state), box, Figure{"view", {}, {}, box.width(), box.height(), false, std::move(draw)}};
}

bool has_bar(const std::optional<PointPaint>& paint) {
  return paint && paint->kind == PointPaint::Kind::map && paint->map != nullptr;
}

// From the right, the first one is number 0.
FurniturePatch color_bar(const ViewFurniture& f, const PointPaint& paint, int number) {
  constexpr double widest = 34;
  const double height = std::min(45.0, 0.4 * f.height_mm),
               width = number == 0 ? widest : std::min(widest, room_mm(paint.title, 7) + 6);
  const double right = f.width_mm - margin_mm + 2 - (widest + 1) * number;
  const Box box{right - width, f.height_mm - margin_mm - height - 7.5, right, f.height_mm - margin_mm + 2};
  return patch(fmt::format("bar {} {} {} {} {:.1f} {}", number, paint.array, paint.range.lo, paint.range.hi, height,
                           static_cast<const void*>(paint.map)),
               box, [paint, height](Canvas& canvas) {
                 canvas.rectangle(canvas.sheet().grown(-0.5), ink::paper.with_alpha(0.8), {}, 1);
                 draw_color_bar(canvas, {4, 7.5, 7.5, 7.5 + height}, *paint.map, paint.range, paint.title, 7);
               });
}

FurniturePatch color_note(const ViewFurniture& f, const PointPaint& paint) {
  const std::string text = "a colour for each " + paint.title;
  const double width = room_mm(text, 7) + 4;
  return patch(
      "colours " + text,
      {f.width_mm - margin_mm - width, f.height_mm - margin_mm - 5, f.width_mm - margin_mm, f.height_mm - margin_mm},
      [text](Canvas& canvas) {
        TextStyle style{7, ink::text};
        style.halo_mm = halo_mm;
        canvas.text({canvas.width_mm() - 0.5, canvas.height_mm() - 1}, text,
                    style.aligned(HAlign::right, VAlign::bottom));
      });
}

FurniturePatch scale_bar(const ViewFurniture& f) {
  const double metres = scale_bar_length_m(f.mm_per_metre, bar_mm);
  std::string said = f.perspective ? "at the centre" : "";
  for (const auto& [what, step_m] : {std::pair{"grid", f.grid_step_m}, {"contour lines", f.contour_step_m}})
    if (step_m > 0) said += fmt::format("{}{} {:g} m", said.empty() ? "" : ", ", what, step_m);
  // A bar that is hardly longer looks the same.
  const double per_metre = std::round(f.mm_per_metre * metres * 4) / 4 / metres;
  return patch(fmt::format("scale {:g} {:.2f} {}", metres, per_metre * metres, said),
               {margin_mm - 1, f.height_mm - margin_mm - 7, margin_mm + bar_mm + 14 + room_mm(said, 6),
                f.height_mm - margin_mm + 2},
               [per_metre, said](Canvas& canvas) {
                 const Eigen::Vector2d at(3, canvas.height_mm() - 2);
                 const double length = draw_scale_bar(canvas, at, per_metre, bar_mm, halo_mm);
                 TextStyle style{6, ink::muted};
                 style.halo_mm = halo_mm;
                 canvas.text(at + Eigen::Vector2d(length + 7, 0), said, style);
               });
}

FurniturePatch north_arrow(const ViewFurniture& f) {
  const double north_deg = std::round(degrees(f.north_rad));
  constexpr double side = north_side_mm;
  return patch(fmt::format("north {}", north_deg),
               {f.width_mm - margin_mm - side, margin_mm, f.width_mm - margin_mm, margin_mm + side},
               [north_deg](Canvas& canvas) {
                 // Turned about the middle of its shaft.
                 const double a = radians(north_deg);
                 const Eigen::Vector2d centre = canvas.sheet().centre();
                 draw_north_arrow(canvas, centre + 4 * Eigen::Vector2d(std::sin(a), std::cos(a)), 9, a, halo_mm);
               });
}

FurniturePatch notes(const ViewFurniture& f) {
  std::string all;
  double room = 0;
  for (const auto& note : f.notes) all += note + '\n', room = std::max(room, room_mm(note, note_pt));
  const double height = note_line_mm * static_cast<double>(f.notes.size()) + 2.4;
  return patch(
      "notes " + all, {margin_mm - 0.5, margin_mm - 0.5, margin_mm + room + 6, margin_mm + height + 0.5},
      [lines = f.notes, height](Canvas& canvas) {
        const TextStyle style{note_pt, ink::text};
        double width = 0;
        for (const auto& line : lines) width = std::max(width, canvas.text_size(line, style).x());
        canvas.rectangle({0.5, 0.5, width + 4.5, height + 0.5}, ink::paper.with_alpha(0.85), Stroke{ink::grid, 0.2}, 1);
        for (std::size_t i = 0; i < lines.size(); ++i)
          canvas.text({2.5, 1.7 + note_line_mm * static_cast<double>(i)}, lines[i],
                      style.aligned(HAlign::left, VAlign::top));
      });
}

FurniturePatch cloud_keys(const ViewFurniture& f) {
  std::string state = "clouds";
  for (const auto& key : f.clouds)
    state +=
        fmt::format(" {} {}", key.name,
                    key.color ? fmt::format("{:.3f} {:.3f} {:.3f}", key.color->r, key.color->g, key.color->b) : "");
  const double width = cloud_keys_width_mm(f.clouds) + 1, height = cloud_keys_height_mm(f.clouds) + 1;
  const double right = f.width_mm - margin_mm, top = margin_mm + (f.north ? north_side_mm : 0);
  return patch(std::move(state), {right - width, top, right + 0.5, top + height}, [keys = f.clouds](Canvas& canvas) {
    draw_cloud_keys(canvas, {canvas.width_mm() - 0.5, 0.5}, keys);
  });
}

// `which` keeps two that look alike apart.
FurniturePatch mark(const Eigen::Vector2d& at, std::size_t which) {
  constexpr double half = 2.6;
  return patch(fmt::format("mark {}", which), {at.x() - half, at.y() - half, at.x() + half, at.y() + half},
               [](Canvas& canvas) {
                 canvas.circle(canvas.sheet().centre(), 1.6, {}, Stroke{ink::paper, 0.9});
                 canvas.circle(canvas.sheet().centre(), 1.6, {}, Stroke{ink::accent, 0.4});
               });
}

FurniturePatch label(const ViewFurniture::Label& label, std::size_t which) {
  constexpr double half_height = 2.6, off_mm = 1.5;
  return patch(fmt::format("label {} {} {}", which, label.strong, label.text),
               {label.at_mm.x() + off_mm, label.at_mm.y() - half_height,
                label.at_mm.x() + off_mm + room_mm(label.text, label_pt) + 4, label.at_mm.y() + half_height},
               [text = label.text, strong = label.strong](Canvas& canvas) {
                 TextStyle style{label_pt, ink::text, strong};
                 const double width = canvas.text_size(text, style).x();
                 canvas.rectangle({0.3, 0.3, width + 2.3, canvas.height_mm() - 0.3}, ink::paper.with_alpha(0.85),
                                  Stroke{strong ? ink::accent : ink::muted, 0.2}, 0.8);
                 canvas.text({1.3, canvas.height_mm() / 2}, text, style.aligned(HAlign::left, VAlign::middle));
               });
}

FurniturePatch tree_patch(const TreeMark& mark) {
  return patch(fmt::format("tree {} {} {} {}", mark.number, mark.quality, mark.state, mark.strong), mark_box(mark),
               [mark](Canvas& canvas) { draw_tree_mark(canvas, mark); });
}

// Above the scale bar.
FurniturePatch tree_legend(const ViewFurniture& f) {
  const double bottom = f.height_mm - margin_mm - scale_bar_mm, height = tree_legend_height_mm(f.trees);
  return patch(tree_legend_state(f.trees),
               {margin_mm - 1, bottom - height, margin_mm - 1 + tree_legend_width_mm, bottom},
               [trees = f.trees](Canvas& canvas) { draw_tree_legend(canvas, trees); });
}

}  // namespace

std::vector<FurniturePatch> furniture_patches(const ViewFurniture& f) {
  std::vector<FurniturePatch> patches;
  if (has_bar(f.paint)) patches.push_back(color_bar(f, *f.paint, 0));
  if (!has_bar(f.paint) && f.paint && !f.paint->title.empty()) patches.push_back(color_note(f, *f.paint));
  if (has_bar(f.clouds_paint)) patches.push_back(color_bar(f, *f.clouds_paint, f.paint ? 1 : 0));
  if (f.mm_per_metre > 0 && std::isfinite(f.mm_per_metre)) patches.push_back(scale_bar(f));
  if (f.north) patches.push_back(north_arrow(f));
  if (!f.notes.empty()) patches.push_back(notes(f));
  if (!f.clouds.empty()) patches.push_back(cloud_keys(f));
  for (const auto& tree : f.trees) patches.push_back(tree_patch(tree));
  if (f.tree_legend && tree_legend_height_mm(f.trees) > 0) patches.push_back(tree_legend(f));
  for (std::size_t i = 0; i < f.marks_mm.size(); ++i) patches.push_back(mark(f.marks_mm[i], i));
  for (std::size_t i = 0; i < f.labels.size(); ++i) patches.push_back(label(f.labels[i], i));
  return patches;
}

}  // namespace bole::render
