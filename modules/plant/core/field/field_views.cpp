#include "plant/core/field/field_views.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "camera/registered_depth.h"

namespace bole::plant {
namespace {

// Mean of n x n pixels. Rows and columns that fill no whole pixel are left out.
ColorImage smaller(const ColorImage& image, int n) {
  if (n == 1) return image;
  ColorImage out(image.width / n, image.height / n, image.channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (int c = 0; c < out.channels; ++c) {
        int sum = 0;
        for (int v = 0; v < n; ++v)
          for (int u = 0; u < n; ++u) sum += image.at(x * n + u, y * n + v, c);
        out.at(x, y, c) = static_cast<std::uint8_t>((sum + n * n / 2) / (n * n));
      }
  return out;
}

// The object wherever a pixel shows some of it.
MaskImage smaller_mask(const MaskImage& mask, int n) {
  MaskImage out(mask.width / n, mask.height / n, 1, 0);
  for (int y = 0; y < n * out.height; ++y)
    for (int x = 0; x < n * out.width; ++x)
      if (mask.at(x, y) != 0) out.at(x / n, y / n) = 255;
  return out;
}

// Colours that came with an alpha channel lie over white already, with edges that are right in parts of a pixel.
bool is_covered(const ColorImage& color, const MaskImage& mask, std::uint8_t value) {
  constexpr double enough = 0.95;
  std::size_t around = 0, covered = 0;
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    if (mask.values[i] != 0) continue;
    ++around;
    covered += color.values[3 * i] == value && color.values[3 * i + 1] == value && color.values[3 * i + 2] == value;
  }
  return static_cast<double>(covered) >= enough * static_cast<double>(around);
}

void cover_surroundings(ColorImage& color, const MaskImage& mask, std::uint8_t value) {
  if (is_covered(color, mask, value)) return;
  for (std::size_t i = 0; i < mask.values.size(); ++i)
    if (mask.values[i] == 0) std::fill_n(color.values.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, value);
}

CameraModel smaller(const CameraModel& camera, int n) {
  CameraModel out = camera;
  out.width = camera.width / n;
  out.height = camera.height / n;
  out.fx = camera.fx / n;
  out.fy = camera.fy / n;
  out.cx = (camera.cx + 0.5) / n - 0.5;
  out.cy = (camera.cy + 0.5) / n - 0.5;
  return out;
}

}  // namespace

std::vector<FieldView> load_field_views(const ViewSource& views, const std::vector<PosedView>& posed,
                                        const FieldViewOptions& options, const Run& run, Report& report) {
  bool split_given = false;
  for (const auto& p : posed) split_given = split_given || views.split(p.index) == "test";
  std::vector<FieldView> out;
  View view;
  std::optional<CameraModel> last_camera;
  std::shared_ptr<const PixelDirections> directions;
  int place = 0;
  for (const auto& p : posed) {
    run.check_cancel();
    run.report(static_cast<double>(place) / static_cast<double>(posed.size()), "reading views");
    views.read(p.index, view,
               {.color = true, .depth = options.depth && views.has_depth(), .mask = options.around_object.has_value()});
    if (view.color.empty() || view.color.channels != 3)
      throw bad_input("view " + views.name(p.index) + " has no colour image", "colour images with three channels");
    const auto& camera = views.camera(p.index);
    FieldView f;
    f.index = p.index;
    f.time_s = views.time_s(p.index);
    f.name = views.name(p.index);
    f.held_out = split_given ? views.split(p.index) == "test"
                             : options.hold_out > 0 && place % options.hold_out == options.hold_out / 2;
    const int n = std::max(1, static_cast<int>(std::lround(static_cast<double>(view.color.width) / options.max_width)));
    f.camera = smaller(camera.color, n);
    f.T_world_camera = p.T_world_camera;
    if (options.around_object && view.mask.width == view.color.width && view.mask.height == view.color.height) {
      cover_surroundings(view.color, view.mask, *options.around_object);
      f.mask = smaller_mask(view.mask, n);
    }
    f.color = smaller(view.color, n);
    if (!last_camera || !(*last_camera == f.camera)) directions = pixel_directions(f.camera);
    last_camera = f.camera;
    f.directions = directions;
    if (options.depth && !view.depth.empty())
      f.depth = registered_depth(view.depth, depth_edges(view.depth, options.noise, 3), camera.of_depth(),
                                 camera.T_color_depth, f.camera);
    out.push_back(std::move(f));
    ++place;
  }
  report.counts["held_out"] = std::ranges::count_if(out, &FieldView::held_out);
  return out;
}

}  // namespace bole::plant
