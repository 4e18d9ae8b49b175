// Texts of lessons in the language of the window. The lesson files hold the English ones, by which the translations in
// i18n/lessons_*.ts are found.
#pragma once

#include <QString>
#include <QStringList>

#include "features/lesson/lesson.h"

namespace bole::desktop {

inline constexpr const char* lesson_context = "lessons";

QString lesson_text(const std::string& english);
// Everything that a student reads, in English: what a translation must have.
std::vector<std::string> lesson_texts(const Lesson& lesson);

}  // namespace bole::desktop
