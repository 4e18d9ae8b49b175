// Reads lessons.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "features/lesson/lesson.h"

namespace bole::desktop {

// Throws Error{bad_input} that names the lesson, the place in it, what was found and what was needed: not JSON, unknown
// or missing keys, wrong kinds, a question without an answer, a document or value that the lesson does not define.
// Names of stages, options and commands are checked by check_lesson() (lesson_check.h).
Lesson parse_lesson(std::string_view json, const std::string& id);

// Those of resources/lessons, by title. One that cannot be read is left out; `problems` gets the sentence.
std::vector<Lesson> shipped_lessons(std::vector<std::string>& problems);

}  // namespace bole::desktop
