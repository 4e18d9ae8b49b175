#include "render/scene/map_figure.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/angles.h"
#include "base/option.h"
#include "cloud/breast_height.h"
#include "render/draw/figure.h"
#include "render/draw/furniture.h"
#include "render/draw/shrink.h"
#include "render/scene/actors.h"
#include "render/scene/eye_dome.h"
#include "render/scene/thin.h"
#include "render/scene/view_camera.h"

namespace bole::render {
namespace {

constexpr double side_mm = 19;  // the legend's column

struct Extent {
  Eigen::Vector3d lo, hi;
  Eigen::Vector3d centre() const { return (lo + hi) / 2; }
};

struct View {
  Extent extent;
  std::vector<std::uint32_t> indices;  // what the view is aimed at
  std::vector<std::uint32_t> drawn;
  std::vector<StemShape> stems;
  PointColoring coloring;
  Box box;  // of the picture on the sheet
  double grid_step_m = 5;
};

Window window_of(const MapData& data) {
  Window w{Eigen::Vector2d::Constant(1e300), Eigen::Vector2d::Constant(-1e300)};
  const auto include = [&](double x, double y) {
    if (std::isfinite(x + y)) w.lo = w.lo.cwiseMin(Eigen::Vector2d(x, y)), w.hi = w.hi.cwiseMax(Eigen::Vector2d(x, y));
  };
  for (const auto& p : data.area.outline()) include(p.x(), p.y());
  if (data.stems != nullptr && data.area.shape == PlotArea::Shape::none) {
    const auto x = data.stems->numbers("x_m"), y = data.stems->numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) include(x[i], y[i]);
  }
  if (!((w.hi - w.lo).minCoeff() > 1)) return middle_window(*data.points);
  const double margin = 1 + 0.03 * (w.hi - w.lo).maxCoeff();
  return {w.lo.array() - margin, w.hi.array() + margin};
}

std::vector<StemShape> stems_within(const MapData& data, const Window& window) {
  if (data.stems == nullptr) return {};
  auto shapes = stem_shapes(*data.stems, data.sections);
  std::erase_if(shapes, [&](const StemShape& s) { return !window.contains(s.breast_height); });
  return shapes;
}

void thin_crowns(const PointCloud& cloud, double share, std::vector<std::uint32_t>& indices) {
  constexpr float crown_from_m = 4;
  if (!cloud.has(arrays::height_above_ground)) return;
  const auto& height = cloud.values<float>(arrays::height_above_ground);
  // Multiples of the golden ratio fall evenly: about `share` of them below `share`.
  std::erase_if(indices, [&](std::uint32_t i) {
    return height[i] > crown_from_m && std::fmod(0.6180339887498949 * i, 1) >= share;
  });
}

void cut_above(const PointCloud& cloud, double max_height_m, std::vector<std::uint32_t>& indices) {
  if (!cloud.has(arrays::height_above_ground) || !std::isfinite(max_height_m)) return;
  const auto& height = cloud.values<float>(arrays::height_above_ground);
  std::erase_if(indices, [&](std::uint32_t i) { return height[i] > max_height_m; });
}

// The stem up to a height above its foot.
void cut_above(double max_height_m, StemShape& stem) {
  const double top_z = stem.axis.front().z() + max_height_m;
  for (std::size_t i = 1; i < stem.axis.size(); ++i) {
    const auto &a = stem.axis[i - 1], &b = stem.axis[i];
    if (b.z() <= top_z) continue;
    const double t = std::clamp((top_z - a.z()) / std::max(b.z() - a.z(), 1e-9), 0.0, 1.0);
    stem.radius_m[i] = std::lerp(stem.radius_m[i - 1], stem.radius_m[i], t);
    stem.axis[i] = a + t * (b - a);
    stem.axis.resize(i + 1);
    stem.radius_m.resize(i + 1);
    return;
  }
}

Extent extent_of(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, const Window& window) {
  std::vector<float> z;
  const std::size_t step = std::max<std::size_t>(1, indices.size() / 50000);
  for (std::size_t k = 0; k < indices.size(); k += step)
    z.push_back(static_cast<float>(cloud.position(indices[k]).z()));
  if (z.empty()) z = {0, 1};
  std::sort(z.begin(), z.end());
  const auto cut = z.size() / 3000;
  return {{window.lo.x(), window.lo.y(), z[cut]}, {window.hi.x(), window.hi.y(), z[z.size() - 1 - cut]}};
}

// What must be seen: a sample of the points up to the top of the extent, and the corners of its floor.
std::vector<Eigen::Vector3d> outline_points(const PointCloud& cloud, const View& view, const Eigen::Vector3d& origin) {
  const auto& e = view.extent;
  std::vector<Eigen::Vector3d> points;
  for (const double x : {e.lo.x(), e.hi.x()})
    for (const double y : {e.lo.y(), e.hi.y()}) points.emplace_back(Eigen::Vector3d(x, y, e.lo.z()) - origin);
  const std::size_t step = std::max<std::size_t>(1, view.indices.size() / 20000);
  for (std::size_t k = 0; k < view.indices.size(); k += step)
    if (const auto p = cloud.position(view.indices[k]); p.z() >= e.lo.z() && p.z() <= e.hi.z())
      points.push_back(p - origin);
  return points;
}

double grid_step(const Extent& extent) {
  return nice_step(std::max(extent.hi.x() - extent.lo.x(), extent.hi.y() - extent.lo.y()), 8);
}

Color ground_color(const MapOptions& options) { return options.dark ? hex(0x11181d) : ink::paper; }

void add_actors(vtkRenderer* renderer, const MapData& data, const MapOptions& options, const View& view,
                const Eigen::Vector3d& origin, double point_px) {
  renderer->AddActor(points_actor(*data.points, view.drawn, view.coloring, origin, point_px));
  const auto& e = view.extent;
  if (options.view == MapView::oblique) {
    auto grid = grid_actor({e.lo.x(), e.hi.x()}, {e.lo.y(), e.hi.y()}, e.lo.z(), view.grid_step_m, origin,
                           options.dark ? hex(0x3b4750) : hex(0xb9c2c8));
    grid->GetProperty()->SetLineWidth(static_cast<float>(options.supersampling * options.dpi / 150));
    renderer->AddActor(grid);
  }
  // Marks keep a size on the picture, whatever the plot's.
  const double span_m = (e.hi - e.lo).head<2>().maxCoeff();
  if (!view.stems.empty()) {
    auto stems = stems_actor(view.stems, origin, false);
    if (options.view == MapView::top) stems->GetProperty()->LightingOff();  // seen along the light nothing is shaded
    renderer->AddActor(stems);
    renderer->AddActor(breast_height_actor(view.stems, origin, std::max(0.04, span_m / 250)));
  }
  if (options.walk && data.trajectory != nullptr && data.trajectory->poses.size() > 1)
    renderer->AddActor(path_actor(*data.trajectory, origin, std::max(0.035, span_m / 700),
                                  options.dark ? hex(0x7fd3ff) : ink::primary));
}

// How large a point must be to cover the gap to its neighbour.
double point_size_px(const View& view, double width_px) {
  const double span = std::max((view.extent.hi - view.extent.lo).head<2>().maxCoeff(), 1.0);
  const double density = std::sqrt(static_cast<double>(std::max<std::size_t>(view.indices.size(), 1))) /
                         span;  // per metre, as if on one plane
  return std::clamp(1.4 * width_px / span / density, 2.5, 10.0);
}

std::pair<Image, Projection> render(const MapData& data, const MapOptions& options, const View& view) {
  const int width = std::max(1, static_cast<int>(std::lround(view.box.width() / mm_per_inch * options.dpi))),
            height = std::max(1, static_cast<int>(std::lround(view.box.height() / mm_per_inch * options.dpi)));
  const int supersampling = options.supersampling;
  const Eigen::Vector3d origin = view.extent.centre();
  vtkNew<vtkRenderer> renderer;
  const Color ground = ground_color(options);
  renderer->SetBackground(ground.r, ground.g, ground.b);
  add_actors(renderer, data, options, view, origin, point_size_px(view, width * supersampling));
  auto* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d size = view.extent.hi - view.extent.lo;
  const double aspect = view.box.width() / view.box.height();
  if (options.view == MapView::top)
    aim_from_above(camera, Eigen::Vector3d::Zero(), size, aspect);
  else
    aim_obliquely(camera, Eigen::Vector3d::Zero(), size, aspect, outline_points(*data.points, view, origin),
                  options.from_azimuth_deg, options.elevation_deg);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * supersampling, height * supersampling);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> rgb;
  window->GetPixelData(0, 0, width * supersampling - 1, height * supersampling - 1, 0, rgb);
  Projection projection{view_matrix(camera, aspect), origin, view.box};
  EyeDomeOptions shading;
  shading.radius_px = 1.2 * supersampling * options.dpi / 150;
  shading.strength = options.view == MapView::top ? 0.45 : 0.62;
  shade_eye_dome({rgb->GetPointer(0), static_cast<std::size_t>(rgb->GetNumberOfValues())},
                 window_depths_m(window, renderer->GetActiveCamera()), width * supersampling, height * supersampling,
                 shading);
  return {
      shrunk({rgb->GetPointer(0), static_cast<std::size_t>(rgb->GetNumberOfValues())}, width, height, supersampling),
      projection};
}

