#include "render/rows/row_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/charts/columns.h"
#include "render/rows/oblique_view.h"
#include "render/rows/plant_cloud.h"
#include "render/rows/row_plan.h"

namespace bole::render {
namespace {

constexpr double between_mm = 6, legend_line_mm = 4.2;
constexpr std::size_t max_listed = 8;  // rows whose angles stand below a plan
const Color reference_ink = ink::accent, found_ink = ink::primary;

// Of plants and lines, as far as they are drawn.
struct TruthContent {
  std::vector<Eigen::Vector2d> plants, reference;
  std::vector<PlannedRow> rows, reference_rows;
  std::vector<std::string> angles, reference_angles, errors;  // a line of text per row
  MapExtent extent;
  bool north_known = true;
};

std::string degrees_text(double value) { return fixed(value, 2) + "\u00b0"; }

void add_angles(TruthContent& c, const Table& matches) {
  const auto kind = texts_or_empty(matches, "kind");
  const auto angle = numbers_or_nan(matches, "angle_deg"), truth = numbers_or_nan(matches, "ref_angle_deg"),
             error = numbers_or_nan(matches, "angle_error_deg");
  for (std::size_t i = 0; i < matches.rows(); ++i) {
    const auto id = matches.text("row_id", i), ref = matches.text("ref_id", i);
    if (std::isfinite(angle[i])) c.angles.push_back(fmt::format("row {}: {}", id, degrees_text(angle[i])));
    if (std::isfinite(truth[i])) c.reference_angles.push_back(fmt::format("row {}: {}", ref, degrees_text(truth[i])));
    if (std::isfinite(error[i]))
      c.errors.push_back(fmt::format("row {}: {}{}", id, error[i] > 0 ? "+" : "", degrees_text(error[i])));
  }
  for (auto* list : {&c.angles, &c.reference_angles, &c.errors})
    if (list->size() > max_listed) list->clear();
}

TruthContent content_of_truth(const RowTruth& t) {
  TruthContent c;
  c.north_known = t.north_known;
  c.plants = standing_plants(*t.plants);
  c.reference = standing_plants(*t.reference);
  c.rows = planned_rows(*t.lines);
  c.reference_rows = planned_rows(*t.reference_lines);
  if (t.matches != nullptr) add_angles(c, *t.matches);
  auto all = c.plants;
  all.insert(all.end(), c.reference.begin(), c.reference.end());
  auto lines = c.rows;
  lines.insert(lines.end(), c.reference_rows.begin(), c.reference_rows.end());
  c.extent = extent_of_rows(lines, all);
  return c;
}

// Height over width of a plan with this extent, within what a sheet can hold.
double shape_of(const MapExtent& extent) {
  if (extent.empty()) return 1;
  const Eigen::Vector2d size = extent.hi - extent.lo;
  return std::clamp(size.y() / size.x(), 0.45, 1.3);
}

// How many lines a list of words takes in `width_mm`, about 30 mm each.
double list_height_mm(std::size_t entries, double width_mm) {
  const auto across = std::max<std::size_t>(1, static_cast<std::size_t>(width_mm / 30));
  const std::size_t lines = (entries + across - 1) / across;
  return legend_line_mm * static_cast<double>(lines);
}

// The words side by side below a plan.
void draw_list(Canvas& canvas, const Eigen::Vector2d& at, double width_mm, const std::vector<std::string>& words,
               const Color& color) {
  const auto across = std::max<std::size_t>(1, static_cast<std::size_t>(width_mm / 30));
  const TextStyle style{7, color};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t column = i % across, line = i / across;
    canvas.text(
        at + Eigen::Vector2d(30.0 * static_cast<double>(column), legend_line_mm * (static_cast<double>(line) + 0.5)),
        words[i], style.aligned(HAlign::left, VAlign::middle));
  }
}

void draw_found(Canvas& canvas, const Frame& frame, const TruthContent& c, bool ids) {
  draw_planned_rows(canvas, frame, c.rows, {found_ink, false, 0.35, ids});
  for (const auto& p : c.plants) canvas.cross(frame.map(p.x(), p.y()), 0.9, Stroke{found_ink, 0.35});
}

void draw_reference(Canvas& canvas, const Frame& frame, const TruthContent& c, bool ids) {
  draw_planned_rows(canvas, frame, c.reference_rows, {reference_ink, true, 0.3, ids});
  for (const auto& p : c.reference) canvas.circle(frame.map(p.x(), p.y()), 1.0, {}, Stroke{reference_ink, 0.3});
}

// A plan in the box of its axes' frame.
template <class Content>
void draw_truth_plan(Canvas& canvas, const TruthContent& c, const Box& box, const Content& content) {
  const Frame frame = fitted_frame(c.extent, box);
  const auto axes = row_axes(c.north_known);
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    content(frame);
  }
  draw_axes(canvas, frame, axes);
}

const LegendEntry found_plant{Symbol::cross, found_ink, "plant found"}, found_row{Symbol::line, found_ink, "row found"},
    true_plant{Symbol::ring, reference_ink, "reference plant"},
    true_row{Symbol::dashed_line, reference_ink, "reference row"};

}  // namespace

