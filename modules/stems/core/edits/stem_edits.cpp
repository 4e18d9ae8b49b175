#include "stems/core/edits/stem_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::stems {
namespace {

using Json = nlohmann::ordered_json;
using Action = StemEdit::Action;
using Keys = std::vector<std::string_view>;

struct ActionInfo {
  Action action;
  std::string_view name;
  Keys needed, allowed;
};

const std::array<ActionInfo, 10>& actions() {
  static const std::array<ActionInfo, 10> table{{
      {Action::add, "add", {}, {"dbh_cm", "height_m"}},
      {Action::remove, "delete", {}, {}},
      {Action::move, "move", {"to"}, {}},
      {Action::resize, "resize", {"dbh_cm"}, {}},
      {Action::set_height, "set_height", {"height_m"}, {}},
      {Action::split, "split", {"into"}, {}},
      {Action::merge, "merge", {"with"}, {"dbh_cm"}},
      {Action::accept, "accept", {}, {}},
      {Action::reject, "reject", {}, {}},
      {Action::note, "note", {"text"}, {}},
  }};
  return table;
}

const Keys& common_keys() {
  static const Keys keys{"action", "at", "was_dbh_cm", "author", "time", "reason"};
  return keys;
}

bool holds(const Keys& keys, std::string_view key) { return std::ranges::find(keys, key) != keys.end(); }

double number_in(const Json& value, const std::string& what, double least, double most) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= least && number <= most))
    throw bad_input(what + " is " + value.dump(), "a number from " + Json(least).dump() + " to " + Json(most).dump());
  return number;
}

double dbh_in(const Json& value, const std::string& key) { return number_in(value, key, 0.1, 2000); }

Eigen::Vector2d place_in(const Json& value, const std::string& key) {
  if (!value.is_array() || value.size() != 2)
    throw bad_input(key + " is " + value.dump(), "a position [x, y] in metres");
  return {number_in(value[0], key, -1e8, 1e8), number_in(value[1], key, -1e8, 1e8)};
}

const Json& list_in(const Json& value, const std::string& key, std::size_t least) {
  if (!value.is_array() || value.size() < least)
    throw bad_input(key + " is " + value.dump(), "a list of at least " + std::to_string(least));
  return value;
}

StemEdit::Part part_in(const Json& value) {
  if (!value.is_object() || !value.contains("at") || !value.contains("dbh_cm") || value.size() != 2)
    throw bad_input("into has " + value.dump(), R"({"at": [x, y], "dbh_cm": ...} for every new stem)");
  return {place_in(value["at"], "at"), dbh_in(value["dbh_cm"], "dbh_cm")};
}

void read_key(StemEdit& edit, const std::string& key, const Json& value) {
  const auto text = [&] {
    if (!value.is_string()) throw bad_input(key + " is " + value.dump(), "a text");
    return value.get<std::string>();
  };
  if (key == "at") edit.at = place_in(value, key);
  if (key == "to") edit.to = place_in(value, key);
  if (key == "dbh_cm") edit.dbh_cm = dbh_in(value, key);
  if (key == "was_dbh_cm") edit.was_dbh_cm = dbh_in(value, key);
  if (key == "height_m") edit.height_m = number_in(value, key, 0.1, 200);
  if (key == "into")
    for (const auto& part : list_in(value, key, 2)) edit.into.push_back(part_in(part));
  if (key == "with")
    for (const auto& place : list_in(value, key, 1)) edit.with.push_back(place_in(place, key));
  if (key == "text") edit.text = text();
  if (key == "author") edit.author = text();
  if (key == "time") edit.time = text();
  if (key == "reason") edit.reason = text();
}

const ActionInfo& action_in(const Json& object) {
  std::string known;
  for (const auto& info : actions()) {
    if (object.is_object() && object.contains("action") && object["action"] == info.name) return info;
    known += (known.empty() ? "" : ", ") + std::string(info.name);
  }
  throw bad_input("no known action in " + object.dump(), "\"action\": one of " + known);
}

StemEdit edit_in(const Json& object) {
  const auto& info = action_in(object);
  StemEdit edit;
  edit.action = info.action;
  for (const std::string_view key : info.needed)
    if (!object.contains(key))
      throw bad_input(std::string(info.name) + " without " + std::string(key), std::string(key));
  if (!object.contains("at")) throw bad_input(std::string(info.name) + " without at", "the place of the stem, [x, y]");
  for (const auto& [key, value] : object.items()) {
    if (!holds(common_keys(), key) && !holds(info.needed, key) && !holds(info.allowed, key))
      throw bad_input(std::string(info.name) + " does not take '" + key + "'", "only what the action uses");
    read_key(edit, key, value);
  }
  return edit;
}

Json place(const Eigen::Vector2d& p) { return Json::array({p.x(), p.y()}); }

Json object_of(const StemEdit& edit) {
  Json o{{"action", action_name(edit.action)}, {"at", place(edit.at)}};
  if (edit.to) o["to"] = place(*edit.to);
  if (edit.dbh_cm) o["dbh_cm"] = *edit.dbh_cm;
  if (edit.was_dbh_cm) o["was_dbh_cm"] = *edit.was_dbh_cm;
  if (edit.height_m) o["height_m"] = *edit.height_m;
  for (const auto& part : edit.into) o["into"].push_back({{"at", place(part.at)}, {"dbh_cm", part.dbh_cm}});
  for (const auto& p : edit.with) o["with"].push_back(place(p));
  if (edit.action == Action::note) o["text"] = edit.text;
  for (const auto& [key, text] : {std::pair{"author", &edit.author}, {"time", &edit.time}, {"reason", &edit.reason}})
    if (!text->empty()) o[key] = *text;
  return o;
}

}  // namespace

std::string_view action_name(StemEdit::Action action) {
  return std::ranges::find(actions(), action, &ActionInfo::action)->name;
}

std::vector<StemEdit> parse_stem_edits(std::string_view text) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array())
    throw bad_input(list.is_discarded() ? "the edits are no JSON" : "the edits are no list", "a JSON list of edits");
  std::vector<StemEdit> edits;
  for (std::size_t i = 0; i < list.size(); ++i) try {
      edits.push_back(edit_in(list[i]));
    } catch (const Error& e) {
      throw e.at("edit " + std::to_string(i + 1));
    }
  return edits;
}

std::string to_json(const std::vector<StemEdit>& edits) {
  Json list = Json::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::stems
