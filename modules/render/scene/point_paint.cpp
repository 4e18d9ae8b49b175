#include "render/scene/point_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bole::render {
namespace {

constexpr std::size_t sampled = 50'000;  // values that percentiles are taken of
constexpr std::size_t map_steps = 1024;

bool is_id(std::string_view name) {
  constexpr std::array ids{"tree_id", "pass", "keyframe", "classification", "point_source_id", "stem", "plant", "part"};
  return std::ranges::find(ids, name) != ids.end();
}

const ColorMap& map_for(std::string_view array) {
  return array == "intensity" || array == "time" ? ColorMap::cividis() : ColorMap::viridis();
}

std::string title_of(std::string_view array) {
  std::string title(array);
  std::ranges::replace(title, '_', ' ');
  const auto* info = find_array(array);
  const auto unit = array == "z" ? std::string_view("m") : info != nullptr ? unit_symbol(info->unit) : "";
  return unit.empty() ? title : title + " (" + std::string(unit) + ")";
}

double value_at(const PointCloud& cloud, const Column* column, std::size_t i) {
  return column != nullptr ? column_value(*column, i) : cloud.position(i).z();
}

Interval percentiles(const PointCloud& cloud, const Column* column, double low, double high) {
  std::vector<double> values;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / sampled);
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (const double v = value_at(cloud, column, i); std::isfinite(v)) values.push_back(v);
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const auto at = [&](double q) {
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
  };
  Interval range{at(low), at(high)};
  if (!(range.length() > 1e-6)) range.hi = range.lo + 1;
  return range;
}

std::uint8_t byte(double v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0))); }

void put(const Color& c, std::uint8_t* rgb) { rgb[0] = byte(c.r), rgb[1] = byte(c.g), rgb[2] = byte(c.b); }

// The map as a table: mixing anchors for every point would take longer than drawing it.
std::vector<std::array<std::uint8_t, 3>> table_of(const ColorMap& map) {
  std::vector<std::array<std::uint8_t, 3>> table(map_steps);
  for (std::size_t k = 0; k < map_steps; ++k)
    put(map.at(static_cast<double>(k) / static_cast<double>(map_steps - 1)), table[k].data());
  return table;
}

void paint_numbers(const PointCloud& cloud, std::span<const std::uint32_t> indices, const PointPaint& paint,
                   std::uint8_t* rgb) {
  const auto* column = cloud.has(paint.array) ? &cloud.column(paint.array) : nullptr;
  const auto table = table_of(*paint.map);
  for (const auto i : indices) {
    const double value = value_at(cloud, column, i);
    if (!std::isfinite(value)) {
      put(paint.map->at(std::nan("")), rgb);
    } else {
      const double t = std::clamp((value - paint.range.lo) / paint.range.length(), 0.0, 1.0);
      const auto& c = table[static_cast<std::size_t>(t * static_cast<double>(map_steps - 1))];
      std::copy(c.begin(), c.end(), rgb);
      const double plant = (value - ground_below_m) / (plants_above_m - ground_below_m);
      if (paint.quiet_ground && plant < 1)
        put(mix(ground_grey, {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0}, std::max(plant, 0.0)), rgb);
    }
    rgb += 3;
  }
}

void paint_photo(const PointCloud& cloud, std::span<const std::uint32_t> indices, std::uint8_t* rgb) {
  const Column* bands[] = {&cloud.column("red"), &cloud.column("green"), &cloud.column("blue")};
  for (const auto i : indices)
    for (const auto* band : bands) *rgb++ = static_cast<std::uint8_t>(static_cast<int>(column_value(*band, i)) >> 8);
}

}  // namespace

std::vector<std::string> paintable_arrays(const PointCloud& cloud) {
  std::vector<std::string> names;
  for (const auto* first : {"height_above_ground", "tree_id"})
    if (cloud.has(first)) names.emplace_back(first);
  names.emplace_back("z");
  if (cloud.has("red") && cloud.has("green") && cloud.has("blue")) names.emplace_back("photo");
  for (const auto& info : array_vocabulary())
    if (cloud.has(info) && std::ranges::find(names, info.name) == names.end()) names.emplace_back(info.name);
  for (const auto& [name, column] : cloud.columns())
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

PointPaint paint_by(const PointCloud& cloud, const std::string& array) {
  PointPaint paint;
  paint.array = array;
  if (array == "photo" && cloud.has("red") && cloud.has("green") && cloud.has("blue")) {
    paint.kind = PointPaint::Kind::photo;
    return paint;
  }
  if (!cloud.has(array)) paint.array = "z";
  paint.title = title_of(paint.array);
  if (is_id(paint.array)) {
    paint.kind = PointPaint::Kind::ids;
    return paint;
  }
  const auto* column = paint.array == "z" ? nullptr : &cloud.column(paint.array);
  paint.kind = PointPaint::Kind::map;
  paint.map = &map_for(paint.array);
  paint.quiet_ground = paint.array == arrays::height_above_ground.name;
  paint.range = percentiles(cloud, column, 0.02, paint.quiet_ground ? 0.995 : 0.98);
  if (paint.quiet_ground) paint.range.lo = 0, paint.range.hi = std::max(paint.range.hi, 1.0);
  return paint;
}

void paint_points(const PointCloud& cloud, std::span<const std::uint32_t> indices, const PointPaint& paint,
                  std::uint8_t* rgb) {
  switch (paint.kind) {
    case PointPaint::Kind::map:
      return paint_numbers(cloud, indices, paint, rgb);
    case PointPaint::Kind::photo:
      return paint_photo(cloud, indices, rgb);
    case PointPaint::Kind::ids: {
      const auto& column = cloud.column(paint.array);
      for (const auto i : indices) {
        const auto id = static_cast<std::int64_t>(column_value(column, i));
        // Ids of passes and the like begin at 0; tree 0 is none.
        put(paint.array == arrays::tree_id.name ? id > 0 ? id_color(id) : ground_grey : id_color(id + 1), rgb);
        rgb += 3;
      }
      return;
    }
    case PointPaint::Kind::plain:
      for (std::size_t k = 0; k < indices.size(); ++k) put(paint.color, rgb + 3 * k);
  }
}

}  // namespace bole::render
