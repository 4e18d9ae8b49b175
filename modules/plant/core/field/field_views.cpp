#include "plant/core/field/field_views.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

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

DepthImage registered_depth(const DepthImage& depth, const MaskImage& left_out, const CameraModel& depth_camera,
                            const Pose& T_color_depth, const CameraModel& color_camera) {
  // Where the pixels of the depth image land. Those to be left out hide others all the same.
  DepthImage nearest_of(color_camera.width, color_camera.height, 1, 0.0F), landed = nearest_of, out = nearest_of;
  MaskImage keeps(color_camera.width, color_camera.height, 1, 255);
  Image<std::uint16_t> counts(color_camera.width, color_camera.height);
  struct Landing {
    std::size_t at = 0;
    float z = 0;
    bool keep = true;
  };
  std::vector<Landing> landings;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double z = depth.at(x, y);
      if (!(z > 0) || !std::isfinite(z)) continue;
      const Eigen::Vector3d p = T_color_depth * Eigen::Vector3d(depth_camera.direction({x, y}) * z);
      const auto pixel = color_camera.project(p);
      if (!pixel || !color_camera.contains(*pixel)) continue;
      const auto at =
          landed.index(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
      landings.push_back({at, static_cast<float>(p.z()), left_out.empty() || left_out.at(x, y) == 0});
      float& nearest = nearest_of.values[at];
      nearest = nearest > 0 ? std::min(nearest, landings.back().z) : landings.back().z;
    }
  // Of several depths in one pixel the mean: the nearest alone would be the one with the largest error.
  constexpr float same_surface = 1.03F;
  for (const auto& l : landings) {
    if (l.z > nearest_of.values[l.at] * same_surface) continue;
    landed.values[l.at] += l.z;
    ++counts.values[l.at];
    if (!l.keep) keeps.values[l.at] = 0;
  }
  for (std::size_t i = 0; i < landed.values.size(); ++i)
    if (counts.values[i] > 0) landed.values[i] /= static_cast<float>(counts.values[i]);
  // Pixels between those that were hit have the mean of their neighbours. What shines through between the pixels of a
  // nearer surface is dropped. Taking the nearest neighbour instead would pull slanted surfaces towards the camera.
  const double ratio = std::abs(color_camera.fx / depth_camera.fx);
  const int reach = std::clamp(static_cast<int>(std::ceil(ratio / 2)), 1, 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      float nearest = 0, sum = 0;
      int count = 0, kept = 0;
      const auto each = [&](auto visit) {
        for (int v = std::max(0, y - reach); v <= std::min(out.height - 1, y + reach); ++v)
          for (int u = std::max(0, x - reach); u <= std::min(out.width - 1, x + reach); ++u)
            if (landed.at(u, v) > 0) visit(landed.at(u, v), keeps.at(u, v));
      };
      each([&](float z, std::uint8_t) { nearest = nearest > 0 ? std::min(nearest, z) : z; });
      if (nearest <= 0) continue;
      const float limit = nearest * same_surface;
      const float own = landed.at(x, y);
      if (own > 0 && own <= limit) {
        out.at(x, y) = keeps.at(x, y) != 0 ? own : -own;
        continue;
      }
      if (own <= 0 && ratio <= 1.05) continue;  // a hole of the depth image itself
      each([&](float z, std::uint8_t keep) {
        if (z > limit) return;
        sum += z;
        ++count;
        kept += keep != 0;
      });
      const float mean = sum / static_cast<float>(count);
      out.at(x, y) = kept == count ? mean : -mean;
    }
  return out;
}

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
