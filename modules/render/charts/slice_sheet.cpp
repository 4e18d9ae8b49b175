#include "render/charts/slice_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "render/charts/slice_panels.h"
#include "render/charts/worst_first.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double gap_mm = 2.2, header_mm = 5.4, footer_mm = 4.6;

void draw_panel_points(Canvas& canvas, const SlicePanel& panel, const Eigen::Vector2d& centre, double mm_per_m) {
  std::map<int, std::vector<Eigen::Vector2d>> by_pass;
  for (const auto& p : panel.points)
    by_pass[p.pass].emplace_back(centre.x() + p.offset.x() * mm_per_m, centre.y() - p.offset.y() * mm_per_m);
  // A dozen colours that tell passes of one tree apart; the same pass has the same colour on every tree.
  for (const auto& [pass, dots] : by_pass)
    canvas.dots(dots, panel.points.size() < 300 ? 0.5 : 0.36,
                by_pass.size() > 1 ? id_color(pass + 1) : ink::primary.with_alpha(0.7));
}

void draw_slice_panel(Canvas& canvas, const SlicePanel& panel, const Box& box) {
  const Color color = quality_color(panel.quality);
  const Box head{box.x0, box.y0, box.x1, box.y0 + header_mm},
      body{box.x0, box.y0 + header_mm, box.x1, box.y1 - footer_mm};
  canvas.rectangle(head, mix(ink::paper, color, 0.14));
  canvas.rectangle({head.x0, head.y0, head.x0 + 1.1, head.y1}, color);
  canvas.text({head.x0 + 2.2, head.centre().y()}, panel.id,
              TextStyle{8, ink::text, true}.aligned(HAlign::left, VAlign::middle));
  canvas.text({head.x1 - 1.2, head.centre().y()}, panel.quality,
              TextStyle{6.5, mix(color, ink::text, 0.25)}.aligned(HAlign::right, VAlign::middle));

  const double side = std::min(body.width(), body.height()) - 1, reach = slice_reach_m(panel.dbh_m),
               mm_per_m = side / 2 / reach;
  const Eigen::Vector2d centre = body.centre();
  {
    const auto clip = canvas.clip(body);
    draw_panel_points(canvas, panel, centre, mm_per_m);
    if (std::isfinite(panel.lo_m) && std::isfinite(panel.hi_m))
      canvas.ring(centre, std::max(0.0, panel.lo_m / 2 * mm_per_m), panel.hi_m / 2 * mm_per_m, color.with_alpha(0.25));
    canvas.circle(centre, panel.dbh_m / 2 * mm_per_m, {}, Stroke{color, 0.35});
    canvas.cross(centre, 0.7, Stroke{color, 0.25});
  }
  const double unit_m = panel.dbh_m > 0.3 ? 0.1 : panel.dbh_m > 0.12 ? 0.05 : 0.02, bar = unit_m * mm_per_m;
  canvas.line({body.x1 - 1.2 - bar, body.y1 - 0.8}, {body.x1 - 1.2, body.y1 - 0.8}, Stroke{ink::text, 0.3});
  TextStyle small{5.5, ink::muted};
  small.halo_mm = 0.3;
  canvas.text({body.x1 - 1.2, body.y1 - 1.5}, fixed(100 * unit_m, 0) + " cm",
              small.aligned(HAlign::right, VAlign::baseline));
  if (panel.found == 0)
    canvas.text(centre + Eigen::Vector2d(0, 2.8), "no points in the slice",
                small.aligned(HAlign::centre, VAlign::middle));

  const bool interval = std::isfinite(panel.lo_m) && std::isfinite(panel.hi_m);
  std::string diameter =
      fixed(100 * panel.dbh_m, 1) + (interval ? " ± " + fixed(50 * (panel.hi_m - panel.lo_m), 1) : "") + " cm";
  canvas.text({box.x0 + 1.2, box.y1 - footer_mm / 2}, diameter,
              TextStyle{7, ink::text}.aligned(HAlign::left, VAlign::middle));
  canvas.text({box.x1 - 1.2, box.y1 - footer_mm / 2}, "n " + std::to_string(panel.found),
              TextStyle{5.5, ink::muted}.aligned(HAlign::right, VAlign::middle));
  canvas.rectangle(box, {}, Stroke{hex(0xc9d0d5), 0.15});
}

}  // namespace

std::vector<Figure> slice_sheets(const Table& stems, const PointCloud& slice, double width_mm,
                                 const SliceSheetOptions& options) {
  const auto panels = std::make_shared<const std::vector<SlicePanel>>(slice_panels(stems, slice, options.max_points));
  const auto order = worst_first(stems);
  const double side = (width_mm - gap_mm * (options.columns - 1) - 0.4) / options.columns,
               height = side + header_mm + footer_mm - 1;
  const auto per_page = static_cast<std::size_t>(options.columns) * static_cast<std::size_t>(options.rows_per_page);
  std::vector<Figure> pages;
  for (std::size_t begin = 0; begin < order.size(); begin += per_page) {
    const std::vector<std::size_t> page(
        order.begin() + static_cast<std::ptrdiff_t>(begin),
        order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), begin + per_page)));
    const auto rows =
        (page.size() + static_cast<std::size_t>(options.columns) - 1) / static_cast<std::size_t>(options.columns);
    Figure figure;
    figure.name = fmt::format("slices_{:02}", pages.size() + 1);
    figure.title = "Breast-height slices" +
                   (order.size() > per_page
                        ? fmt::format(" ({} of {})", pages.size() + 1, (order.size() + per_page - 1) / per_page)
                        : std::string());
    figure.caption =
        "Points at breast height (one colour per pass), fitted circle and the ring of its 95 % interval; diameter at "
        "breast height with half of that interval; n: points in the slice. The least certain trees come first.";
    figure.width_mm = width_mm;
    figure.height_mm = static_cast<double>(rows) * (height + gap_mm) - gap_mm + 0.4;
    figure.draw = [panels, page, side, height, columns = static_cast<std::size_t>(options.columns)](Canvas& canvas) {
      for (std::size_t i = 0; i < page.size(); ++i) {
        const std::size_t column = i % columns, row = i / columns;
        const double x = 0.2 + static_cast<double>(column) * (side + gap_mm),
                     y = 0.2 + static_cast<double>(row) * (height + gap_mm);
        draw_slice_panel(canvas, (*panels)[page[i]], {x, y, x + side, y + height});
      }
    };
    pages.push_back(std::move(figure));
  }
  return pages;
}

}  // namespace bole::render
