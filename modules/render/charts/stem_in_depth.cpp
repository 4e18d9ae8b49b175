#include "render/charts/stem_in_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/no_number.h"
#include "base/statistics.h"
#include "camera/registered_depth.h"
#include "render/charts/columns.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr std::size_t min_rows = 8;
constexpr double trusted_share = 0.7;               // of the weights of the best view
constexpr double stem_reach_m = 0.015;              // of a depth from the stem's: nearer ones are taken for its own
constexpr double nearer_m = 0.05, farther_m = 0.2;  // than the stem: ends of the colours
constexpr double crop_widths = 9;                   // half of the crop, in widths of the stem
constexpr double beside_gap_mm = 3, bar_mm = 3, bar_room_mm = 15;
constexpr int min_picture_px = 400;
constexpr Color no_depth = hex(0xd5d9dc);

struct Crop {
  int x0 = 0, y0 = 0, width = 0, height = 0;
};

// A square around the edges, as far as the picture reaches.
Crop crop_of(const StemEdges& edges, int width, int height) {
  Eigen::Vector2d low = edges.left.front(), high = low;
  for (const auto* side : {&edges.left, &edges.right})
    for (const auto& p : *side) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d middle = (low + high) / 2;
  const double half = std::max({crop_widths * edges.width_px, (high - low).maxCoeff() / 2 + 2 * edges.width_px, 12.0});
  const auto clamped = [](double v, int most) { return std::clamp(static_cast<int>(std::lround(v)), 0, most); };
  Crop crop{clamped(middle.x() - half, width - 1), clamped(middle.y() - half, height - 1), 0, 0};
  crop.width = std::max(1, clamped(middle.x() + half, width) - crop.x0);
  crop.height = std::max(1, clamped(middle.y() + half, height) - crop.y0);
  return crop;
}

// Whole pixels stay whole: each becomes a square.
template <class ColorAt>
Image enlarged(const Crop& crop, const ColorAt& color_at) {
  const int times = std::max(1, min_picture_px / std::max(1, crop.width));
  Image out;
  out.width = crop.width * times;
  out.height = crop.height * times;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const Color c = color_at(crop.x0 + x / times, crop.y0 + y / times);
      for (const double v : {c.r, c.g, c.b}) out.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * v)));
      out.rgba.push_back(255);
    }
  return out;
}

bool on_stem(const DepthImage& depth, const Eigen::Vector2d& at, double distance_m) {
  const int x = static_cast<int>(std::lround(at.x())), y = static_cast<int>(std::lround(at.y()));
  return depth.contains(x, y) && depth.at(x, y) > 0 && std::abs(depth.at(x, y) - distance_m) < stem_reach_m;
}

double distance_of(const StemEdges& edges, const CameraModel& color, double diameter_m) {
  return std::abs(color.fx) * diameter_m / edges.width_px;
}

std::string words_of(const StemInDepth& found, double diameter_m) {
  if (found.seen == 0)
    return fmt::format("The stem of {:.1f} mm has no depth of its own in any of {} rows.", 1000 * diameter_m,
                       found.rows);
  return fmt::format(
      "In depth the stem is {:.1f} mm wide (median of {} rows; {} of {} show it), by its edges {:.1f} mm.",
      found.width_mm, found.seen, found.seen, found.rows, 1000 * diameter_m);
}

}  // namespace

std::optional<StemEdges> largest_stem(const Table& contours) {
  for (const char* column : {"view", "name", "left_x_px", "left_y_px", "right_x_px", "right_y_px", "weight"})
    if (!contours.has(column)) return {};
  const auto view = contours.integers("view");
  const auto left_x = contours.numbers("left_x_px"), left_y = contours.numbers("left_y_px"),
             right_x = contours.numbers("right_x_px"), right_y = contours.numbers("right_y_px"),
             weight = contours.numbers("weight");
  std::map<std::int64_t, StemEdges> of_view;
  std::map<std::int64_t, std::vector<double>> widths;
  std::map<std::int64_t, double> trust;
  for (std::size_t i = 0; i < contours.rows(); ++i) {
    const Eigen::Vector2d left(left_x[i], left_y[i]), right(right_x[i], right_y[i]);
    if (!left.allFinite() || !right.allFinite() || !(weight[i] > 0)) continue;
    auto& edges = of_view[view[i]];
    edges.view = view[i];
    edges.name = contours.text("name", i);
    edges.left.push_back(left);
    edges.right.push_back(right);
    widths[view[i]].push_back((right - left).norm());
    trust[view[i]] += weight[i];
  }
  // Edges of a leaf make a stem look wide; the fit gives them little weight.
  double most = 0;
  for (const auto& [v, t] : trust) most = std::max(most, t);
  std::optional<StemEdges> best;
  for (auto& [v, edges] : of_view) {
    edges.width_px = median(widths[v]);
    if (edges.left.size() < min_rows || trust[v] < trusted_share * most || !(edges.width_px > 0)) continue;
    if (!best || edges.width_px > best->width_px) best = edges;
  }
  return best;
}

