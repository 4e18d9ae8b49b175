#include "rows/core/edits/row_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::rows {
namespace {

using Json = nlohmann::ordered_json;
using Action = RowEdit::Action;
using Keys = std::vector<std::string_view>;

struct ActionInfo {
  Action action;
  std::string_view name;
  Keys needed, allowed;
};

const std::array<ActionInfo, 7>& actions() {
  static const std::array<ActionInfo, 7> table{{
      {Action::move, "move", {"at", "from", "to"}, {}},
      {Action::add, "add", {"from", "to"}, {"row_id"}},
      {Action::remove, "delete", {"at"}, {}},
      {Action::split, "split", {"at"}, {}},
      {Action::merge, "merge", {"at", "with"}, {}},
      {Action::renumber, "renumber", {"at", "row_id"}, {}},
      {Action::note, "note", {"at", "text"}, {}},
  }};
  return table;
}

const Keys& common_keys() {
  static const Keys keys{"action", "was_angle_deg", "author", "time", "reason"};
  return keys;
}

bool holds(const Keys& keys, std::string_view key) { return std::ranges::find(keys, key) != keys.end(); }

double number_in(const Json& value, const std::string& what, double least, double most) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= least && number <= most))
    throw bad_input(what + " is " + value.dump(), "a number from " + Json(least).dump() + " to " + Json(most).dump());
  return number;
}

Eigen::Vector2d place_in(const Json& value, const std::string& key) {
  if (!value.is_array() || value.size() != 2)
    throw bad_input(key + " is " + value.dump(), "a position [x, y] in metres");
  return {number_in(value[0], key, -1e8, 1e8), number_in(value[1], key, -1e8, 1e8)};
}

void read_key(RowEdit& edit, const std::string& key, const Json& value) {
  const auto text = [&] {
    if (!value.is_string()) throw bad_input(key + " is " + value.dump(), "a text");
    return value.get<std::string>();
  };
  if (key == "at") edit.at = place_in(value, key);
  if (key == "from") edit.from = place_in(value, key);
  if (key == "to") edit.to = place_in(value, key);
  if (key == "was_angle_deg") edit.was_angle_deg = number_in(value, key, -180, 180);
  if (key == "row_id") edit.row_id = value.is_number_integer() ? value.dump() : text();
  if (key == "with") {
    if (!value.is_array() || value.empty())
      throw bad_input("with is " + value.dump(), "a list of places on other rows");
    for (const auto& place : value) edit.with.push_back(place_in(place, key));
  }
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

RowEdit edit_in(const Json& object) {
  const auto& info = action_in(object);
  RowEdit edit;
  edit.action = info.action;
  for (const std::string_view key : info.needed)
    if (!object.contains(key))
      throw bad_input(std::string(info.name) + " without " + std::string(key), std::string(key));
  for (const auto& [key, value] : object.items()) {
    if (!holds(common_keys(), key) && !holds(info.needed, key) && !holds(info.allowed, key))
      throw bad_input(std::string(info.name) + " does not take '" + key + "'", "only what the action uses");
    read_key(edit, key, value);
  }
  if (edit.from && edit.to && !((*edit.from - *edit.to).norm() > 0.01))
    throw bad_input(std::string(info.name) + " has both ends at one place", "two ends that are apart");
  if (info.action == Action::renumber && edit.row_id.empty()) throw bad_input("row_id is empty", "the new id");
  return edit;
}

Json place(const Eigen::Vector2d& p) { return Json::array({p.x(), p.y()}); }

Json object_of(const RowEdit& edit) {
  Json o{{"action", action_name(edit.action)}};
  if (edit.action != Action::add) o["at"] = place(edit.at);
  if (edit.from) o["from"] = place(*edit.from);
  if (edit.to) o["to"] = place(*edit.to);
  for (const auto& p : edit.with) o["with"].push_back(place(p));
  if (!edit.row_id.empty()) o["row_id"] = edit.row_id;
  if (edit.was_angle_deg) o["was_angle_deg"] = *edit.was_angle_deg;
  if (edit.action == Action::note) o["text"] = edit.text;
  for (const auto& [key, text] : {std::pair{"author", &edit.author}, {"time", &edit.time}, {"reason", &edit.reason}})
    if (!text->empty()) o[key] = *text;
  return o;
}

}  // namespace

std::string_view action_name(Action action) { return std::ranges::find(actions(), action, &ActionInfo::action)->name; }

std::vector<RowEdit> parse_row_edits(std::string_view text) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array())
    throw bad_input(list.is_discarded() ? "the edits are no JSON" : "the edits are no list", "a JSON list of edits");
  std::vector<RowEdit> edits;
  for (std::size_t i = 0; i < list.size(); ++i) try {
      edits.push_back(edit_in(list[i]));
    } catch (const Error& e) {
      throw e.at("edit " + std::to_string(i + 1));
    }
  return edits;
}

std::string to_json(const std::vector<RowEdit>& edits) {
  Json list = Json::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::rows