// Of an oblique picture as wide as the box: less than the box has where the scene is flat.
double needed_height_mm(const PointCloud& cloud, const MapOptions& options, const View& view) {
  const double aspect = view.box.width() / view.box.height();
  const Eigen::Vector3d size = view.extent.hi - view.extent.lo;
  const auto outline = outline_points(cloud, view, view.extent.centre());
  vtkNew<vtkCamera> camera;
  aim_obliquely(camera, Eigen::Vector3d::Zero(), size, aspect, outline, options.from_azimuth_deg,
                options.elevation_deg);
  const Box seen = rectangle_on_view(view_matrix(camera, aspect), outline);
  return view.box.height() * std::clamp(1.04 * seen.height() / 2, 0.4, 1.0);
}

void round_colors(Image& image, int step) {
  if (step <= 1) return;
  for (auto& v : image.rgba) v = static_cast<std::uint8_t>(std::min(255, (v + step / 2) / step * step));
}

struct Drawing {
  Image picture;
  Projection projection;
  View view;
  MapOptions options;
  bool north_known = true, has_walk = false, has_stems = false;
  double breast_height_m = usual_breast_height_m;
};

void draw_grid_labels(Canvas& canvas, const Drawing& d) {
  const auto& e = d.view.extent;
  const double azimuth = radians(d.options.from_azimuth_deg);
  // The edges of the grid that face the viewer.
  const double front_y = std::cos(azimuth) < 0 ? e.lo.y() : e.hi.y(),
               front_x = std::sin(azimuth) < 0 ? e.lo.x() : e.hi.x();
  TextStyle style{6.5, d.options.dark ? hex(0x9fb0ba) : ink::muted};
  const auto label = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& inwards, double value) {
    const Eigen::Vector2d p = d.projection.map(at), out = (p - d.projection.map(inwards)).normalized();
    const Eigen::Vector2d q = p + 2.4 * out;
    if (canvas.sheet().grown(-1.5).contains(q))
      canvas.text(q, fixed(value, 0), style.aligned(HAlign::centre, VAlign::middle));
  };
  for (const double x : nice_ticks({e.lo.x(), e.hi.x()}, 8).at)
    if (std::abs(std::remainder(x, d.view.grid_step_m)) < 1e-6)
      label({x, front_y, e.lo.z()}, {x, e.centre().y(), e.lo.z()}, x);
  for (const double y : nice_ticks({e.lo.y(), e.hi.y()}, 8).at)
    if (std::abs(std::remainder(y, d.view.grid_step_m)) < 1e-6)
      label({front_x, y, e.lo.z()}, {e.centre().x(), y, e.lo.z()}, y);
}

