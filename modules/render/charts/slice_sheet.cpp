#include "render/charts/slice_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>

#include "render/charts/columns.h"
#include "render/charts/worst_first.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

struct SlicePoint {
  Eigen::Vector2f offset;  // from the stem's centre, metres
  int pass = 0;
};

struct Panel {
  std::string id, quality, reasons;
  double dbh_m = 0, lo_m = 0, hi_m = 0;
  std::size_t found = 0;  // points, of which some may not be drawn
  std::vector<SlicePoint> points;
};

constexpr double gap_mm = 2.2, header_mm = 5.4, footer_mm = 4.6;

// How far around its centre a tree's panel looks.
double reach_m(double dbh_m) { return 0.62 * dbh_m + 0.035; }

class StemGrid {
 public:
  StemGrid(const std::vector<Eigen::Vector2d>& centres, const std::vector<double>& reach)
      : centres_(centres), reach_(reach) {
    for (const double r : reach) cell_ = std::max(cell_, r);
    for (std::size_t i = 0; i < centres.size(); ++i)
      if (centres[i].allFinite()) cells_[key(cell(centres[i].x()), cell(centres[i].y()))].push_back(i);
  }

  template <class Visit>
  void near(const Eigen::Vector2d& p, Visit visit) const {
    const auto cx = cell(p.x()), cy = cell(p.y());
    for (std::int64_t x = cx - 1; x <= cx + 1; ++x)
      for (std::int64_t y = cy - 1; y <= cy + 1; ++y)
        if (const auto it = cells_.find(key(x, y)); it != cells_.end())
          for (const auto i : it->second)
            if ((centres_[i] - p).cwiseAbs().maxCoeff() <= reach_[i]) visit(i);
  }

 private:
  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
  }
  const std::vector<Eigen::Vector2d>& centres_;
  const std::vector<double>& reach_;
  double cell_ = 0.05;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

std::vector<Panel> panels_of(const Table& stems, const PointCloud& slice, int max_points) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = numbers_or_nan(stems, "dbh_cm"),
             lo = numbers_or_nan(stems, "dbh_lo_cm"), hi = numbers_or_nan(stems, "dbh_hi_cm");
  const auto quality = texts_or_empty(stems, "quality"), reasons = texts_or_empty(stems, "reasons");
  std::vector<Panel> panels(stems.rows());
  std::vector<Eigen::Vector2d> centres;
  std::vector<double> reach;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i] = {stems.has("tree_id") ? stems.text("tree_id", i, 0) : std::to_string(i + 1),
                 quality[i],
                 reasons[i],
                 std::isfinite(dbh[i]) ? dbh[i] / 100 : 0.2,
                 lo[i] / 100,
                 hi[i] / 100,
                 0,
                 {}};
    centres.emplace_back(x[i], y[i]);
    reach.push_back(reach_m(panels[i].dbh_m));
  }
  const StemGrid grid(centres, reach);
  const auto* passes = slice.has(arrays::pass) ? &slice.values<std::int32_t>(arrays::pass) : nullptr;
  for (std::size_t k = 0; k < slice.size(); ++k) {
    const Eigen::Vector2d p = slice.position(k).head<2>();
    grid.near(p, [&](std::size_t i) {
      panels[i].points.push_back({(p - centres[i]).cast<float>(), passes != nullptr ? (*passes)[k] : 0});
    });
  }
  for (auto& panel : panels) {
    panel.found = panel.points.size();
    const auto most = static_cast<std::size_t>(max_points);
    if (panel.found <= most) continue;
    for (std::size_t k = 0; k < most; ++k) panel.points[k] = panel.points[k * panel.found / most];
    panel.points.resize(most);
  }
  return panels;
}

void draw_points(Canvas& canvas, const Panel& panel, const Eigen::Vector2d& centre, double mm_per_m) {
  std::map<int, std::vector<Eigen::Vector2d>> by_pass;
  for (const auto& p : panel.points)
    by_pass[p.pass].emplace_back(centre.x() + p.offset.x() * mm_per_m, centre.y() - p.offset.y() * mm_per_m);
  // A dozen colours that tell passes of one tree apart; the same pass has the same colour on every tree.
  for (const auto& [pass, dots] : by_pass)
    canvas.dots(dots, panel.points.size() < 300 ? 0.5 : 0.36,
                by_pass.size() > 1 ? id_color(pass + 1) : ink::primary.with_alpha(0.7));
}

void draw_panel(Canvas& canvas, const Panel& panel, const Box& box) {
  const Color color = quality_color(panel.quality);
  const Box head{box.x0, box.y0, box.x1, box.y0 + header_mm},
      body{box.x0, box.y0 + header_mm, box.x1, box.y1 - footer_mm};
  canvas.rectangle(head, mix(ink::paper, color, 0.14));
  canvas.rectangle({head.x0, head.y0, head.x0 + 1.1, head.y1}, color);
  canvas.text({head.x0 + 2.2, head.centre().y()}, panel.id,
              TextStyle{8, ink::text, true}.aligned(HAlign::left, VAlign::middle));
  canvas.text({head.x1 - 1.2, head.centre().y()}, panel.quality,
              TextStyle{6.5, mix(color, ink::text, 0.25)}.aligned(HAlign::right, VAlign::middle));

  const double side = std::min(body.width(), body.height()) - 1, reach = reach_m(panel.dbh_m),
               mm_per_m = side / 2 / reach;
  const Eigen::Vector2d centre = body.centre();
  {
    const auto clip = canvas.clip(body);
    draw_points(canvas, panel, centre, mm_per_m);
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
  const auto panels = std::make_shared<const std::vector<Panel>>(panels_of(stems, slice, options.max_points));
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
        draw_panel(canvas, (*panels)[page[i]], {x, y, x + side, y + height});
      }
    };
    pages.push_back(std::move(figure));
  }
  return pages;
}

}  // namespace bole::render
