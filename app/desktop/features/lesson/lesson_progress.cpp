#include "features/lesson/lesson_progress.h"

#include <QSettings>
#include <QStringList>

namespace bole::desktop {
namespace {

QString question_name(int step, int question) { return QString("%1.%2").arg(step).arg(question); }

}  // namespace

LessonProgress::LessonProgress(const std::string& lesson) : lesson_(QString::fromStdString(lesson)) {}

QString LessonProgress::key(const char* name) const { return "lessons/" + lesson_ + "/" + name; }

int LessonProgress::step() const { return QSettings().value(key("step"), 0).toInt(); }

void LessonProgress::set_step(int step) { QSettings().setValue(key("step"), step); }

bool LessonProgress::right(int step, int question) const {
  return QSettings().value(key("right")).toStringList().contains(question_name(step, question));
}

void LessonProgress::set_right(int step, int question) {
  QSettings settings;
  auto list = settings.value(key("right")).toStringList();
  if (const auto name = question_name(step, question); !list.contains(name)) list << name;
  settings.setValue(key("right"), list);
}

int LessonProgress::right_count() const { return QSettings().value(key("right")).toStringList().size(); }

std::map<std::string, double> LessonProgress::kept() const {
  std::map<std::string, double> values;
  const auto kept = QSettings().value(key("kept")).toMap();
  for (auto it = kept.begin(); it != kept.end(); ++it) values[it.key().toStdString()] = it.value().toDouble();
  return values;
}

void LessonProgress::keep(const std::string& name, double value) {
  QSettings settings;
  auto kept = settings.value(key("kept")).toMap();
  kept[QString::fromStdString(name)] = value;
  settings.setValue(key("kept"), kept);
}

void LessonProgress::forget() { QSettings().remove("lessons/" + lesson_); }

}  // namespace bole::desktop
