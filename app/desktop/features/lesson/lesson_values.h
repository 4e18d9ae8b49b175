// Numbers of a run, and expressions of them.
#pragma once

#include <map>
#include <string>

#include "document/survey.h"
#include "features/lesson/lesson.h"

namespace bole::desktop {

// What the last run of the student gave.
struct LessonRun {
  vtkbridge::RunOutcome outcome;
  Results results;
};

// Throws Error{bad_input} when the run has no such stage, measure, table, column or row.
double lesson_number(const LessonNumber& number, const LessonRun& run);

// Expressions have + - * / ^, brackets, sqrt, abs, min, max (of vtkFunctionParser) and names of values.
// Throws Error{bad_input} when it cannot be read, a name has no value, or the result is no number.
double lesson_value(const std::string& expression, const std::map<std::string, double>& values);

// The names in an expression, functions left out.
std::vector<std::string> names_in_expression(const std::string& expression);

}  // namespace bole::desktop
