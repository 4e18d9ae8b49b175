// Whether what a lesson names exists: commands and panels of the window, stages, options and outputs of its pipelines,
// names in its expressions.
#pragma once

#include <QStringList>

#include "features/lesson/lesson.h"

namespace bole::desktop {

struct WindowNames {
  QStringList commands, panels;
};

// Throws Error{bad_input} that names the lesson, the step, what was found and what was needed.
void check_lesson(const Lesson& lesson, const WindowNames& names);

}  // namespace bole::desktop
