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
      {"assign", {"at", "radius_m", "part"}, {"from"}},
      {"set_value", {"trait", "value_mm"}, {"was_mm"}},
      {"accept", {}, {}},
      {"reject", {}, {}},
      {"note", {"text"}, {}},
  }};
  return table;
}

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

void read_key(PlantEdit& edit, const std::string& key, const EditJson& value) {
  if (key == "at") edit.at = place_in(value, key);
  if (key == "height_m") edit.height = edit_number(value, key, 0.001, 10);
  if (key == "radius_m") edit.radius = edit_number(value, key, 0.0001, 10);
  if (key == "from") edit.from = choice_from_name<Part>(edit_text(value, key));
  if (key == "part") edit.part = choice_from_name<Part>(edit_text(value, key));
  if (key == "trait") edit.trait = trait_in(value, key);
  if (key == "value_mm") edit.value_mm = edit_number(value, key, 0.01, 1e5);
  if (key == "was_mm") edit.was_mm = edit_number(value, key, 0, 1e6);
  if (key == "text") edit.text = edit_text(value, key);
}

EditJson object_of(const PlantEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}};
  if (edit.action == Action::set_base || edit.action == Action::assign)
    o["at"] = EditJson::array({edit.at.x(), edit.at.y(), edit.at.z()});
  if (edit.action == Action::set_stem_height) o["height_m"] = edit.height;
  if (edit.action == Action::assign) {
    o["radius_m"] = edit.radius;
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
  });
  return edits;
}

std::string to_json(const std::vector<PlantEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::plant
