#include "sim/core/field/field_recipe.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"
#include "base/resources.h"

namespace bole::sim {
namespace {

using Json = nlohmann::json;

// The entries of one object of the recipe; what was not asked for is unknown.
class Section {
 public:
  Section(const Json& parent, std::string name) : name_(std::move(name)) {
    if (name_.empty()) json_ = parent;
    if (!name_.empty() && parent.contains(name_)) json_ = parent[name_];
    if (!json_.is_null() && !json_.is_object()) throw bad_input(where() + "is " + json_.dump(), "an object");
  }

  void number(const char* key, double& value, double lo, double hi) {
    const Json* j = take(key);
    if (j == nullptr) return;
    const double v = j->is_number() ? j->get<double>() : hi + 1;
    if (!(v >= lo && v <= hi))
      throw bad_input(where() + key + " is " + j->dump(),
                      "a number from " + number_text(lo) + " to " + number_text(hi));
    value = v;
  }
  void integer(const char* key, int& value, int lo, int hi) {
    const Json* j = take(key);
    if (j == nullptr) return;
    if (!j->is_number_integer() || j->get<double>() < lo || j->get<double>() > hi)
      throw bad_input(where() + key + " is " + j->dump(),
                      "a whole number from " + std::to_string(lo) + " to " + std::to_string(hi));
    value = j->get<int>();
  }
  void text(const char* key, std::string& value) {
    const Json* j = take(key);
    if (j == nullptr) return;
    if (!j->is_string()) throw bad_input(where() + key + " is " + j->dump(), "a text");
    value = j->get<std::string>();
  }
  const Json* take(const std::string& key) {
    known_.push_back(key);
    return json_.is_object() && json_.contains(key) ? &json_[key] : nullptr;
  }
  void refuse_unknown() const {
    if (!json_.is_object()) return;
    for (const auto& [key, value] : json_.items())
      if (std::ranges::find(known_, key) == known_.end())
        throw bad_input("unknown entry " + where() + key, "one of the entries of a field recipe");
  }

 private:
  std::string where() const { return name_.empty() ? "field recipe " : "field recipe " + name_ + "."; }
  std::string name_;
  Json json_;
  std::vector<std::string> known_;
};

Eigen::Vector2d position_in(const Json& p) {
  if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number() || std::abs(p[0].get<double>()) > 1000 ||
      std::abs(p[1].get<double>()) > 1000)
    throw bad_input("field recipe plants.at has " + p.dump(), "positions [x, y] within 1000 m");
  return {p[0].get<double>(), p[1].get<double>()};
}

FieldPlants plants_in(const Json& json) {
  FieldPlants p;
  Section s(json, "plants");
  s.text("kind", p.kind);
  if (p.kind != "tube" && p.kind != "tree" && p.kind != "vine" && p.kind != "apple")
    throw bad_input("field recipe plants.kind is '" + p.kind + "'", "tube, tree, vine or apple");
  if (const Json* rows = s.take("at"))
    for (const auto& row : *rows) {
      auto& positions = p.at.emplace_back();
      for (const auto& at : row) positions.push_back(position_in(at));
      if (positions.empty()) throw bad_input("field recipe plants.at has an empty row", "positions [x, y]");
    }
  s.integer("rows", p.rows, 1, 200), s.integer("plants_per_row", p.plants_per_row, 1, 500);
  s.number("plant_spacing_m", p.plant_spacing_m, 0.05, 50), s.number("row_spacing_m", p.row_spacing_m, 0.05, 50);
  s.number("angle_deg", p.angle_deg, -180, 180), s.number("position_sd_m", p.position_sd_m, 0, 1);
  s.number("missing_share", p.missing_share, 0, 0.9), s.number("height_m", p.height_m, 0.2, 40);
  s.number("diameter_min_mm", p.diameter_min_mm, 5, 2000), s.number("diameter_max_mm", p.diameter_max_mm, 5, 2000);
  s.number("lean_sd_deg", p.lean_sd_deg, 0, 15), s.integer("leaves", p.leaves, 0, 500);
  s.refuse_unknown();
  if (p.diameter_min_mm > p.diameter_max_mm)
    throw bad_input("field recipe plants.diameter_min_mm is above diameter_max_mm", "the smaller one first");
  return p;
}

}  // namespace

FieldRecipe parse_field(const Json& json) {
  if (!json.is_object()) throw bad_input("the field recipe is " + json.dump(), "a JSON object");
  FieldRecipe r;
  Section top(json, "");
  top.text("name", r.name), top.text("title", r.title);
  top.take("plants"), top.take("ground"), top.take("sensor");
  top.refuse_unknown();
  r.plants = plants_in(json);
  Section ground(json, "ground");
  ground.number("slope_deg", r.ground.slope_deg, 0, 30);
  ground.number("undulation_m", r.ground.undulation_m, 0, 2);
  ground.number("weeds_per_m2", r.ground.weeds_per_m2, 0, 20);
  ground.refuse_unknown();
  Section sensor(json, "sensor");
  sensor.number("x_m", r.sensor.x_m, -1000, 1000), sensor.number("y_m", r.sensor.y_m, -1000, 1000);
  sensor.number("heading_deg", r.sensor.heading_deg, -360, 360);
  sensor.number("height_m", r.sensor.height_m, 0.1, 5);
  sensor.refuse_unknown();
  return r;
}

FieldRecipe read_field(const std::string& name_or_path) {
  namespace fs = std::filesystem;
  fs::path file = name_or_path;
  const auto names = field_names();
  if (std::ranges::find(names, name_or_path) != names.end()) file = resource_path("fields/" + name_or_path + ".json");
  std::ifstream in(file);
  if (!in || fs::is_directory(file)) {
    std::string known;
    for (const auto& name : names) known += (known.empty() ? "" : ", ") + name;
    throw bad_input("there is no field '" + name_or_path + "'", known + ", or the path of a recipe");
  }
  try {
    return parse_field(Json::parse(in, nullptr, true, true));
  } catch (const Json::exception& e) {
    throw bad_input(file.string() + " is not valid JSON: " + e.what(), "a field recipe");
  } catch (const Error& e) {
    throw e.at(file.string());
  }
}

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(resource_path("fields")))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace bole::sim
