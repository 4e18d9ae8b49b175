#include "features/lesson/lesson_check.h"

#include <set>

#include "base/error.h"
#include "documents/new_document.h"
#include "features/lesson/lesson_files.h"
#include "features/lesson/lesson_values.h"

namespace bole::desktop {
namespace {

// The sample plot is the pipeline of a forest plot with its files.
pipeline::PipelineDocument pipeline_of(const LessonDocument& document) {
  auto shipped = documents::shipped_pipeline(document.pipeline == "sample_plot" ? "forest_plot" : document.pipeline);
  for (const auto& [name, value] : document.set) shipped.set(name, value);
  return shipped;
}

class Checker {
 public:
  Checker(const Lesson& lesson, const WindowNames& names) : names_(names) {
    for (const auto& document : lesson.documents) documents_.emplace(document.id, pipeline_of(document));
    for (const auto& [name, number] : lesson.numbers) {
      check(number);
      known_[name] = 1;
    }
  }

  void check(const LessonStep& step) {
    const auto& document = documents_.at(step.needs.front().name);
    for (const auto& need : step.needs) check(need, document);
    for (const auto& id : step.commands) refuse_unless(names_.commands, id, "command");
    for (const auto& id : step.panels) refuse_unless(names_.panels, id, "panel");
    for (const auto& [name, expression] : step.keep) check(expression);
    for (const auto& [name, expression] : step.keep) known_[name] = 1;
    for (const auto& sight : step.see) check(sight.value);
    for (const auto& question : step.questions)
      if (question.choices.empty()) check(question.answer);
  }

 private:
  static void refuse_unless(const QStringList& known, const std::string& id, const std::string& kind) {
    if (known.contains(QString::fromStdString(id))) return;
    std::vector<std::string> names;
    for (const auto& name : known) names.push_back(name.toStdString());
    const auto near = nearest_names(id, names, 1);
    throw bad_input("the window has no " + kind + " '" + id + "'", "one of its " + kind + "s",
                    near.empty() ? "" : "Did you mean '" + near.front() + "'?");
  }

  static void check(const LessonNeed& need, const pipeline::PipelineDocument& document) {
    if (need.kind != LessonNeed::Kind::option) return;
    const auto [stage, option] = pipeline::parse_source(need.name);
    document.at(stage).type->options->at(option).parsed(need.value);
  }

  // A number must come from one of the documents.
  void check(const LessonNumber& number) const {
    const auto [stage, name] = pipeline::parse_source(number.measure.empty() ? number.table : number.measure);
    for (const auto& [id, document] : documents_) {
      const auto it = std::ranges::find(document.stages(), stage, &pipeline::StageNode::id);
      if (it == document.stages().end()) continue;
      if (!number.measure.empty()) return;  // measures are known after a run
      const auto* port = it->type->output(name);
      if (port && port->kind == DataKind::table) return;
    }
    throw bad_input("no stage of the lesson gives '" + stage + "." + name + "'", "STAGE.TABLE or STAGE.MEASURE");
  }

  void check(const std::string& expression) const {
    for (const auto& name : names_in_expression(expression))
      if (!known_.contains(name))
        throw bad_input("'" + name + "' in '" + expression + "' is not known",
                        "a name of 'numbers', or one that this step or an earlier one keeps");
  }

  const WindowNames& names_;
  std::map<std::string, pipeline::PipelineDocument> documents_;
  std::map<std::string, double> known_;
};

}  // namespace

void check_lesson(const Lesson& lesson, const WindowNames& names) {
  const std::string place = "lesson '" + lesson.id + "'";
  try {
    check_lesson_data(lesson.data);
    Checker checker(lesson, names);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      try {
        checker.check(lesson.steps[i]);
      } catch (const Error& e) {
        throw e.at("step " + std::to_string(i + 1));
      }
    }
  } catch (const Error& e) {
    throw e.at(place);
  }
}

}  // namespace bole::desktop
