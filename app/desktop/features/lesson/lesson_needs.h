// What a step needs, looked up in the window, and done for the student.
#pragma once

#include <QString>

#include "features/lesson/lesson.h"

namespace bole::desktop {

class Workbench;

struct LessonPlace {
  Workbench& bench;
  const Lesson& lesson;
  const std::string& ran;  // the document that the last run was of, as JSON
};

bool is_lesson_document_open(const LessonPlace& place, const std::string& document);
bool is_met(const LessonNeed& need, const LessonPlace& place);
QString need_words(const LessonNeed& need, const LessonPlace& place);

// Of an option, a run and a tree. Throws bole::Error; false for what only the student can do.
bool meet(const LessonNeed& need, const LessonPlace& place);

// Selects the stage of the option, so that the panel of options shows where it can be set; false for other needs.
bool show_option(const LessonNeed& need, const LessonPlace& place);

}  // namespace bole::desktop
