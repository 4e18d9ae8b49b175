#include "plant/core/edits/plant_edits.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"

namespace bole::plant {
namespace {

using Action = PlantEdit::Action;

// In the order of PlantEdit::Action.
const std::array<EditAction, 7>& actions() {
  static const std::array<EditAction, 7> table{{
      {"set_base", {"at"}, {}},
      {"set_stem_height", {"height_m"}, {}},
      {"assign", {"part"}, {"from", "at", "radius_m", "min", "max", "outline", "eye"}},
      {"set_value", {"trait", "value_mm"}, {"was_mm"}},
      {"accept", {}, {}},
      {"reject", {}, {}},
      {"note", {"text"}, {}},
  }};
  return table;
}

constexpr std::size_t max_corners = 10'000;

Eigen::Vector3d place_in(const EditJson& value, const std::string& key) {
  const auto& list = edit_list(value, key, 3);
  if (list.size() != 3) throw bad_input(key + " has " + value.dump(), "[x, y, z] in metres");
  Eigen::Vector3d out;
  for (int k = 0; k < 3; ++k) out[k] = edit_number(list[static_cast<std::size_t>(k)], key, -1e7, 1e7);
  return out;
}

std::string trait_in(const EditJson& value, const std::string& key) {
  const auto name = edit_text(value, key);
  for (const auto* known : {"height", "breadth_length", "breadth_width", "stem_diameter"})
    if (name == known) return name;
  throw bad_input("trait is '" + name + "'", "height, breadth_length, breadth_width or stem_diameter");
}

EditJson json_of(const Eigen::Vector3d& place) { return EditJson::array({place.x(), place.y(), place.z()}); }

PointRegion outline_in(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::outline;
  const auto& corners = edit_list(object["outline"], "outline", 3);
  if (corners.size() > max_corners)
    throw bad_input("outline has " + std::to_string(corners.size()) + " corners",
                    "at most " + std::to_string(max_corners));
  for (const auto& corner : corners) region.outline.push_back(place_in(corner, "outline"));
  if (object.contains("eye")) region.eye = place_in(object["eye"], "eye");
  return region;
}

PointRegion box_in(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::box;
  region.min = place_in(object["min"], "min");
  region.max = place_in(object["max"], "max");
  if ((region.min.array() > region.max.array()).any())
    throw bad_input("the box ends before it begins", "min below max in x, y and z");
  return region;
}

PointRegion ball_in(const EditJson& object) {
  PointRegion region;
  region.at = place_in(object["at"], "at");
  region.radius = edit_number(object["radius_m"], "radius_m", 0.0001, 10);
  return region;
}

// One of the three forms, and all of it.
PointRegion region_in(const EditJson& object) {
  const auto has = [&](const char* key) { return object.contains(key); };
  const bool ball = has("at") || has("radius_m"), box = has("min") || has("max"), outline = has("outline");
  const bool whole = (!ball || (has("at") && has("radius_m"))) && (!box || (has("min") && has("max")));
  if (int{ball} + int{box} + int{outline} != 1 || !whole || (has("eye") && !outline))
    throw bad_input("assign does not say which points", "at and radius_m, or min and max, or outline (and eye)");
  return ball ? ball_in(object) : box ? box_in(object) : outline_in(object);
}

void put_region(EditJson& object, const PointRegion& region) {
  if (region.kind == PointRegion::Kind::ball) {
    object["at"] = json_of(region.at);
    object["radius_m"] = region.radius;
  } else if (region.kind == PointRegion::Kind::box) {
    object["min"] = json_of(region.min);
    object["max"] = json_of(region.max);
  } else {
    object["outline"] = EditJson::array();
    for (const auto& corner : region.outline) object["outline"].push_back(json_of(corner));
    if (region.eye) object["eye"] = json_of(*region.eye);
  }
}

void read_key(PlantEdit& edit, const std::string& key, const EditJson& value) {
  if (key == "at" && edit.action == Action::set_base) edit.at = place_in(value, key);
  if (key == "height_m") edit.height = edit_number(value, key, 0.001, 10);
  if (key == "from") edit.from = choice_from_name<Part>(edit_text(value, key));
  if (key == "part") edit.part = choice_from_name<Part>(edit_text(value, key));
  if (key == "trait") edit.trait = trait_in(value, key);
  if (key == "value_mm") edit.value_mm = edit_number(value, key, 0.01, 1e5);
  if (key == "was_mm") edit.was_mm = edit_number(value, key, 0, 1e6);
  if (key == "text") edit.text = edit_text(value, key);
}

EditJson object_of(const PlantEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}};
  if (edit.action == Action::set_base) o["at"] = json_of(edit.at);
  if (edit.action == Action::set_stem_height) o["height_m"] = edit.height;
  if (edit.action == Action::assign) {
    put_region(o, edit.region);
    if (edit.from) o["from"] = choice_name(*edit.from);
    o["part"] = choice_name(edit.part);
  }
  if (edit.action == Action::set_value) {
    o["trait"] = edit.trait;
    o["value_mm"] = edit.value_mm;
    if (edit.was_mm) o["was_mm"] = *edit.was_mm;
  }
  if (edit.action == Action::note) o["text"] = edit.text;
  put_edit_record(o, edit);
  return o;
}

}  // namespace

std::string_view action_name(Action action) { return actions()[static_cast<std::size_t>(action)].name; }

std::vector<PlantEdit> parse_plant_edits(std::string_view text) {
  std::vector<PlantEdit> edits;
  read_edits(text, actions(), {}, [&](std::size_t action, const EditJson& object) {
    auto& edit = edits.emplace_back();
    edit.action = static_cast<Action>(action);
    static_cast<EditRecord&>(edit) = edit_record(object);
    for (const auto& [key, value] : object.items()) read_key(edit, key, value);
    if (edit.action == Action::assign) edit.region = region_in(object);
  });
  return edits;
}

std::string to_json(const std::vector<PlantEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::plant
