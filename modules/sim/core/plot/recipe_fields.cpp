#include "sim/core/plot/recipe_fields.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/error.h"
#include "base/option_text.h"
#include "base/resources.h"

namespace bole::sim {
namespace {

using Json = nlohmann::json;

constexpr double farthest_plant = 1000;  // metres, of x and y

Error wrong_field(const std::string& path, const Json& json, const std::string& needed) {
  return bad_input("recipe field '" + path + "' is " + json.dump().substr(0, 60), needed);
}

std::string list_of(const auto& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

bool is_position(const Json& json) {
  return json.is_array() && json.size() == 2 && std::ranges::all_of(json, [](const Json& x) {
           return x.is_number() && std::abs(x.get<double>()) <= farthest_plant;
         });
}

}  // namespace

RecipeReader::RecipeReader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
  if (!json_.is_object()) throw wrong_field(path_.empty() ? "(whole file)" : path_, json_, "a JSON object {...}");
}

void RecipeReader::refuse_unknown() const {
  for (const auto& [key, unused] : json_.items()) {
    if (known_.contains(key)) continue;
    const auto near = nearest_names(key, {known_.begin(), known_.end()}, 1);
    throw bad_input("unknown recipe field '" + path_of(key) + "'", "a field of modules/sim/README.md",
                    near.empty() ? "" : "Did you mean '" + near.front() + "'?");
  }
}

std::string RecipeReader::text_in(const Json& json, const std::string& path) {
  if (!json.is_string()) throw wrong_field(path, json, "a text");
  return json.get<std::string>();
}

std::size_t RecipeReader::choice_in(const Json& json, const std::string& path,
                                    std::span<const std::string_view> names) {
  const auto found = json.is_string() ? std::ranges::find(names, json.get<std::string>()) : names.end();
  if (found == names.end()) throw wrong_field(path, json, "one of " + list_of(names));
  return static_cast<std::size_t>(found - names.begin());
}

double RecipeReader::number_in(const Json& json, const std::string& path, bool whole, double min, double max) {
  const bool right_type = whole ? json.is_number_integer() : json.is_number();
  const double number = right_type ? json.get<double>() : 0;
  if (!right_type || !(number >= min && number <= max))
    throw wrong_field(
        path, json, (whole ? "a whole number from " : "a number from ") + number_text(min) + " to " + number_text(max));
  return number;
}

std::size_t RecipeReader::list_size(const Json& json, const std::string& path, double max) {
  if (!json.is_array() || static_cast<double>(json.size()) > max)
    throw wrong_field(path, json, "a list of up to " + number_text(max));
  return json.size();
}

PlantPositions RecipeReader::positions_in(const Json& json, const std::string& path) {
  PlantPositions rows;
  for (const auto& row : json) {
    if (!row.is_array() || row.empty() || !std::ranges::all_of(row, is_position))
      throw wrong_field(path, row, "rows of positions [x, y] within 1000 m");
    auto& positions = rows.emplace_back();
    for (const auto& at : row) positions.emplace_back(at[0].get<double>(), at[1].get<double>());
  }
  return rows;
}

Span RecipeReader::span_in(const Json& json, const std::string& path, double min, double max) {
  const bool two_numbers = json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number();
  const Span span = two_numbers ? Span{json[0].get<double>(), json[1].get<double>()} : Span{};
  if (!two_numbers || !(span.min >= min && span.min <= span.max && span.max <= max))
    throw wrong_field(path, json, "[smallest, largest] from " + number_text(min) + " to " + number_text(max));
  return span;
}

std::vector<std::string> recipe_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(resource_path(folder)))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::filesystem::path find_recipe(const std::string& folder, const std::string& name_or_path) {
  if (name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".json")) return name_or_path;
  const auto names = recipe_names(folder);
  if (std::ranges::find(names, name_or_path) == names.end())
    throw bad_input("there is no recipe '" + name_or_path + "' in resources/" + folder,
                    "one of " + list_of(names) + ", or the path of a recipe file", did_you_mean(name_or_path, names));
  return resource_path(folder + "/" + name_or_path + ".json");
}

Json read_recipe_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
    throw bad_input("cannot open the recipe " + file.string(), "a readable file");
  try {
    return Json::parse(in, nullptr, true, true);
  } catch (const Json::exception& e) {
    throw bad_input(file.string() + " is not valid JSON: " + e.what(), "a recipe");
  }
}

}  // namespace bole::sim
