#include "features/lesson/lesson_needs.h"

#include <algorithm>

#include "document/stage_roles.h"
#include "document/stage_words.h"
#include "features/lesson/lesson_files.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

struct NamedOption {
  const pipeline::StageNode* node;
  const OptionSpec* spec;
};

// Null where the document that is open has no such stage.
NamedOption option_of(const LessonNeed& need, Workbench& bench) {
  if (!bench.session().has_document()) return {};
  const auto [stage, option] = pipeline::parse_source(need.name);
  const auto& stages = bench.session().document().stages();
  const auto it = std::ranges::find(stages, stage, &pipeline::StageNode::id);
  if (it == stages.end()) return {};
  return {&*it, it->type->options->find(option)};
}

bool has_edits(const pipeline::PipelineDocument& document) {
  return std::ranges::any_of(document.stages(), [](const auto& node) {
    return takes_edits(*node.type) && !node.options.is_default(edits_option);
  });
}

QString option_words(const LessonNeed& need, const NamedOption& option) {
  if (!option.spec) return QString::fromStdString(need.name + " = " + need.value);
  const QString unit = QString::fromStdString(std::string(unit_symbol(option.spec->unit)));
  const auto value = option.spec->parsed(need.value);
  const QString shown = value_words(*option.spec, value);
  return Workbench::tr("%1: set '%2' to %3")
      .arg(stage_title(*option.node->type), option_label(*option.node->type, *option.spec),
           unit.isEmpty() || option.spec->is_unset(value) ? shown : shown + " " + unit);
}

}  // namespace

bool is_lesson_document_open(const LessonPlace& place, const std::string& document) {
  return place.bench.session().has_document() &&
         place.bench.session().path() == lesson_document_path(place.lesson, document);
}

bool is_met(const LessonNeed& need, const LessonPlace& place) {
  auto& session = place.bench.session();
  if (!session.has_document()) return false;
  switch (need.kind) {
    case LessonNeed::Kind::document:
      return is_lesson_document_open(place, need.name);
    case LessonNeed::Kind::option: {
      const auto option = option_of(need, place.bench);
      return option.spec && option.node->options.get(option.spec->name) == option.spec->parsed(need.value);
    }
    case LessonNeed::Kind::run:
      return place.ran == session.document().to_json();
    case LessonNeed::Kind::tree:
      return place.bench.selection().tree().has_value();
    case LessonNeed::Kind::edit:
      return has_edits(session.document());
  }
  return false;
}

QString need_words(const LessonNeed& need, const LessonPlace& place) {
  switch (need.kind) {
    case LessonNeed::Kind::document:
      return Workbench::tr("Open the data of this step (Show me)");
    case LessonNeed::Kind::option:
      return option_words(need, option_of(need, place.bench));
    case LessonNeed::Kind::run:
      return Workbench::tr("Run (Shift+F5), and wait until the run has ended");
    case LessonNeed::Kind::tree:
      return Workbench::tr("Select a tree in the table");
    case LessonNeed::Kind::edit:
      return Workbench::tr("Correct a result by hand");
  }
  return {};
}

bool meet(const LessonNeed& need, const LessonPlace& place) {
  auto& bench = place.bench;
  switch (need.kind) {
    case LessonNeed::Kind::option: {
      const auto [stage, option] = pipeline::parse_source(need.name);
      const auto& spec = bench.session().document().at(stage).type->options->at(option);
      bench.session().set_option(stage, option, spec.parsed(need.value));
      return true;
    }
    case LessonNeed::Kind::run:
      bench.run_without_files();
      return true;
    case LessonNeed::Kind::tree: {
      const auto& stems = bench.runner().survey().stems;
      if (!stems || stems->rows() == 0) throw bad_input("the run gave no trees", "one that can be selected");
      bench.selection().select(stems->integers("tree_id").front());
      return true;
    }
    default:
      return false;
  }
}

bool show_option(const LessonNeed& need, const LessonPlace& place) {
  if (need.kind != LessonNeed::Kind::option) return false;
  const auto option = option_of(need, place.bench);
  if (!option.spec) return false;
  if (option.spec->tier != Tier::basic) place.bench.properties().set_tier(option.spec->tier);
  place.bench.pipeline().select_stage(QString::fromStdString(option.node->id));
  return true;
}

}  // namespace bole::desktop