// Seen from above the picture is a map with ordinary axes.
void draw_map_axes(Canvas& canvas, const Drawing& d) {
  const auto& e = d.view.extent;
  const Eigen::Vector2d a = d.projection.map(e.lo), b = d.projection.map(e.hi);
  AxesStyle axes{d.north_known ? "East (m)" : "x (m)", d.north_known ? "North (m)" : "y (m)", 8, 8};
  axes.frame = true;
  draw_axes(canvas, {{a.x(), b.y(), b.x(), a.y()}, {e.lo.x(), e.hi.x()}, {e.lo.y(), e.hi.y()}}, axes);
}

// The legend's column from top to bottom: colour bar, up to three entries, north arrow, scale bar.
constexpr double furniture_below_bar_mm = 54, min_bar_mm = 16, max_bar_mm = 36;

double bar_mm(double height_mm) { return std::clamp(height_mm - furniture_below_bar_mm, min_bar_mm, max_bar_mm); }

void draw_furniture(Canvas& canvas, const Drawing& d) {
  d.options.view == MapView::top ? draw_map_axes(canvas, d) : draw_grid_labels(canvas, d);
  const double x = canvas.width_mm() - side_mm + 3;
  const auto& c = d.view.coloring;
  double y = 8;
  if (c.by == PointColor::height || c.by == PointColor::intensity) {
    draw_color_bar(canvas, {x, y, x + 3, y + bar_mm(canvas.height_mm())},
                   c.by == PointColor::height ? ColorMap::viridis() : ColorMap::cividis(), c.range,
                   c.by == PointColor::height ? "Height (m)" : "Intensity");
    y += bar_mm(canvas.height_mm()) + 8;
  }
  std::vector<LegendEntry> entries;
  if (d.has_stems) {
    entries.push_back({Symbol::square, hex(0xe4572e), "fitted"});
    entries.push_back({Symbol::square, hex(0xffe066), number_text(d.breast_height_m) + " m"});
  }
  if (d.has_walk) entries.push_back({Symbol::line, ink::primary, "walk"});
  for (const auto& entry : entries) {
    draw_symbol(canvas, entry.symbol, {x + 1.5, y}, 2.2, entry.color);
    canvas.text({x + 4.2, y}, entry.text, TextStyle{7}.aligned(HAlign::left, VAlign::middle));
    y += 4.2;
  }
  const auto& p = d.projection;
  const Eigen::Vector3d foot(d.view.extent.centre().x(), d.view.extent.centre().y(), d.view.extent.lo.z());
  const Eigen::Vector2d north = p.map(foot + Eigen::Vector3d(0, 1, 0)) - p.map(foot);
  if (d.north_known) draw_north_arrow(canvas, {x + 4, canvas.height_mm() - 14}, 9, std::atan2(-north.x(), -north.y()));
  if (d.options.view == MapView::top)
    draw_scale_bar(canvas, {x - 1, canvas.height_mm() - 4}, north.norm(), 14);
  else
    canvas.text({x - 1, canvas.height_mm() - 4},
                "grid " + fixed(d.view.grid_step_m, d.view.grid_step_m < 1 ? 1 : 0) + " m", TextStyle{7});
}

