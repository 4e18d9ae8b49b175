// A lesson as resources/lessons/NAME.json has it (schema: resources/lessons/README.md). Texts are English; the window
// translates them (lesson_words.h).
#pragma once

#include <map>
#include <string>
#include <vector>

namespace bole::desktop {

// What is taken of the cells of a column: the only one, or a statistic of all.
enum class CellStatistic { value, sum, mean, median, min, max, count };

// A number of the student's own run.
struct LessonNumber {
  std::string measure;                       // "evaluate.dbh_bias": a count or metric of a stage; or
  std::string table, column;                 // "rows.rows", "missing": a column of a table that a stage gave
  std::map<std::string, std::string> where;  // only rows with these cells
  CellStatistic statistic = CellStatistic::value;
};

struct LessonChoice {
  std::string text, why;
  bool right = false;
};

struct LessonQuestion {
  std::string ask;
  std::vector<LessonChoice> choices;  // empty: a number is asked for
  std::string answer;                 // an expression of numbers and kept values
  std::string unit;
  double tolerance = 0;   // in that unit
  std::string why, hint;  // said when the number is right, and when it is wrong
};

// What must be true before the student goes on.
struct LessonNeed {
  enum class Kind { document, option, run, tree, edit };
  Kind kind = Kind::run;
  std::string name;   // of the document, or "stage.option"
  std::string value;  // of the option, as a text
};

// A number of the run that a step shows.
struct LessonSight {
  std::string text, value, unit;  // value: an expression
  int decimals = 2;
};

struct LessonStep {
  std::string title;
  std::vector<std::string> text;            // paragraphs
  std::vector<LessonNeed> needs;            // the document of the step first
  std::vector<std::string> commands;        // that "Show me" runs when the needs are met
  std::vector<std::string> panels;          // that "Show me" brings to the front
  std::map<std::string, std::string> keep;  // values that later steps compare with: name, expression
  std::vector<LessonSight> see;
  std::vector<LessonQuestion> questions;
};

// A command of `bole` that makes the data: simulate, simulate-field, or sample_plot for that of the window.
struct LessonData {
  std::string command;
  std::map<std::string, std::string> options;
};

struct LessonDocument {
  std::string id, pipeline;                // one that comes with Bole, or sample_plot
  std::map<std::string, std::string> set;  // "stage.option": value; paths lead from the folder of the data
};

struct Lesson {
  std::string id, title;
  int minutes = 0;
  std::string page;                // in docs/user, which the lesson follows
  std::vector<std::string> learn;  // sentences
  LessonData data;
  std::vector<LessonDocument> documents;
  std::map<std::string, LessonNumber> numbers;
  std::vector<LessonStep> steps;

  const LessonDocument& document(const std::string& name) const;  // throws Error{bad_input}
  std::size_t question_count() const;
};

}  // namespace bole::desktop
