#include "render/charts/slice_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double pair_gap_mm = 1.2, group_gap_mm = 5, head_mm = 5, name_mm = 4.2, foot_mm = 4.2, pair_legend_mm = 7;
constexpr double max_panel_mm = 41, min_panel_mm = 34;

void draw_dashed_circle(Canvas& canvas, const Eigen::Vector2d& centre, double radius_mm, const Stroke& stroke) {
  if (stroke.dash_mm.empty()) return canvas.circle(centre, radius_mm, {}, stroke);
  constexpr int corners = 72;
  std::vector<Eigen::Vector2d> ring;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * std::numbers::pi * i / corners;
    ring.emplace_back(centre + radius_mm * Eigen::Vector2d(std::cos(a), std::sin(a)));
  }
  canvas.polygon(ring, {}, stroke);
}

void draw_slice(Canvas& canvas, const ComparedSlice& slice, const Color& color, double reference_dbh_m, double reach_m,
                const Box& box) {
  const Eigen::Vector2d centre = box.centre();
  const double mm_per_m = box.width() / 2 / reach_m;
  {
    const auto clip = canvas.clip(box);
    std::vector<Eigen::Vector2d> dots;
    for (const auto& p : slice.panel.points)
      dots.emplace_back(centre.x() + p.offset.x() * mm_per_m, centre.y() - p.offset.y() * mm_per_m);
    canvas.dots(dots, dots.size() < 300 ? 0.5 : 0.34, ink::muted.with_alpha(0.75));
    if (std::isfinite(reference_dbh_m)) {
      const Eigen::Vector2d at(centre.x() + slice.to_reference.x() * mm_per_m,
                               centre.y() - slice.to_reference.y() * mm_per_m);
      draw_dashed_circle(canvas, at, reference_dbh_m / 2 * mm_per_m, Stroke{ink::text, 0.3, {1.2, 0.9}});
    }
    if (slice.found && std::isfinite(slice.panel.dbh_m))
      draw_dashed_circle(canvas, centre, slice.panel.dbh_m / 2 * mm_per_m, Stroke{color, 0.4});
  }
  canvas.rectangle(box, {}, Stroke{hex(0xc9d0d5), 0.15});
}

struct Layout {
  double panel_mm = max_panel_mm;
  std::size_t runs = 1, per_row = 1;
  double group_mm() const { return static_cast<double>(runs) * panel_mm + static_cast<double>(runs - 1) * pair_gap_mm; }
  double row_mm() const { return head_mm + name_mm + panel_mm + foot_mm; }
};

Layout layout_of(std::size_t runs, double width_mm) {
  Layout l;
  l.runs = std::max<std::size_t>(1, runs);
  const double n = static_cast<double>(l.runs), narrowest_mm = n * min_panel_mm + (n - 1) * pair_gap_mm;
  l.per_row =
      std::max<std::size_t>(1, static_cast<std::size_t>((width_mm + group_gap_mm) / (narrowest_mm + group_gap_mm)));
  const double groups = static_cast<double>(l.per_row), group_mm = (width_mm - (groups - 1) * group_gap_mm) / groups;
  l.panel_mm = std::min(max_panel_mm, (group_mm - (n - 1) * pair_gap_mm) / n);
  return l;
}

void draw_tree(Canvas& canvas, const ComparedTree& tree, const std::vector<SliceRun>& runs, const Layout& layout,
               const Eigen::Vector2d& corner) {
  double widest_m = 0.05;
  for (const auto& s : tree.slices) {
    if (s.found && std::isfinite(s.panel.dbh_m)) widest_m = std::max(widest_m, s.panel.dbh_m);
    if (std::isfinite(tree.reference_dbh_m)) widest_m = std::max(widest_m, tree.reference_dbh_m);
  }
  const double reach_m = slice_reach_m(widest_m);
  std::string title = "Tree " + tree.name;
  if (std::isfinite(tree.reference_dbh_m)) title += ", reference " + fixed(100 * tree.reference_dbh_m, 1) + " cm";
  canvas.text({corner.x(), corner.y() + head_mm - 1.4}, title,
              TextStyle{8, ink::text, true}.aligned(HAlign::left, VAlign::baseline));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const double x = corner.x() + static_cast<double>(k) * (layout.panel_mm + pair_gap_mm), y = corner.y() + head_mm;
    canvas.text({x, y + name_mm - 1.2}, runs[k].name,
                TextStyle{7, runs[k].color}.aligned(HAlign::left, VAlign::baseline));
    const Box box{x, y + name_mm, x + layout.panel_mm, y + name_mm + layout.panel_mm};
    draw_slice(canvas, tree.slices[k], runs[k].color, tree.reference_dbh_m, reach_m, box);
    const auto& panel = tree.slices[k].panel;
    canvas.text({x, box.y1 + foot_mm - 1}, tree.slices[k].found ? fixed(100 * panel.dbh_m, 1) + " cm" : "not found",
                TextStyle{7}.aligned(HAlign::left, VAlign::baseline));
    canvas.text({box.x1, box.y1 + foot_mm - 1}, panel.found > 0 ? "n " + std::to_string(panel.found) : "no points",
                TextStyle{6, ink::muted}.aligned(HAlign::right, VAlign::baseline));
  }
}

}  // namespace

Figure slices_side_by_side(const std::vector<SliceRun>& runs, const std::vector<ComparedTree>& trees, double width_mm) {
  const auto layout = layout_of(runs.size(), width_mm);
  const std::size_t rows = (trees.size() + layout.per_row - 1) / layout.per_row;
  Figure figure;
  figure.name = "slices";
  figure.title = "Breast-height slices side by side";
  figure.caption =
      "Points within 5 cm of breast height (grey) and the circle that each run measured; n: points in the slice. All "
      "panels of a tree have one scale.";
  if (std::ranges::any_of(trees, [](const ComparedTree& t) { return std::isfinite(t.reference_dbh_m); }))
    figure.caption += " Dashed: reference diameter at the reference position.";
  figure.width_mm = width_mm;
  figure.height_mm = static_cast<double>(rows) * (layout.row_mm() + pair_gap_mm) + pair_legend_mm;
  figure.draw = [runs, trees, layout](Canvas& canvas) {
    for (std::size_t i = 0; i < trees.size(); ++i) {
      const std::size_t column = i % layout.per_row, row = i / layout.per_row;
      draw_tree(canvas, trees[i], runs, layout,
                {static_cast<double>(column) * (layout.group_mm() + group_gap_mm),
                 static_cast<double>(row) * (layout.row_mm() + pair_gap_mm)});
    }
    std::vector<LegendEntry> entries;
    for (const auto& run : runs) entries.push_back({Symbol::ring, run.color, run.name});
    entries.push_back({Symbol::dashed_line, ink::text, "reference"});
    draw_legend_row(canvas, {0, canvas.height_mm() - pair_legend_mm + 1}, canvas.width_mm(), entries);
  };
  return figure;
}

}  // namespace bole::render