std::string caption_of(const Drawing& d) {
  const char* by = d.view.coloring.by == PointColor::tree        ? "tree"
                   : d.view.coloring.by == PointColor::intensity ? "intensity"
                                                                 : "height above ground";
  return std::string(d.options.view == MapView::top ? "The map from above" : "The map seen obliquely") +
         ", points coloured by " + by +
         (d.has_stems ? ", with the fitted stems in place of the points on their bark" : "") +
         (d.has_walk ? " and the walk of the scanner" : "") +
         (std::isfinite(d.options.max_height_m)
              ? ", cut " + number_text(d.options.max_height_m) + " m above ground so that crowns hide nothing"
              : "") +
         "; coordinates in metres.";
}

}  // namespace

std::vector<std::uint32_t> map_window_points(const MapData& data, std::size_t budget, const Run& run) {
  if (data.points == nullptr || data.points->empty()) return {};
  return thin_for_drawing(*data.points, window_of(data), budget, run);
}

MapPoints choose_map_points(const MapData& data, std::size_t budget, const Run& run) {
  constexpr double bark_m = 0.035;  // thickness of what lies on a stem
  if (data.points == nullptr || data.points->empty()) throw bad_input("the map has no points", "a point cloud");
  const auto window = window_of(data);
  MapPoints chosen;
  chosen.all = thin_for_drawing(*data.points, window, budget, run);
  if (chosen.all.empty())
    throw bad_input("no point of the map lies in the window that is drawn", "points around the plot or the stems");
  chosen.off_stems = chosen.all;
  run.check_cancel();
  drop_points_on_stems(*data.points, stems_within(data, window), bark_m, chosen.off_stems);
  return chosen;
}

