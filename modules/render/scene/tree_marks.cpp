#include "render/scene/tree_marks.h"

#include <algorithm>
#include <array>

namespace bole::render {
namespace {

constexpr double tree_number_pt = 7, mark_half_mm = 2.1, mark_left_mm = 1.7, symbol_mm = 1.0, number_at_mm = 1.7;
constexpr double legend_line_mm = 3.8, legend_rim_mm = 1.2;
constexpr std::array<const char*, 3> qualities{"good", "fair", "poor"};
constexpr std::array<const char*, 2> decisions{"accepted", "rejected"};

void draw_quality_symbol(Canvas& canvas, const Eigen::Vector2d& at, const std::string& quality, double size_mm) {
  const Color fill = quality_color(quality);
  const Stroke rim{ink::paper, 0.3};
  if (quality == "good") return canvas.circle(at, size_mm, fill, rim);
  if (quality == "fair") {
    const double h = 1.15 * size_mm;
    const std::array<Eigen::Vector2d, 3> corners{at + Eigen::Vector2d(0, -h), at + Eigen::Vector2d(h, 0.85 * h),
                                                 at + Eigen::Vector2d(-h, 0.85 * h)};
    return canvas.polygon(corners, fill, rim);
  }
  if (quality == "poor")
    return canvas.rectangle(
        {at.x() - 0.9 * size_mm, at.y() - 0.9 * size_mm, at.x() + 0.9 * size_mm, at.y() + 0.9 * size_mm}, fill, rim);
  canvas.circle(at, 0.8 * size_mm, {}, Stroke{ink::muted, 0.4});
}

void draw_decision(Canvas& canvas, const Eigen::Vector2d& at, const std::string& state) {
  if (state == "rejected") {
    canvas.cross(at, 1.5, Stroke{ink::paper, 0.9});
    canvas.cross(at, 1.5, Stroke{ink::text, 0.4});
  }
  if (state != "accepted") return;
  const std::array<Eigen::Vector2d, 3> tick{at + Eigen::Vector2d(-0.9, 0.1), at + Eigen::Vector2d(-0.2, 0.9),
                                            at + Eigen::Vector2d(1.3, -1.4)};
  canvas.polyline(tick, Stroke{ink::paper, 0.9});
  canvas.polyline(tick, Stroke{ink::text, 0.4});
}

struct LegendLine {
  std::string quality, state;
};

std::vector<LegendLine> legend_lines(const std::vector<TreeMark>& marks) {
  std::vector<LegendLine> lines;
  for (const char* quality : qualities)
    if (std::ranges::find(marks, quality, &TreeMark::quality) != marks.end()) lines.push_back({quality, {}});
  for (const char* state : decisions)
    if (std::ranges::find(marks, state, &TreeMark::state) != marks.end()) lines.push_back({{}, state});
  return lines;
}

}  // namespace

Box mark_box(const TreeMark& mark) {
  const double width = 0.62 * tree_number_pt * 0.3528 * static_cast<double>(mark.number.size()) + 1;
  return {mark.at_mm.x() - mark_left_mm, mark.at_mm.y() - mark_half_mm, mark.at_mm.x() + number_at_mm + width,
          mark.at_mm.y() + mark_half_mm};
}

std::vector<TreeMark> kept_apart(const std::vector<TreeMark>& marks, const Box& view, std::size_t max_count) {
  std::vector<TreeMark> kept;
  std::vector<Box> taken;
  for (const auto& mark : marks) {
    if (kept.size() >= max_count) break;
    const Box box = mark_box(mark);
    if (!view.contains(box) || std::ranges::any_of(taken, [&](const Box& b) { return b.overlaps(box); })) continue;
    taken.push_back(box);
    kept.push_back(mark);
  }
  return kept;
}

void draw_tree_mark(Canvas& canvas, const TreeMark& mark) {
  const Eigen::Vector2d at(mark_left_mm, canvas.height_mm() / 2);
  draw_quality_symbol(canvas, at, mark.quality, mark.strong ? 1.3 * symbol_mm : symbol_mm);
  TextStyle style{tree_number_pt, mark.state == "rejected" ? ink::muted : ink::text, mark.strong};
  style.halo_mm = 0.45;
  const double x = at.x() + number_at_mm;
  canvas.text({x, at.y()}, mark.number, style.aligned(HAlign::left, VAlign::middle));
  if (mark.state == "rejected") {
    const double width = canvas.text_size(mark.number, style).x();
    canvas.line({x - 0.2, at.y()}, {x + width + 0.2, at.y()}, Stroke{ink::text, 0.3});
  }
  draw_decision(canvas, at, mark.state);
}

double tree_legend_height_mm(const std::vector<TreeMark>& marks) {
  const auto lines = legend_lines(marks);
  return lines.empty() ? 0 : legend_line_mm * static_cast<double>(lines.size()) + 2 * legend_rim_mm;
}

std::string tree_legend_state(const std::vector<TreeMark>& marks) {
  std::string state = "trees";
  for (const auto& line : legend_lines(marks)) state += ' ' + line.quality + line.state;
  return state;
}

void draw_tree_legend(Canvas& canvas, const std::vector<TreeMark>& marks) {
  canvas.rectangle(canvas.sheet().grown(-0.3), ink::paper.with_alpha(0.85), Stroke{ink::grid, 0.2}, 1);
  double y = legend_rim_mm + legend_line_mm / 2;
  for (const auto& line : legend_lines(marks)) {
    const Eigen::Vector2d at(legend_rim_mm + 1.8, y);
    if (!line.quality.empty()) draw_quality_symbol(canvas, at, line.quality, symbol_mm);
    draw_decision(canvas, at, line.state);
    canvas.text({at.x() + 2.6, y}, line.quality + line.state,
                TextStyle{tree_number_pt, ink::text}.aligned(HAlign::left, VAlign::middle));
    y += legend_line_mm;
  }
}

}  // namespace bole::render
