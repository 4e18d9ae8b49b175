#include "features/lesson/lesson_json.h"

#include "base/error.h"
#include "base/option.h"

namespace bole::desktop {

LessonObject::LessonObject(const Json& json, std::string place, std::string lesson)
    : json_(json), place_(std::move(place)), lesson_(std::move(lesson)) {
  if (!json_.is_object()) wrong("", json_, "an object {...}");
}

void LessonObject::refuse(const std::string& found, const std::string& needed) const {
  throw bad_input("lesson '" + lesson_ + "'" + (place_.empty() ? "" : ", " + place_) + ": " + found, needed,
                  "resources/lessons/README.md lists the keys");
}

void LessonObject::wrong(const std::string& key, const Json& found, const std::string& needed) const {
  constexpr std::size_t max_shown = 60;
  refuse((key.empty() ? "it" : "'" + key + "'") + " is " + found.dump().substr(0, max_shown), needed);
}

const nlohmann::json* LessonObject::find(const char* key) {
  known_.insert(key);
  const auto it = json_.find(key);
  return it == json_.end() ? nullptr : &*it;
}

const nlohmann::json& LessonObject::need(const char* key, const char* kind) {
  const auto* found = find(key);
  if (!found) refuse("'" + std::string(key) + "' is missing", kind);
  return *found;
}

std::string LessonObject::get_text(const char* key) {
  const auto& found = need(key, "a text");
  if (!found.is_string() || found.get<std::string>().empty()) wrong(key, found, "a text that is not empty");
  return found.get<std::string>();
}

double LessonObject::get_number(const char* key) {
  const auto& found = need(key, "a number");
  if (!found.is_number()) wrong(key, found, "a number");
  return found.get<double>();
}

bool LessonObject::get_flag(const char* key, bool otherwise) {
  const auto* found = find(key);
  if (!found) return otherwise;
  if (!found->is_boolean()) wrong(key, *found, "true or false");
  return found->get<bool>();
}

std::string LessonObject::text_or(const char* key, const std::string& otherwise) {
  return find(key) ? get_text(key) : otherwise;
}

double LessonObject::number_or(const char* key, double otherwise) { return find(key) ? get_number(key) : otherwise; }

std::vector<std::string> LessonObject::texts(const char* key) {
  std::vector<std::string> list;
  const auto* found = find(key);
  if (!found) return list;
  if (!found->is_array()) wrong(key, *found, "a list of texts");
  for (const auto& entry : *found) {
    if (!entry.is_string()) wrong(key, entry, "a text");
    list.push_back(entry.get<std::string>());
  }
  return list;
}

std::map<std::string, std::string> LessonObject::words(const char* key) {
  std::map<std::string, std::string> list;
  const auto* found = find(key);
  if (!found) return list;
  if (!found->is_object()) wrong(key, *found, "an object of names and values");
  for (const auto& [name, value] : found->items()) {
    if (value.is_structured() || value.is_null()) wrong(name, value, "a text, a number, or true or false");
    list[name] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return list;
}

std::vector<LessonObject> LessonObject::objects(const char* key) {
  std::vector<LessonObject> list;
  const auto* found = find(key);
  if (!found) return list;
  if (!found->is_array()) wrong(key, *found, "a list of objects");
  for (std::size_t i = 0; i < found->size(); ++i)
    list.emplace_back((*found)[i], at(key) + "[" + std::to_string(i) + "]", lesson_);
  return list;
}

std::vector<std::pair<std::string, LessonObject>> LessonObject::named_objects(const char* key) {
  std::vector<std::pair<std::string, LessonObject>> list;
  const auto* found = find(key);
  if (!found) return list;
  if (!found->is_object()) wrong(key, *found, "an object of objects");
  for (const auto& [name, value] : found->items())
    list.emplace_back(name, LessonObject(value, at(key) + "." + name, lesson_));
  return list;
}

void LessonObject::refuse_unknown() const {
  for (const auto& [key, unused] : json_.items()) {
    if (known_.contains(key)) continue;
    const auto near = nearest_names(key, {known_.begin(), known_.end()}, 1);
    refuse("unknown key '" + key + "'", near.empty() ? "a key of a lesson" : "a key such as '" + near.front() + "'");
  }
}

}  // namespace bole::desktop
