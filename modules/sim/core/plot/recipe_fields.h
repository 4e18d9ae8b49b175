// Recipes as JSON: one list of fields per struct serves reading, checking and writing.
//
//   template <class V>
//   void each_field(Recipe& r, V&& visit) { visit("size_m", r.size_m, 4, 100); }  // name, member, smallest, largest
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/option.h"

namespace bole::sim {

using PlantPositions = std::vector<std::vector<Eigen::Vector2d>>;  // by row, metres

// A range that a value is drawn from; in a recipe [smallest, largest].
struct Span {
  double min = 0, max = 0;
};

template <class T>
inline constexpr bool is_recipe_list = false;
template <class T>
inline constexpr bool is_recipe_list<std::vector<T>> = !std::is_same_v<std::vector<T>, PlantPositions>;

// Throws Error{bad_input} that names the field, its value and what was needed. Unknown fields are errors too. Lists of
// recipes hold at most `max` of them.
class RecipeReader {
 public:
  RecipeReader(const nlohmann::json& json, std::string path);

  template <class T>
  void operator()(const char* name, T& value, double min, double max) {
    known_.insert(name);
    const auto it = json_.find(name);
    if (it == json_.end()) return;
    const std::string path = path_of(name);
    if constexpr (std::is_same_v<T, std::string>) {
      value = text_in(*it, path);
    } else if constexpr (ChoiceEnum<T>) {
      value = static_cast<T>(choice_in(*it, path, choice_names(T{})));
    } else if constexpr (std::is_same_v<T, PlantPositions>) {
      value = positions_in(*it, path);
    } else if constexpr (std::is_same_v<T, Span>) {
      value = span_in(*it, path, min, max);
    } else if constexpr (is_recipe_list<T>) {
      value.clear();
      for (std::size_t i = 0; i < list_size(*it, path, max); ++i) {
        RecipeReader inner((*it)[i], path + "[" + std::to_string(i) + "]");
        each_field(value.emplace_back(), inner);
        inner.refuse_unknown();
      }
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = static_cast<T>(number_in(*it, path, std::is_integral_v<T>, min, max));
    } else {
      RecipeReader inner(*it, path);
      each_field(value, inner);
      inner.refuse_unknown();
    }
  }

  void refuse_unknown() const;

 private:
  std::string path_of(const std::string& name) const { return path_.empty() ? name : path_ + "." + name; }
  static std::string text_in(const nlohmann::json& json, const std::string& path);
  static std::size_t choice_in(const nlohmann::json& json, const std::string& path,
                               std::span<const std::string_view> names);
  static double number_in(const nlohmann::json& json, const std::string& path, bool whole, double min, double max);
  static std::size_t list_size(const nlohmann::json& json, const std::string& path, double max);
  static PlantPositions positions_in(const nlohmann::json& json, const std::string& path);
  static Span span_in(const nlohmann::json& json, const std::string& path, double min, double max);

  const nlohmann::json& json_;
  std::string path_;
  std::set<std::string> known_;
};

class RecipeWriter {
 public:
  explicit RecipeWriter(nlohmann::json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, const T& value, double, double) {
    if constexpr (ChoiceEnum<T>) {
      json_[name] = choice_name(value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      json_[name] = value;
    } else if constexpr (std::is_same_v<T, Span>) {
      json_[name] = {value.min, value.max};
    } else if constexpr (is_recipe_list<T>) {
      json_[name] = nlohmann::json::array();
      for (const auto& entry : value) {
        nlohmann::json inner = nlohmann::json::object();
        each_field(entry, RecipeWriter(inner));
        json_[name].push_back(std::move(inner));
      }
    } else {
      nlohmann::json inner = nlohmann::json::object();
      each_field(value, RecipeWriter(inner));
      json_[name] = std::move(inner);
    }
  }

 private:
  nlohmann::json& json_;
};

template <class Recipe>
Recipe recipe_from_json(const nlohmann::json& json) {
  Recipe recipe;
  RecipeReader reader(json, "");
  each_field(recipe, reader);
  reader.refuse_unknown();
  return recipe;
}

// Names of the recipes in resources/`folder`, sorted.
std::vector<std::string> recipe_names(const std::string& folder);

// `name_or_path`: a name in resources/`folder`, or a path, which has a slash or ends in .json.
std::filesystem::path find_recipe(const std::string& folder, const std::string& name_or_path);

nlohmann::json read_recipe_json(const std::filesystem::path& file);

// What `parse` makes of the file; its errors tell which file.
template <class Parse>
auto parse_recipe_file(const std::filesystem::path& file, Parse&& parse) {
  const auto json = read_recipe_json(file);
  try {
    return parse(json);
  } catch (const Error& e) {
    throw e.at(file.string());
  }
}

}  // namespace bole::sim
