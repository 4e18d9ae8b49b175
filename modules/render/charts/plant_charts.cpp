#include "render/charts/plant_charts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/angles.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr std::int32_t plant_part = 1;
constexpr std::size_t max_plant_dots = 40000, max_other_dots = 10000;  // a vector figure with more opens slowly
constexpr double panel_gap_mm = 4;

struct PlantDot {
  Eigen::Vector3d at;
  Color color;
  bool plant = true;
};

struct Drawn {
  std::vector<PlantDot> dots;
  Eigen::AlignedBox3d extent;  // of the plant
};

std::vector<double> column_or(const PointCloud& cloud, const char* name, double otherwise) {
  std::vector<double> values(cloud.size(), otherwise);
  if (!cloud.has(name)) return values;
  const auto& column = cloud.column(name);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = column_value(column, i);
  return values;
}

Drawn gather(const PointCloud& cloud) {
  Drawn out;
  const auto part = column_or(cloud, "part", plant_part);
  const auto red = column_or(cloud, "red", 20000), green = column_or(cloud, "green", 30000),
             blue = column_or(cloud, "blue", 20000);
  const auto plants = static_cast<std::size_t>(std::ranges::count(part, static_cast<double>(plant_part)));
  const std::size_t plant_step = std::max<std::size_t>(1, plants / max_plant_dots),
                    other_step = std::max<std::size_t>(1, (cloud.size() - plants) / max_other_dots);
  std::size_t seen_plants = 0, seen_others = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool plant = part[i] == plant_part;
    if (plant) out.extent.extend(cloud.position(i));
    if (plant ? seen_plants++ % plant_step != 0 : seen_others++ % other_step != 0) continue;
    const Color color{red[i] / 65535, green[i] / 65535, blue[i] / 65535};
    out.dots.push_back({cloud.position(i), plant ? color : mix(ink::paper, color, 0.35), plant});
  }
  return out;
}

// Values of the one row of traits; NaN where a column is absent.
struct Traits {
  double height = 0, height_lo = 0, height_hi = 0, length = 0, width = 0, stem = 0, stem_height = 0;
  Eigen::Vector3d base;
  Eigen::Vector2d centre;
  double angle = 0;
};

Traits traits_of(const Table& table) {
  const auto value = [&](const char* name, double factor = 1e-3) {
    const auto values = numbers_or_nan(table, name);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.front() * factor;
  };
  Traits t;
  t.height = value("height_mm"), t.height_lo = value("height_lo_mm"), t.height_hi = value("height_hi_mm");
  t.length = value("breadth_length_mm"), t.width = value("breadth_width_mm");
  t.stem = value("stem_diameter_mm"), t.stem_height = value("stem_height_mm");
  t.base = {value("base_x_m", 1), value("base_y_m", 1), value("base_z_m", 1)};
  t.centre = {value("breadth_x_m", 1), value("breadth_y_m", 1)};
  t.angle = value("breadth_angle_deg", rad_per_deg);
  return t;
}

void draw_plant_dots(Canvas& canvas, const Frame& frame, const Drawn& drawn, int vertical_axis) {
  auto order = drawn.dots;
  const int depth_axis = vertical_axis == 2 ? 1 : 2;
  // What is nearer to the eye is drawn later: above in the plan, to the front from the side.
  std::ranges::stable_sort(order, [&](const PlantDot& a, const PlantDot& b) {
    return vertical_axis == 2 ? a.at[depth_axis] > b.at[depth_axis] : a.at[depth_axis] < b.at[depth_axis];
  });
  for (const auto& dot : order) canvas.dots(std::array{frame.map(dot.at.x(), dot.at[vertical_axis])}, 0.35, dot.color);
}

// Corners of the rectangle around the plant in plan; none where it was not measured.
std::vector<Eigen::Vector2d> corners_of(const Traits& t) {
  std::vector<Eigen::Vector2d> corners;
  if (!t.centre.allFinite() || !std::isfinite(t.angle + t.length + t.width)) return corners;
  const Eigen::Vector2d along(std::cos(t.angle), std::sin(t.angle)), across(-along.y(), along.x());
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners.emplace_back(t.centre + a * t.length / 2 * along + b * t.width / 2 * across);
  return corners;
}

void draw_rectangle(Canvas& canvas, const Frame& frame, const Traits& t) {
  auto corners = corners_of(t);
  for (auto& p : corners) p = frame.map(p.x(), p.y());
  if (!corners.empty()) canvas.polygon(corners, {}, Stroke{ink::accent, 0.4});
}

void label(Canvas& canvas, const Eigen::Vector2d& at, const std::string& text, HAlign h) {
  TextStyle style{7, ink::accent};
  style.halo_mm = 0.5;
  canvas.text(at, text, style.aligned(h, VAlign::middle));
}

