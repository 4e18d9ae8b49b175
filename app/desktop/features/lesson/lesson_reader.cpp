#include "features/lesson/lesson_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "base/resources.h"
#include "features/lesson/lesson_json.h"

namespace bole::desktop {
namespace {

constexpr std::array<const char*, 7> statistic_names{"value", "sum", "mean", "median", "min", "max", "count"};

CellStatistic statistic_named(LessonObject& object) {
  const auto name = object.text_or("statistic", "value");
  const auto* it = std::ranges::find(statistic_names, name);
  if (it == statistic_names.end())
    object.refuse("the statistic is '" + name + "'", "value, sum, mean, median, min, max or count");
  return static_cast<CellStatistic>(it - statistic_names.begin());
}

LessonNumber read_number(LessonObject object) {
  LessonNumber number;
  number.measure = object.text_or("measure", "");
  if (number.measure.empty()) {
    number.table = object.get_text("table");
    number.column = object.get_text("column");
    number.where = object.words("where");
    number.statistic = statistic_named(object);
  }
  object.refuse_unknown();
  for (const auto& name : {number.measure, number.table})
    if (!name.empty() && name.find('.') == std::string::npos)
      object.refuse("'" + name + "' has no dot", "STAGE.NAME, for instance rows.missing");
  return number;
}

std::vector<LessonChoice> read_choices(LessonObject& question) {
  std::vector<LessonChoice> choices;
  for (auto& object : question.objects("choices")) {
    choices.push_back({object.get_text("text"), object.get_text("why"), object.get_flag("right", false)});
    object.refuse_unknown();
  }
  const auto right = std::ranges::count(choices, true, &LessonChoice::right);
  if (question.has("choices") && (right != 1 || choices.size() < 2))
    question.refuse(std::to_string(choices.size()) + " choices, of which " + std::to_string(right) + " are right",
                    "two choices or more, one of them with \"right\": true");
  return choices;
}

LessonQuestion read_question(LessonObject object) {
  LessonQuestion question;
  question.ask = object.get_text("ask");
  if (object.has("choices") == object.has("answer"))
    object.refuse(object.has("answer") ? "the question has choices and an answer" : "the question has no answer",
                  "choices, or an answer (an expression) with a tolerance");
  question.choices = read_choices(object);
  if (object.has("answer")) {
    question.answer = object.get_text("answer");
    question.unit = object.text_or("unit", "");
    question.tolerance = object.get_number("tolerance");
    question.why = object.get_text("why");
    question.hint = object.get_text("hint");
    if (!(question.tolerance > 0))
      object.refuse("the tolerance is not above 0", "a tolerance in the unit of the answer");
  }
  object.refuse_unknown();
  return question;
}

LessonNeed read_need(LessonObject object) {
  using Kind = LessonNeed::Kind;
  LessonNeed need;
  if (object.has("option")) {
    need = {Kind::option, object.get_text("option"), object.get_text("is")};
  } else {
    const std::pair<const char*, Kind> flags[] = {{"run", Kind::run}, {"tree", Kind::tree}, {"edit", Kind::edit}};
    const auto* it = std::ranges::find_if(flags, [&](const auto& flag) { return object.has(flag.first); });
    if (it == std::end(flags) || !object.get_flag(it->first, false))
      object.refuse("the need is not known", "option and is, or one of run, tree, edit with the value true");
    need.kind = it->second;
  }
  object.refuse_unknown();
  return need;
}

LessonStep read_step(LessonObject object, const Lesson& lesson) {
  LessonStep step;
  step.title = object.get_text("title");
  step.text = object.texts("text");
  if (step.text.empty()) object.refuse("the step has no text", "one paragraph or more");
  const auto document = object.text_or("document", lesson.documents.front().id);
  step.needs.push_back({LessonNeed::Kind::document, lesson.document(document).id, {}});
  for (const auto& need : object.objects("needs")) step.needs.push_back(read_need(need));
  step.commands = object.texts("commands");
  step.panels = object.texts("panels");
  step.keep = object.words("keep");
  for (auto& sight : object.objects("see")) {
    step.see.push_back({sight.get_text("text"), sight.get_text("value"), sight.text_or("unit", ""),
                        static_cast<int>(sight.number_or("decimals", 2))});
    sight.refuse_unknown();
  }
  for (const auto& question : object.objects("questions")) step.questions.push_back(read_question(question));
  object.refuse_unknown();
  return step;
}

void read_documents(LessonObject& root, Lesson& lesson) {
  for (auto& object : root.objects("documents")) {
    lesson.documents.push_back({object.get_text("id"), object.get_text("pipeline"), object.words("set")});
    object.refuse_unknown();
  }
  if (lesson.documents.empty()) root.refuse("the lesson has no documents", "one pipeline or more");
}

}  // namespace

const LessonDocument& Lesson::document(const std::string& name) const {
  const auto it = std::ranges::find(documents, name, &LessonDocument::id);
  if (it == documents.end()) {
    std::string list;
    for (const auto& document : documents) list += (list.empty() ? "" : ", ") + document.id;
    throw bad_input("lesson '" + id + "' has no document '" + name + "'", "one of " + list);
  }
  return *it;
}

std::size_t Lesson::question_count() const {
  std::size_t count = 0;
  for (const auto& step : steps) count += step.questions.size();
  return count;
}

Lesson parse_lesson(std::string_view json, const std::string& id) {
  LessonObject::Json parsed;
  try {
    parsed = LessonObject::Json::parse(json);
  } catch (const LessonObject::Json::exception& e) {
    throw bad_input("lesson '" + id + "' is not JSON: " + e.what(), "a lesson as resources/lessons/README.md has it");
  }
  LessonObject root(parsed, "", id);
  Lesson lesson;
  lesson.id = id;
  lesson.title = root.get_text("title");
  lesson.minutes = static_cast<int>(root.get_number("minutes"));
  lesson.page = root.get_text("page");
  lesson.learn = root.texts("learn");
  if (lesson.learn.empty()) root.refuse("'learn' is empty", "what the student learns, in a sentence or two");
  lesson.data = {root.get_text("data"), root.words("data_options")};
  read_documents(root, lesson);
  for (const auto& [name, object] : root.named_objects("numbers")) lesson.numbers[name] = read_number(object);
  for (const auto& step : root.objects("steps")) lesson.steps.push_back(read_step(step, lesson));
  if (lesson.steps.empty()) root.refuse("the lesson has no steps", "one or more");
  root.refuse_unknown();
  return lesson;
}

std::vector<Lesson> shipped_lessons(std::vector<std::string>& problems) {
  std::vector<Lesson> lessons;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(resource_dir() / "lessons", none)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
      lessons.push_back(parse_lesson(text, entry.path().stem().string()));
    } catch (const Error& e) {
      problems.emplace_back(e.what());
    }
  }
  std::ranges::sort(lessons, {}, &Lesson::title);
  return lessons;
}

}  // namespace bole::desktop