Figure map_figure(const MapData& data, const MapOptions& options, double width_mm) {
  auto drawing = std::make_shared<Drawing>();
  auto& view = drawing->view;
  if (data.points == nullptr || data.points->empty()) throw bad_input("the map has no points", "a point cloud");
  const auto window = window_of(data);
  const MapPoints chosen = data.chosen != nullptr ? *data.chosen : choose_map_points(data, options.point_budget);
  view.indices = chosen.all;
  view.drawn = options.stems ? chosen.off_stems : chosen.all;
  if (options.crown_share < 1) thin_crowns(*data.points, options.crown_share, view.drawn);
  cut_above(*data.points, options.max_height_m, view.indices);
  cut_above(*data.points, options.max_height_m, view.drawn);
  if (view.indices.empty()) throw bad_input("no point lies below the height of the cut", "a higher cut");
  if (options.stems) view.stems = stems_within(data, window);
  if (std::isfinite(options.max_height_m))
    for (auto& stem : view.stems) cut_above(options.max_height_m, stem);
  view.extent = extent_of(*data.points, view.indices, window);
  view.coloring = coloring_for(*data.points, view.indices, options.color);
  view.grid_step_m = grid_step(view.extent);
  const double picture_mm = width_mm - (options.furniture ? side_mm : 0);
  const Eigen::Vector3d size = view.extent.hi - view.extent.lo;
  const bool from_above = options.view == MapView::top;
  const double left_mm = from_above && options.furniture ? axis_space_left_mm : 0,
               below_mm = from_above && options.furniture ? axis_space_below_mm : 0,
               edge_mm = options.furniture ? 2 : 0;
  const double inner_mm = picture_mm - left_mm - edge_mm;
  const double inner_height_mm = from_above ? inner_mm * std::clamp(size.y() / size.x(), 0.3, 1.3) : 0.62 * picture_mm;
  view.box = {left_mm, edge_mm, left_mm + inner_mm, edge_mm + inner_height_mm};
  if (!from_above && options.furniture) view.box.y1 = edge_mm + needed_height_mm(*data.points, options, view);
  const double height_mm =
      std::max(view.box.y1 + below_mm + edge_mm, options.furniture ? furniture_below_bar_mm + min_bar_mm : 0.0);
  drawing->options = options;
  drawing->north_known = data.north_known;
  drawing->has_walk = options.walk && data.trajectory != nullptr && data.trajectory->poses.size() > 1;
  drawing->has_stems = !view.stems.empty();
  if (data.stems != nullptr) drawing->breast_height_m = breast_height_m(*data.stems);
  std::tie(drawing->picture, drawing->projection) = render(data, options, view);
  round_colors(drawing->picture, options.color_step);
  view.indices = {};
  view.drawn = {};
  view.stems = {};

  const char* color = view.coloring.by == PointColor::tree        ? "tree"
                      : view.coloring.by == PointColor::intensity ? "intensity"
                                                                  : "height";
  Figure figure{std::string(options.view == MapView::top ? "map_top_" : "map_") + color,
                std::string(options.view == MapView::top ? "Map from above by " : "Map by ") + color,
                caption_of(*drawing),
                width_mm,
                height_mm,
                false,
                {}};
  figure.draw = [drawing](Canvas& canvas) {
    canvas.rectangle(canvas.sheet(), ground_color(drawing->options));
    canvas.image(drawing->picture, drawing->view.box);
    if (drawing->options.furniture) draw_furniture(canvas, *drawing);
  };
  return figure;
}

Figure hero_figure(const MapData& data, double width_mm, double dpi) {
  MapOptions options;
  options.dark = true;
  options.furniture = false;
  options.elevation_deg = 17;
  options.crown_share = 0.6;
  options.color_step = 16;
  options.dpi = dpi;
  auto figure = map_figure(data, options, width_mm);
  figure.name = "hero";
  return figure;
}

}  // namespace bole::render