std::string millimetres(double metres, int decimals) { return fixed(1000 * metres, decimals) + " mm"; }

void draw_plant_heights(Canvas& canvas, const Frame& frame, const Traits& t) {
  if (!t.base.allFinite()) return;
  const Stroke line{ink::accent, 0.3, {1.4, 0.8}};
  if (std::isfinite(t.height)) {
    for (const double z : {t.base.z(), t.base.z() + t.height})
      canvas.line(frame.map(frame.x.lo, z), frame.map(frame.x.hi, z), line);
    label(canvas, frame.map(frame.x.hi, t.base.z() + t.height) + Eigen::Vector2d(-1, 2.4), millimetres(t.height, 1),
          HAlign::right);
  }
  if (std::isfinite(t.stem) && std::isfinite(t.stem_height)) {
    const double z = t.base.z() + t.stem_height;
    canvas.line(frame.map(t.base.x() - 0.03, z), frame.map(t.base.x() + 0.03, z), Stroke{ink::accent, 0.3});
    label(canvas, frame.map(t.base.x() + 0.033, z), millimetres(t.stem, 2), HAlign::left);
  }
}

}  // namespace

Figure plant_drawing(const PlantDrawing& data, double width_mm) {
  const Drawn drawn = gather(*data.points);
  const Traits traits = data.traits != nullptr ? traits_of(*data.traits) : traits_of(Table{});
  Eigen::AlignedBox3d extent = drawn.extent;
  if (extent.isEmpty()) extent = Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.1));
  if (traits.base.allFinite()) extent.extend(traits.base - Eigen::Vector3d(0, 0, 0.03));
  for (const auto& p : corners_of(traits)) extent.extend(Eigen::Vector3d(p.x(), p.y(), extent.center().z()));
  const double reach = 0.55 * std::max({extent.sizes().x(), extent.sizes().y(), 0.05});
  const double panel_mm = (width_mm - 2 * axis_space_left_mm - panel_gap_mm - 4) / 2;
  const double scale = panel_mm / (2 * reach);  // millimetres of paper per metre
  const double margin = 0.06 * extent.sizes().z() + 0.005;
  const Interval z{extent.min().z() - margin, extent.max().z() + margin};
  const double side_mm = std::min(z.length() * scale, 2.4 * panel_mm);
  Figure figure;
  figure.name = "plant";
  figure.title = "Plant from above and from the side";
  figure.caption =
      "Points of the plant in their colours, of other things pale; metres. Red: the smallest rectangle around the "
      "plant "
      "in plan, the soil and the top, and where the stem was measured.";
  figure.width_mm = width_mm;
  figure.height_mm = std::max(panel_mm, side_mm) + axis_space_below_mm + 4;
  const Eigen::Vector3d centre = extent.center();
  figure.draw = [drawn, traits, reach, panel_mm, side_mm, z, centre](Canvas& canvas) {
    const Interval x{centre.x() - reach, centre.x() + reach}, y{centre.y() - reach, centre.y() + reach};
    // Both stand on one line.
    const double foot = canvas.height_mm() - axis_space_below_mm - 2;
    const Frame plan{{axis_space_left_mm, foot - panel_mm, axis_space_left_mm + panel_mm, foot}, x, y};
    const double left = 2 * axis_space_left_mm + panel_mm + panel_gap_mm;
    const Frame side{{left, foot - side_mm, left + panel_mm, foot}, x, z};
    for (const auto& [frame, axis, name] : {std::tuple{plan, 1, "y (m)"}, {side, 2, "z (m)"}}) {
      AxesStyle axes{"x (m)", name};
      axes.x_ticks = axes.y_ticks = 4;
      draw_grid(canvas, frame, axes);
      {
        const auto clip = canvas.clip(frame.box);
        draw_plant_dots(canvas, frame, drawn, axis);
        if (axis == 1)
          draw_rectangle(canvas, frame, traits);
        else
          draw_plant_heights(canvas, frame, traits);
      }
      if (axis == 1 && std::isfinite(traits.length + traits.width))
        label(canvas, {frame.box.x0 + 1, frame.box.y0 + 3},
              millimetres(traits.length, 1) + " × " + millimetres(traits.width, 1), HAlign::left);
      draw_axes(canvas, frame, axes);
    }
  };
  return figure;
}

namespace {

struct StemRows {
  std::vector<double> height, diameter, lo, hi;
  std::vector<char> seen;

