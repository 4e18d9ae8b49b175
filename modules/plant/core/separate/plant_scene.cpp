#include "plant/core/separate/plant_scene.h"

#include <charconv>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "base/option.h"
#include "base/transform.h"

namespace bole::plant {
namespace {

std::string text_of(const Eigen::Vector3d& v) {
  return number_text(v.x()) + " " + number_text(v.y()) + " " + number_text(v.z());
}

const std::string& text_in(const Facts& facts, std::string_view key) {
  const auto it = facts.find(key);
  if (it == facts.end())
    throw bad_input("the points have no fact '" + std::string(key) + "'", "points of plant.separate",
                    "connect the output 'points' of a stage plant.separate");
  return it->second;
}

std::vector<double> numbers_in(const Facts& facts, std::string_view key, std::size_t count) {
  const auto& text = text_in(facts, key);
  std::vector<double> out;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end && out.size() < count) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc{} || !std::isfinite(value)) break;
    out.push_back(value);
    at = read.ptr;
    while (at < end && *at == ' ') ++at;
  }
  if (out.size() != count || at != end)
    throw bad_input("the fact '" + std::string(key) + "' of the points is '" + text + "'",
                    std::to_string(count) + " numbers");
  return out;
}

double number_in(const Facts& facts, std::string_view key) { return numbers_in(facts, key, 1)[0]; }

Eigen::Vector3d vector_in(const Facts& facts, std::string_view key) {
  const auto v = numbers_in(facts, key, 3);
  return {v[0], v[1], v[2]};
}

}  // namespace

double PlantScene::soil_height_at(const Eigen::Vector3d& place) const {
  const double h = up.dot(place);
  const double slope = soil_normal.dot(up);
  // place + t * up lies in the plane.
  return h + (soil_offset - soil_normal.dot(place)) / slope;
}

void put_scene(Facts& facts, const PlantScene& s) {
  facts["plant_up"] = text_of(s.up);
  facts["plant_up_source"] = s.up_source;
  facts["plant_scale"] = s.scale_known ? "known" : "unknown";
  facts["plant_soil_source"] = s.soil_source;
  facts["plant_soil_normal"] = text_of(s.soil_normal);
  facts["plant_soil_offset_m"] = number_text(s.soil_offset);
  facts["plant_soil_sd_m"] = number_text(s.soil_sd);
  facts["plant_base_m"] = text_of(s.base);
  facts["plant_base_sd_m"] = number_text(s.base_sd);
  facts["plant_base_source"] = s.base_source;
  facts["plant_pot_rim_m"] = text_of(s.pot_rim);
  facts["plant_pot_foot_m"] = text_of(s.pot_foot);
  facts["plant_rim_radius_m"] = number_text(s.rim_radius);
  facts["plant_foot_radius_m"] = number_text(s.foot_radius);
  if (s.table_height) {
    facts["plant_table_height_m"] = number_text(*s.table_height);
  } else {
    facts.erase("plant_table_height_m");
  }
}

PlantScene scene_of(const Facts& facts) {
  PlantScene s;
  s.up = vector_in(facts, "plant_up");
  s.soil_normal = vector_in(facts, "plant_soil_normal");
  if (!(std::abs(s.up.norm() - 1) < 1e-3) || !(std::abs(s.soil_normal.norm() - 1) < 1e-3) ||
      !(s.up.dot(s.soil_normal) > 0.1))
    throw bad_input("the facts of the points give an up direction and a soil that do not fit",
                    "directions of length 1, the soil roughly level", "run plant.separate again");
  s.up.normalize();
  s.soil_normal.normalize();
  s.up_source = text_in(facts, "plant_up_source");
  s.scale_known = text_in(facts, "plant_scale") == "known";
  s.soil_source = text_in(facts, "plant_soil_source");
  s.soil_offset = number_in(facts, "plant_soil_offset_m");
  s.soil_sd = number_in(facts, "plant_soil_sd_m");
  s.base = vector_in(facts, "plant_base_m");
  s.base_sd = number_in(facts, "plant_base_sd_m");
  s.base_source = text_in(facts, "plant_base_source");
  s.pot_rim = vector_in(facts, "plant_pot_rim_m");
  s.pot_foot = vector_in(facts, "plant_pot_foot_m");
  s.rim_radius = number_in(facts, "plant_rim_radius_m");
  s.foot_radius = number_in(facts, "plant_foot_radius_m");
  if (facts.contains("plant_table_height_m")) s.table_height = number_in(facts, "plant_table_height_m");
  return s;
}

Eigen::Matrix3d levelling(const Eigen::Vector3d& up) { return rotation_between(up, Eigen::Vector3d::UnitZ()); }

}  // namespace bole::plant
