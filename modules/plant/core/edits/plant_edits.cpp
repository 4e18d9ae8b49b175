#include "plant/core/edits/plant_edits.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"
#include "cloud/core/regions/region_json.h"

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

std::string trait_in(const EditJson& value, const std::string& key) {
  auto name = edit_text(value, key);
  for (const auto* known : {"height", "breadth_length", "breadth_width", "stem_diameter"})
    if (name == known) return name;
  throw bad_input("trait is '" + name + "'", "height, breadth_length, breadth_width or stem_diameter");
}

PointRegion box_in(const EditJson& object) {
  PointRegion region;
  region.kind = PointRegion::Kind::box;
  region.min = edit_place_3d(object["min"], "min");
  region.max = edit_place_3d(object["max"], "max");
  if ((region.min.array() > region.max.array()).any())
    throw bad_input("the box ends before it begins", "min below max in x, y and z");
  return region;
}

PointRegion ball_in(const EditJson& object) {
  PointRegion region;
  region.at = edit_place_3d(object["at"], "at");
  region.radius = edit_number(object["radius_m"], "radius_m", 0.0001, 10);
  return region;
}

// One of the three forms, and all of it.
PointRegion plant_region_in(const EditJson& object) {
  const auto has = [&](const char* key) { return object.contains(key); };
  const bool ball = has("at") || has("radius_m"), box = has("min") || has("max"), outline = has("outline");
  const bool whole = (!ball || (has("at") && has("radius_m"))) && (!box || (has("min") && has("max")));
  if (int{ball} + int{box} + int{outline} != 1 || !whole || (has("eye") && !outline))
    throw bad_input("assign does not say which points", "at and radius_m, or min and max, or outline (and eye)");
  return ball ? ball_in(object) : box ? box_in(object) : outline_in(object);
}

void put_plant_region(EditJson& object, const PointRegion& region) {
  if (region.kind == PointRegion::Kind::ball) {
    object["at"] = edit_json(region.at);
    object["radius_m"] = region.radius;
  } else if (region.kind == PointRegion::Kind::box) {
    object["min"] = edit_json(region.min);
    object["max"] = edit_json(region.max);
  } else {
    object["outline"] = EditJson::array();
    for (const auto& corner : region.outline) object["outline"].push_back(edit_json(corner));
    if (region.eye) object["eye"] = edit_json(*region.eye);
  }
}

void read_key(PlantEdit& edit, const std::string& key, const EditJson& value) {
  if (key == "at" && edit.action == Action::set_base) edit.at = edit_place_3d(value, key);
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
  if (edit.action == Action::set_base) o["at"] = edit_json(edit.at);
  if (edit.action == Action::set_stem_height) o["height_m"] = edit.height;
  if (edit.action == Action::assign) {
    put_plant_region(o, edit.region);
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
    if (edit.action == Action::assign) edit.region = plant_region_in(object);
  });
  return edits;
}

std::string to_json(const std::vector<PlantEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::plant
