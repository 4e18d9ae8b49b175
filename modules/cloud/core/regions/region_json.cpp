#include "cloud/core/regions/region_json.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr std::size_t max_corners = 10'000, max_path = 10'000;
constexpr double min_size_m = 1e-4, max_size_m = 1e5;

std::vector<Eigen::Vector3d> places_in(const EditJson& value, const std::string& key, std::size_t least,
                                       std::size_t most) {
  std::vector<Eigen::Vector3d> out;
  for (const auto& place : edit_list(value, key, least)) out.push_back(edit_place_3d(place, key));
  if (out.size() > most)
    throw bad_input(key + " has " + std::to_string(out.size()) + " places", "at most " + std::to_string(most));
  return out;
}

PointRegion drawn_in(const EditJson& object) {
  auto region = outline_in(object);
  if (object.contains("depth_m")) {
    const auto& depth = edit_list(object["depth_m"], "depth_m", 2);
    region.depth = Eigen::Vector2d(edit_number(depth[0], "depth_m", -max_size_m, max_size_m),
                                   edit_number(depth[1], "depth_m", -max_size_m, max_size_m));
    if (depth.size() > 2 || region.depth->x() > region.depth->y())
      throw bad_input("depth_m is " + depth.dump(), "[least, most] in metres");
  }
  const RegionTest test(region);
  if (test.flat()) throw bad_input("the corners of the outline lie on one line", "an outline around points");
  if (test.crosses_itself()) throw bad_input("the outline crosses itself", "sides that do not meet", "Draw it again");
  return region;
}

PointRegion box_of(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::box;
  const auto centre = edit_place_3d(object["centre"], "centre");
  const auto& sizes = edit_list(object["size_m"], "size_m", 3);
  Eigen::Vector3d half;
  for (int k = 0; k < 3; ++k)
    half[k] = edit_number(sizes[static_cast<std::size_t>(k)], "size_m", min_size_m, max_size_m) / 2;
  region.min = centre - half;
  region.max = centre + half;
  if (object.contains("turn_deg")) region.turn_deg = edit_number(object["turn_deg"], "turn_deg", -360, 360);
  return region;
}

PointRegion brush_of(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::brush;
  region.path = places_in(object["path"], "path", 1, max_path);
  region.radius = edit_number(object["radius_m"], "radius_m", min_size_m, max_size_m);
  return region;
}

// How many of the keys there are.
int count_of(const EditJson& object, std::initializer_list<const char*> keys) {
  int n = 0;
  for (const auto* key : keys) n += object.contains(key) ? 1 : 0;
  return n;
}

}  // namespace

Eigen::Vector3d edit_place_3d(const EditJson& value, const std::string& key) {
  const auto& list = edit_list(value, key, 3);
  if (list.size() != 3) throw bad_input(key + " has " + value.dump(), "[x, y, z] in metres");
  Eigen::Vector3d out;
  for (int k = 0; k < 3; ++k) out[k] = edit_number(list[static_cast<std::size_t>(k)], key, -1e8, 1e8);
  return out;
}

EditJson edit_json(const Eigen::Vector3d& place) { return EditJson::array({place.x(), place.y(), place.z()}); }

PointRegion outline_in(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::outline;
  region.outline = places_in(object["outline"], "outline", 3, max_corners);
  if (object.contains("eye")) region.eye = edit_place_3d(object["eye"], "eye");
  return region;
}

PointRegion region_in(const EditJson& object) {
  const int outline = count_of(object, {"outline"}), of_outline = count_of(object, {"eye", "depth_m"}),
            box = count_of(object, {"centre", "size_m"}), of_box = count_of(object, {"turn_deg"}),
            brush = count_of(object, {"path", "radius_m"});
  const bool drawn = outline == 1 && box + of_box + brush == 0, boxed = box == 2 && outline + of_outline + brush == 0,
             brushed = brush == 2 && outline + of_outline + box + of_box == 0;
  if (!drawn && !boxed && !brushed)
    throw bad_input("the edit does not say which points",
                    "outline (with eye and depth_m where needed), or centre and size_m (and turn_deg), or path and "
                    "radius_m");
  auto region = drawn ? drawn_in(object) : boxed ? box_of(object) : brush_of(object);
  if (object.contains("within")) {
    const auto corners = places_in(object["within"], "within", 2, 2);
    region.within = Eigen::AlignedBox3d(corners[0], corners[1]);
    if (region.within->isEmpty())
      throw bad_input("within ends before it begins", "its lower corner first, in x, y and z");
  }
  return region;
}

void put_region(EditJson& object, const PointRegion& region) {
  const auto put = [&](const char* key, const std::vector<Eigen::Vector3d>& places) {
    object[key] = EditJson::array();
    for (const auto& place : places) object[key].push_back(edit_json(place));
  };
  if (region.kind == PointRegion::Kind::outline) {
    put("outline", region.outline);
    if (region.eye) object["eye"] = edit_json(*region.eye);
    if (region.depth) object["depth_m"] = {region.depth->x(), region.depth->y()};
  } else if (region.kind == PointRegion::Kind::box) {
    object["centre"] = edit_json(Eigen::Vector3d((region.min + region.max) / 2));
    object["size_m"] = edit_json(Eigen::Vector3d(region.max - region.min));
    if (region.turn_deg != 0) object["turn_deg"] = region.turn_deg;
  } else {
    put("path", region.path);
    object["radius_m"] = region.radius;
  }
  if (region.within) put("within", {region.within->min(), region.within->max()});
}

}  // namespace cloud
}  // namespace bole