StemInDepth stem_in_depth(const StemEdges& edges, const DepthImage& depth, const CameraModel& color,
                          double diameter_m) {
  const double distance_m = distance_of(edges, color, diameter_m);
  StemInDepth out;
  out.rows = edges.left.size();
  std::vector<double> widths_mm;
  for (std::size_t i = 0; i < edges.left.size(); ++i) {
    const Eigen::Vector2d middle = (edges.left[i] + edges.right[i]) / 2;
    if (!on_stem(depth, middle, distance_m)) continue;
    constexpr double step_px = 0.25;
    const Eigen::Vector2d way = step_px * (edges.right[i] - edges.left[i]).normalized();
    int steps = 0;
    for (const double side : {-1.0, 1.0})
      for (int k = 1; on_stem(depth, middle + side * k * way, distance_m); ++k) ++steps;
    widths_mm.push_back(1000 * steps * step_px * distance_m / std::abs(color.fx));
  }
  out.seen = widths_mm.size();
  out.width_mm = widths_mm.empty() ? no_number : median(std::move(widths_mm));
  return out;
}

Figure stem_in_depth_figure(const StemEdges& edges, const ColorImage& color, const DepthImage& depth,
                            const RgbdCamera& camera, double diameter_m, double width_mm) {
  const Pose T_color_depth = camera.depth ? camera.T_color_depth : Pose::Identity();
  const auto seen = registered_depth(depth, {}, camera.of_depth(), T_color_depth, camera.color);
  const auto crop = crop_of(edges, color.width, color.height);
  const double distance_m = distance_of(edges, camera.color, diameter_m);
  const Interval range{distance_m - nearer_m, distance_m + farther_m};
  const auto picture = enlarged(crop, [&](int x, int y) {
    return Color{color.at(x, y, 0) / 255.0, color.at(x, y, 1) / 255.0, color.at(x, y, 2) / 255.0};
  });
  const auto distances = enlarged(crop, [&](int x, int y) {
    const double z = seen.at(x, y);
    return z > 0 ? ColorMap::viridis().at((z - range.lo) / (range.hi - range.lo)) : no_depth;
  });
  const double side_mm = (width_mm - beside_gap_mm - bar_room_mm) / 2, mm_per_px = side_mm / crop.width;
  Figure figure;
  figure.name = "stem_in_depth";
  figure.title = "The stem in colour and in depth";
  figure.caption = fmt::format(
      "Left: view {} with the edges that were measured. Right: the same place as the depth camera shows it, with the "
      "same edges; grey has no depth. {}",
      edges.name, words_of(stem_in_depth(edges, seen, camera.color, diameter_m), diameter_m));
  figure.width_mm = width_mm;
  figure.height_mm = mm_per_px * crop.height;
  figure.vector = false;
  figure.draw = [=](Canvas& canvas) {
    const double height_mm = mm_per_px * crop.height;
    for (const auto& [image, left_mm] : {std::pair{&picture, 0.0}, {&distances, side_mm + beside_gap_mm}}) {
      canvas.image(*image, {left_mm, 0, left_mm + side_mm, height_mm});
      for (const auto* side : {&edges.left, &edges.right})
        for (const auto& p : *side)
          canvas.circle(Eigen::Vector2d(left_mm, 0) + mm_per_px * (p - Eigen::Vector2d(crop.x0 - 0.5, crop.y0 - 0.5)),
                        0.45, ink::accent);
    }
    const double bar_left_mm = 2 * side_mm + beside_gap_mm + 3;
    draw_color_bar(canvas, {bar_left_mm, 6, bar_left_mm + bar_mm, height_mm - 3}, ColorMap::viridis(), range, "metres");
  };
  return figure;
}

}  // namespace bole::render