  explicit StemRows(const Table& stem) {
    const auto h = numbers_or_nan(stem, "height_mm"), d = numbers_or_nan(stem, "diameter_mm"),
               low = numbers_or_nan(stem, "diameter_lo_mm"), high = numbers_or_nan(stem, "diameter_hi_mm");
    const auto source = texts_or_empty(stem, "source");
    for (std::size_t i = 0; i < h.size(); ++i) {
      if (!std::isfinite(h[i] + d[i])) continue;
      height.push_back(h[i]), diameter.push_back(d[i]), seen.push_back(source[i] != "between");
      lo.push_back(std::isfinite(low[i]) ? low[i] : d[i]), hi.push_back(std::isfinite(high[i]) ? high[i] : d[i]);
    }
  }
  std::vector<Eigen::Vector2d> band(const Frame& frame) const {
    std::vector<Eigen::Vector2d> outline;
    for (std::size_t i = 0; i < height.size(); ++i) outline.push_back(frame.map(height[i], hi[i]));
    for (std::size_t i = height.size(); i-- > 0;) outline.push_back(frame.map(height[i], lo[i]));
    return outline;
  }
};

}  // namespace

Figure stem_chart(const Table& stem, double width_mm) {
  Figure figure;
  figure.name = "stem";
  figure.title = "Diameter of the stem";
  figure.caption =
      "Diameter of the main stem by the height above the soil, from its edges in the pictures, with the 95 % interval. "
      "Dashed: between places that were seen; nothing is drawn where leaves hide the stem.";
  figure.width_mm = width_mm;
  figure.height_mm = 0.5 * width_mm;
  figure.draw = [rows = StemRows(stem)](Canvas& canvas) {
    Interval x{0, 10}, y{0, 1};
    for (std::size_t i = 0; i < rows.height.size(); ++i)
      x.hi = std::max(x.hi, rows.height[i]), y.hi = std::max(y.hi, rows.hi[i]);
    const Frame frame{{axis_space_left_mm, 2, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm},
                      nice_interval(x, 6),
                      nice_interval(y, 5)};
    const AxesStyle axes{"Height above the soil (mm)", "Diameter (mm)"};
    draw_grid(canvas, frame, axes);
    if (rows.height.size() > 1) canvas.polygon(rows.band(frame), ink::primary.with_alpha(0.2));
    for (std::size_t i = 1; i < rows.height.size(); ++i) {
      Stroke line{ink::primary, 0.4};
      if (rows.seen[i - 1] == 0 || rows.seen[i] == 0) line.dash_mm = {1, 1};
      canvas.polyline(
          std::vector{frame.map(rows.height[i - 1], rows.diameter[i - 1]), frame.map(rows.height[i], rows.diameter[i])},
          line);
    }
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

Figure held_out_chart(const Table& held_out, double width_mm) {
  const auto view = numbers_or_nan(held_out, "view"), psnr = numbers_or_nan(held_out, "psnr_db");
  Figure figure;
  figure.name = "held_out";
  figure.title = "Views that were held out";
  figure.caption = "Peak signal-to-noise ratio between each view that the field was not made from and its rendering.";
  figure.width_mm = width_mm;
  figure.height_mm = 0.5 * width_mm;
  figure.draw = [view, psnr](Canvas& canvas) {
    Interval x{0, 1}, y{20, 30};
    for (std::size_t i = 0; i < view.size(); ++i)
      if (std::isfinite(view[i] + psnr[i]))
        x.hi = std::max(x.hi, view[i]), y = {std::min(y.lo, psnr[i]), std::max(y.hi, psnr[i])};
    const Frame frame{{axis_space_left_mm, 2, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm},
                      nice_interval(x.grown(0.02), 6),
                      nice_interval(y, 5)};
    const AxesStyle axes{"View", "PSNR (dB)"};
    draw_grid(canvas, frame, axes);
    for (std::size_t i = 0; i < view.size(); ++i)
      if (std::isfinite(view[i] + psnr[i])) canvas.circle(frame.map(view[i], psnr[i]), 0.8, ink::primary);
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

Figure training_chart(const Table& progress, double width_mm) {
  const auto step = numbers_or_nan(progress, "step"), psnr = numbers_or_nan(progress, "psnr_db");
  Figure figure;
  figure.name = "training";
  figure.title = "Making of the field";
  figure.caption = "Peak signal-to-noise ratio of the pixels drawn at each step.";
  figure.width_mm = width_mm;
  figure.height_mm = 0.5 * width_mm;
  figure.draw = [step, psnr](Canvas& canvas) {
    Interval x{0, 1}, y{15, 30};
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < step.size(); ++i)
      if (std::isfinite(step[i] + psnr[i])) {
        x.hi = std::max(x.hi, step[i]);
        y = {std::min(y.lo, psnr[i]), std::max(y.hi, psnr[i])};
        points.emplace_back(step[i], psnr[i]);
      }
    const Frame frame{{axis_space_left_mm, 2, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm},
                      nice_interval(x, 6),
                      nice_interval(y, 5)};
    const AxesStyle axes{"Step", "PSNR (dB)"};
    draw_grid(canvas, frame, axes);
    for (auto& p : points) p = frame.map(p.x(), p.y());
    canvas.polyline(points, Stroke{ink::primary, 0.4});
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

}  // namespace bole::render
