#include "cloud/edit_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr std::array<std::string_view, 4> keys_of_all{"action", "author", "time", "reason"};

bool holds(std::span<const std::string_view> keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

std::size_t action_in(const EditJson& object, std::span<const EditAction> actions) {
  std::string known;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (object.is_object() && object.contains("action") && object["action"] == actions[i].name) return i;
    known += (known.empty() ? "" : ", ") + std::string(actions[i].name);
  }
  throw bad_input("no known action in " + object.dump(), "\"action\": one of " + known);
}

void check_keys(const EditJson& object, const EditAction& action, std::span<const std::string_view> common) {
  const std::string name(action.name);
  for (const auto key : action.needed)
    if (!object.contains(key)) throw bad_input(name + " without " + std::string(key), std::string(key));
  for (const auto& [key, value] : object.items())
    if (!holds(keys_of_all, key) && !holds(common, key) && !holds(action.needed, key) && !holds(action.allowed, key))
      throw bad_input(name + " does not take '" + key + "'", "only what the action uses");
}

}  // namespace

double edit_number(const EditJson& value, const std::string& key, double min, double max) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= min && number <= max))
    throw bad_input(key + " is " + value.dump(),
                    "a number from " + EditJson(min).dump() + " to " + EditJson(max).dump());
  return number;
}

Eigen::Vector2d edit_place(const EditJson& value, const std::string& key) {
  if (!value.is_array() || value.size() != 2)
    throw bad_input(key + " is " + value.dump(), "a position [x, y] in metres");
  return {edit_number(value[0], key, -1e8, 1e8), edit_number(value[1], key, -1e8, 1e8)};
}

const EditJson& edit_list(const EditJson& value, const std::string& key, std::size_t min_size) {
  if (!value.is_array() || value.size() < min_size)
    throw bad_input(key + " is " + value.dump(), "a list of at least " + std::to_string(min_size));
  return value;
}

std::string edit_text(const EditJson& value, const std::string& key) {
  if (!value.is_string()) throw bad_input(key + " is " + value.dump(), "a text");
  return value.get<std::string>();
}

EditJson edit_json(const Eigen::Vector2d& place) { return EditJson::array({place.x(), place.y()}); }

void read_edits(std::string_view text, std::span<const EditAction> actions, std::span<const std::string_view> common,
                const std::function<void(std::size_t action, const EditJson& object)>& read) {
  const auto list = EditJson::parse(text, nullptr, false);
  if (!list.is_array())
    throw bad_input(list.is_discarded() ? "the edits are no JSON" : "the edits are no list", "a JSON list of edits");
  for (std::size_t i = 0; i < list.size(); ++i) try {
      const auto action = action_in(list[i], actions);
      check_keys(list[i], actions[action], common);
      read(action, list[i]);
    } catch (const Error& e) {
      throw e.at("edit " + std::to_string(i + 1));
    }
}

EditRecord edit_record(const EditJson& object) {
  const auto text = [&](const char* key) { return object.contains(key) ? edit_text(object[key], key) : std::string(); };
  return {text("author"), text("time"), text("reason")};
}

void put_edit_record(EditJson& object, const EditRecord& record) {
  if (!record.author.empty()) object["author"] = record.author;
  if (!record.time.empty()) object["time"] = record.time;
  if (!record.reason.empty()) object["reason"] = record.reason;
}

std::string read_edit_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw bad_input("cannot read " + path, "a file with a JSON list of edits");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace cloud
}  // namespace bole
