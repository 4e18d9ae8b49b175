// One object of a lesson file: its keys by kind; errors name the place.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace bole::desktop {

class LessonObject {
 public:
  using Json = nlohmann::json;

  // `place`: "steps[2].questions[0]", for errors.
  LessonObject(const Json& json, std::string place, std::string lesson);

  bool has(const char* key) const { return json_.contains(key); }
  // Throw Error{bad_input} when the key is absent or of another kind. `get_text` refuses an empty text.
  std::string get_text(const char* key);
  double get_number(const char* key);
  bool get_flag(const char* key, bool otherwise);
  std::string text_or(const char* key, const std::string& otherwise);
  double number_or(const char* key, double otherwise);
  // Empty where the key is absent.
  std::vector<std::string> texts(const char* key);
  std::map<std::string, std::string> words(const char* key);  // of an object; numbers and flags become texts
  std::vector<LessonObject> objects(const char* key);
  std::vector<std::pair<std::string, LessonObject>> named_objects(const char* key);

  // After the last key: throws for one that was not asked for.
  void refuse_unknown() const;
  // An error about this object.
  [[noreturn]] void refuse(const std::string& found, const std::string& needed) const;

 private:
  const Json* find(const char* key);
  const Json& need(const char* key, const char* kind);
  std::string at(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }
  [[noreturn]] void wrong(const std::string& key, const Json& found, const std::string& needed) const;

  const Json& json_;
  std::string place_, lesson_;
  std::set<std::string> known_;
};

}  // namespace bole::desktop
