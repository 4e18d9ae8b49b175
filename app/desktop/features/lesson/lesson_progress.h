// How far a student is, in the settings of the program.
#pragma once

#include <QString>
#include <map>
#include <string>

namespace bole::desktop {

class LessonProgress {
 public:
  explicit LessonProgress(const std::string& lesson);

  int step() const;
  void set_step(int step);
  bool right(int step, int question) const;  // it was answered rightly
  void set_right(int step, int question);
  int right_count() const;
  std::map<std::string, double> kept() const;  // numbers that earlier steps kept
  void keep(const std::string& name, double value);
  void forget();

 private:
  QString key(const char* name) const;
  QString lesson_;
};

}  // namespace bole::desktop
