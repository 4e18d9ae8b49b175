// Entries of JSON files that people write by hand: an error names the entry, what it holds and what is needed.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

using Json = nlohmann::json;

inline std::string shown(const Json& value) {
  auto text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

// Throws Error{bad_input} where the text is no JSON object, or nested too deeply.
inline Json parse_object(Bytes text, const std::string& needed) {
  constexpr int max_depth = 64;
  bool deep = false;
  const auto shallow = [&deep](int depth, Json::parse_event_t, Json&) {
    deep = deep || depth > max_depth;
    return !deep;
  };
  if (text.empty()) throw bad_input("the file is empty", needed);
  auto json = Json::parse(text.begin(), text.end(), shallow, false);
  if (deep || !json.is_object()) throw bad_input("the file is no JSON object, or it is cut off", needed);
  return json;
}

inline bool holds(const Json& object, const char* name) {
  const auto it = object.find(name);
  return it != object.end() && !it->is_null();
}

inline double number_at(const Json& object, const char* name) {
  if (!holds(object, name)) throw bad_input("the entry '" + std::string(name) + "' is missing", "a number");
  const auto& value = object[name];
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw bad_input("the entry '" + std::string(name) + "' is " + shown(value), "a number");
  return value.get<double>();
}

inline double number_or(const Json& object, const char* name, double otherwise) {
  return holds(object, name) ? number_at(object, name) : otherwise;
}

inline int whole_number_at(const Json& object, const char* name) {
  const double value = number_at(object, name);
  if (value != std::floor(value) || std::abs(value) > 1e9)
    throw bad_input("the entry '" + std::string(name) + "' is " + shown(object[name]), "a whole number");
  return static_cast<int>(value);
}

inline std::string text_at(const Json& object, const char* name, const std::string& otherwise = {}) {
  if (!holds(object, name)) return otherwise;
  if (!object[name].is_string())
    throw bad_input("the entry '" + std::string(name) + "' is " + shown(object[name]), "a text");
  return object[name].get<std::string>();
}

// The numbers of a list, lists within it laid end to end.
inline std::vector<double> numbers_of(const Json& value, const std::string& name, const std::string& needed) {
  std::vector<double> out;
  const auto refuse = [&] { return bad_input("the entry '" + name + "' is " + shown(value), needed); };
  const auto take = [&](const Json& v) {
    if (!v.is_number() || !std::isfinite(v.get<double>())) throw refuse();
    out.push_back(v.get<double>());
  };
  if (!value.is_array() || value.size() > 4096) throw refuse();
  for (const auto& row : value) {
    if (!row.is_array()) {
      take(row);
      continue;
    }
    if (row.size() > 4096) throw refuse();
    for (const auto& v : row) take(v);
  }
  return out;
}

}  // namespace bole::io
