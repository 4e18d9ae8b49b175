#include "stems/core/edits/stem_edits.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::stems {
namespace {

using Action = StemEdit::Action;

// In the order of StemEdit::Action.
const std::array<EditAction, 12>& actions() {
  static const std::array<EditAction, 12> table{{
      {"add", {"at"}, {"dbh_cm", "height_m"}},
      {"delete", {"at"}, {}},
      {"move", {"at", "to"}, {}},
      {"resize", {"at", "dbh_cm"}, {}},
      {"set_height", {"at", "height_m"}, {}},
      {"split", {"at", "into"}, {}},
      {"merge", {"at", "with"}, {"dbh_cm"}},
      {"accept", {"at"}, {}},
      {"reject", {"at"}, {}},
      {"note", {"at", "text"}, {}},
      {"set_species", {"at", "species"}, {}},
      {"tilt", {"at", "lean_deg", "lean_azimuth_deg"}, {}},
  }};
  return table;
}

constexpr double max_lean_deg = 80;  // what leans more lies on the ground

constexpr std::array<std::string_view, 1> common_keys{"was_dbh_cm"};

double dbh_in(const EditJson& value, const std::string& key) { return edit_number(value, key, 0.1, 2000); }

StemEdit::Part part_in(const EditJson& value) {
  if (!value.is_object() || !value.contains("at") || !value.contains("dbh_cm") || value.size() != 2)
    throw bad_input("into has " + value.dump(), R"({"at": [x, y], "dbh_cm": ...} for every new stem)");
  return {edit_place(value["at"], "at"), dbh_in(value["dbh_cm"], "dbh_cm")};
}

void read_key(StemEdit& edit, const std::string& key, const EditJson& value) {
  if (key == "at") edit.at = edit_place(value, key);
  if (key == "to") edit.to = edit_place(value, key);
  if (key == "dbh_cm") edit.dbh_cm = dbh_in(value, key);
  if (key == "was_dbh_cm") edit.was_dbh_cm = dbh_in(value, key);
  if (key == "height_m") edit.height_m = edit_number(value, key, 0.1, 200);
  if (key == "into")
    for (const auto& part : edit_list(value, key, 2)) edit.into.push_back(part_in(part));
  if (key == "with")
    for (const auto& place : edit_list(value, key, 1)) edit.with.push_back(edit_place(place, key));
  if (key == "text") edit.text = edit_text(value, key);
  if (key == "species") edit.species = edit_text(value, key);
  if (key == "lean_deg") edit.lean_deg = edit_number(value, key, 0, max_lean_deg);
  if (key == "lean_azimuth_deg") edit.lean_azimuth_deg = edit_number(value, key, 0, 360);
}

EditJson object_of(const StemEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}, {"at", edit_json(edit.at)}};
  if (edit.to) o["to"] = edit_json(*edit.to);
  if (edit.dbh_cm) o["dbh_cm"] = *edit.dbh_cm;
  if (edit.was_dbh_cm) o["was_dbh_cm"] = *edit.was_dbh_cm;
  if (edit.height_m) o["height_m"] = *edit.height_m;
  for (const auto& part : edit.into) o["into"].push_back({{"at", edit_json(part.at)}, {"dbh_cm", part.dbh_cm}});
  for (const auto& p : edit.with) o["with"].push_back(edit_json(p));
  if (edit.action == Action::note) o["text"] = edit.text;
  if (edit.action == Action::set_species) o["species"] = edit.species;
  if (edit.lean_deg) o["lean_deg"] = *edit.lean_deg;
  if (edit.lean_azimuth_deg) o["lean_azimuth_deg"] = *edit.lean_azimuth_deg;
  put_edit_record(o, edit);
  return o;
}

}  // namespace

std::string_view action_name(StemEdit::Action action) { return actions()[static_cast<std::size_t>(action)].name; }

std::vector<StemEdit> parse_stem_edits(std::string_view text) {
  std::vector<StemEdit> edits;
  read_edits(text, actions(), common_keys, [&](std::size_t action, const EditJson& object) {
    auto& edit = edits.emplace_back();
    edit.action = static_cast<Action>(action);
    static_cast<EditRecord&>(edit) = edit_record(object);
    for (const auto& [key, value] : object.items()) read_key(edit, key, value);
  });
  return edits;
}

std::string to_json(const std::vector<StemEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::stems