Figure rows_and_reference(const RowTruth& truth, double width_mm) {
  auto c = content_of_truth(truth);
  const double panel_mm = (width_mm - between_mm) / 2, plan_mm = panel_mm - axis_space_left_mm - 1,
               plan_height_mm = plan_mm * shape_of(c.extent), title_mm = 4.5,
               list_mm = list_height_mm(std::max(c.angles.size(), c.reference_angles.size()), plan_mm);
  Figure figure;
  figure.name = "rows_and_reference";
  figure.title = "Rows and reference rows";
  figure.caption =
      "a: centres of the plants that were found with the least-squares lines of their rows; b: the reference plants "
      "with theirs. Angles of the rows to due east.";
  figure.width_mm = width_mm;
  figure.height_mm = title_mm + plan_height_mm + axis_space_below_mm + 2 + legend_line_mm + list_mm + 1;
  figure.draw = [c = std::move(c), panel_mm, plan_mm, plan_height_mm, title_mm](Canvas& canvas) {
    for (const bool reference : {false, true}) {
      const double x = reference ? panel_mm + between_mm : 0;
      draw_panel_title(canvas, {x, 0}, reference ? "b" : "a", reference ? "Reference" : "Found");
      const Box box{x + axis_space_left_mm, title_mm, x + axis_space_left_mm + plan_mm, title_mm + plan_height_mm};
      draw_truth_plan(canvas, c, box, [&](const Frame& frame) {
        reference ? draw_reference(canvas, frame, c, true) : draw_found(canvas, frame, c, true);
      });
      const double below = box.y1 + axis_space_below_mm + 2;
      draw_legend_row(canvas, {box.x0 - 1.5, below}, plan_mm + 1.5,
                      reference ? std::vector{true_plant, true_row} : std::vector{found_plant, found_row});
      draw_list(canvas, {box.x0, below + legend_line_mm}, plan_mm, reference ? c.reference_angles : c.angles,
                reference ? reference_ink : found_ink);
    }
  };
  return figure;
}

Figure rows_over_reference(const RowTruth& truth, const PointCloud* cloud, double width_mm) {
  auto c = content_of_truth(truth);
  const bool with_cloud = cloud != nullptr && !cloud->empty();
  const double panel_mm = with_cloud ? (width_mm - between_mm) / 2 : 0,
               plan_mm = width_mm - (with_cloud ? panel_mm + between_mm : 0) - axis_space_left_mm - 1,
               plan_height_mm = plan_mm * shape_of(c.extent), title_mm = with_cloud ? 4.5 : 1,
               list_mm = list_height_mm(c.errors.size(), plan_mm) + (c.errors.empty() ? 0 : legend_line_mm);
  Figure figure;
  figure.name = "rows_over_reference";
  figure.title = "Rows over the reference";
  figure.caption =
      std::string(with_cloud ? "a: the points of the levelled frame, coloured by height (x right, y ahead, z "
                               "up); b: "
                             : "") +
      "plants and rows that were found (blue) over those of the reference (red), with the error of each "
      "row's angle.";
  figure.width_mm = width_mm;
  figure.height_mm = title_mm + plan_height_mm + axis_space_below_mm + 2 + 2 * legend_line_mm + list_mm + 1;
  PlantCloud points;
  if (with_cloud) {
    constexpr std::size_t most = 12000;
    auto around = box_of(*cloud, false);
    around.round(0);
    points = height_cloud(*cloud, around, most);
  }
  figure.draw = [c = std::move(c), points = std::move(points), with_cloud, panel_mm, plan_mm, plan_height_mm,
                 title_mm](Canvas& canvas) {
    const double x = with_cloud ? panel_mm + between_mm : 0;
    if (with_cloud) {
      draw_panel_title(canvas, {0, 0}, "a", "Points");
      draw_panel_title(canvas, {x, 0}, "b", "Rows");
      const ObliqueView view(points.lo, points.hi, {0, title_mm, panel_mm, canvas.height_mm()});
      view.draw_axes(canvas);
      view.draw_points(canvas, points.points, 0.3);
    }
    const Box box{x + axis_space_left_mm, title_mm, x + axis_space_left_mm + plan_mm, title_mm + plan_height_mm};
    draw_truth_plan(canvas, c, box, [&](const Frame& frame) {
      draw_reference(canvas, frame, c, false);
      draw_found(canvas, frame, c, true);
    });
    const double below = box.y1 + axis_space_below_mm + 2;
    const double used =
        draw_legend_row(canvas, {box.x0 - 1.5, below}, plan_mm + 1.5, {found_plant, found_row, true_plant, true_row});
    if (c.errors.empty()) return;
    const TextStyle style{7, ink::text};
    canvas.text({box.x0, below + used + legend_line_mm / 2},
                "Angle, found minus reference:", style.aligned(HAlign::left, VAlign::middle));
    draw_list(canvas, {box.x0, below + used + legend_line_mm}, plan_mm, c.errors, ink::text);
  };
  return figure;
}

}  // namespace bole::render
