#include "running/stage_states.h"

#include <QCryptographicHash>
#include <algorithm>
#include <functional>

#include "document/session.h"
#include "look/finding_words.h"
#include "pipeline/skipped_stages.h"
#include "running/runner.h"

namespace bole::desktop {
namespace {

using pipeline::PipelineDocument;
using pipeline::StageNode;

const StageNode* stage_of(const PipelineDocument& document, const std::string& id) {
  const auto& stages = document.stages();
  const auto it = std::ranges::find(stages, id, &StageNode::id);
  return it == stages.end() ? nullptr : &*it;
}

// Of each stage: its type, its options and the same of all stages that it takes from. Names do not count.
std::map<std::string, QByteArray> keys_of(const PipelineDocument& document) {
  std::map<std::string, QByteArray> keys;
  const std::function<QByteArray(const StageNode&)> key_of = [&](const StageNode& node) {
    if (const auto known = keys.find(node.id); known != keys.end()) return known->second;
    keys[node.id] = {};  // ends a circle
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const auto add = [&](const std::string& text) {
      hash.addData(text.data(), static_cast<int>(text.size()));
      hash.addData("\0", 1);
    };
    add(node.type->name);
    add(pipeline::is_skipped(document, node) ? "skipped" : "");
    for (const auto& spec : node.type->options->specs) add(option_text(node.options.get(spec.name)));
    for (const auto& [port, source] : node.inputs) {
      const auto dot = std::min(source.find('.'), source.size());
      const auto* from = stage_of(document, source.substr(0, dot));
      add(port + source.substr(dot));
      if (from != nullptr) hash.addData(key_of(*from));
    }
    return keys[node.id] = hash.result();
  };
  for (const auto& node : document.stages()) key_of(node);
  return keys;
}

}  // namespace

StageMark mark_of(StageState::Kind kind) {
  switch (kind) {
    case StageState::Kind::running:
      return StageMark::running;
    case StageState::Kind::done:
      return StageMark::done;
    case StageState::Kind::warnings:
    case StageState::Kind::cannot_run:
      return StageMark::warning;
    case StageState::Kind::failed:
      return StageMark::failed;
    case StageState::Kind::out_of_date:
      return StageMark::outdated;
    case StageState::Kind::not_run:
    case StageState::Kind::skipped:
      break;
  }
  return StageMark::idle;
}

QString state_words(const StageState& state) {
  switch (state.kind) {
    case StageState::Kind::not_run:
      return {};
    case StageState::Kind::running:
      return StageStates::tr("running");
    case StageState::Kind::done:
      return StageStates::tr("done");
    case StageState::Kind::warnings:
      return StageStates::tr("%n warning(s)", nullptr, static_cast<int>(state.warnings.size()));
    case StageState::Kind::failed:
      return StageStates::tr("failed");
    case StageState::Kind::out_of_date:
      return StageStates::tr("out of date");
    case StageState::Kind::cannot_run:
      return StageStates::tr("cannot run");
    case StageState::Kind::skipped:
      return StageStates::tr("skipped");
  }
  return {};
}

QString seconds_words(double seconds) {
  return seconds < 9.95 ? StageStates::tr("%1 s").arg(seconds, 0, 'f', 1) : duration_text(seconds);
}

QString state_details(const StageState& state) {
  QStringList lines;
  if (!state.message.isEmpty()) lines << finding_words(state.message);
  for (const auto& warning : state.warnings) lines << finding_words(warning);
  if (state.seconds) lines << StageStates::tr("Took %1.").arg(seconds_words(*state.seconds));
  return lines.join('\n');
}

StageStates::StageStates(const Session& session, const Runner& runner, QObject* parent)
    : QObject(parent), session_(session), runner_(runner) {
  connect(&session_, &Session::document_replaced, this, &StageStates::look_at_document);
  connect(&session_, &Session::option_changed, this, &StageStates::look_at_document);
  connect(&runner_, &Runner::progressed, this, &StageStates::progress);
  connect(&runner_, &Runner::job_ended, this, QOverload<int>::of(&StageStates::take));
}

void StageStates::look_at_document() {
  keys_ = keys_of(session_.document());
  problems_.clear();
  for (const auto& problem : pipeline::validate(session_.document())) problems_[problem.stage] = problem.message;
  Q_EMIT changed();
}

void StageStates::forget() {
  last_.clear();
  passed_.clear();
  running_.clear();
  ignored_ = runner_.jobs().empty() ? 0 : runner_.jobs().back()->id;
  Q_EMIT changed();
}

void StageStates::progress(const QString& stage, double fraction, const QString& what) {
  const int job = runner_.current() ? runner_.current()->id : 0;
  const std::string before = running_;
  if (job != job_) passed_.clear();
  if (job == job_ && running_ != stage.toStdString()) passed_.insert(running_);
  job_ = job;
  running_ = stage.toStdString();
  fraction_ = fraction;
  what_ = what;
  if (!before.empty() && before != running_) Q_EMIT stage_changed(QString::fromStdString(before));
  Q_EMIT stage_changed(stage);
}

// Of a run of the document in hand: not of one that is fetched to be looked at.
void StageStates::take(int id) {
  const auto job = runner_.job(id);
  if (!job || id <= ignored_ || job->path.isEmpty()) return;
  running_.clear();
  passed_.clear();
  job_ = 0;
  const auto keys = keys_of(*job->document);
  for (const auto& stage : job->outcome.stages) take(stage, keys.at(stage.record.id));
  Q_EMIT changed();
}

// Stages that were left out or cancelled keep what they had before; those whose inputs failed have nothing.
void StageStates::take(const vtkbridge::StageOutcome& stage, const QByteArray& key) {
  const auto& report = stage.record.report;
  StageState state;
  state.message = QString::fromStdString(stage.error.empty() ? report.message : stage.error);
  for (const auto& warning : report.warnings) state.warnings << QString::fromStdString(warning);
  switch (stage.state) {
    case vtkbridge::StageState::done:
    case vtkbridge::StageState::from_cache:
      state.kind = report.warnings.empty() ? StageState::Kind::done : StageState::Kind::warnings;
      state.seconds = report.seconds;
      break;
    case vtkbridge::StageState::failed:
      state.kind = StageState::Kind::failed;
      break;
    case vtkbridge::StageState::skipped:
      if (stage.error.empty()) return;
      break;
    case vtkbridge::StageState::cancelled:
      return;
  }
  last_[stage.record.id] = {key, state};
}

// A stage that was renamed or copied is known by what it does.
const StageStates::Last* StageStates::last(const std::string& id) const {
  const auto own = last_.find(id);
  const auto& key = keys_.at(id);
  if (own != last_.end() && own->second.key == key) return &own->second;
  for (const auto& [other, result] : last_)
    if (result.key == key) return &result;
  return own == last_.end() ? nullptr : &own->second;
}

StageState StageStates::of(const std::string& id) const {
  const auto* node = session_.has_document() ? stage_of(session_.document(), id) : nullptr;
  if (node == nullptr || !keys_.contains(id)) return {};
  StageState state;
  if (id == running_) {
    state.kind = StageState::Kind::running;
    state.fraction = fraction_;
    state.message = what_;
    return state;
  }
  if (const auto problem = problems_.find(id); problem != problems_.end()) {
    state.kind = StageState::Kind::cannot_run;
    state.message = QString::fromStdString(problem->second);
    return state;
  }
  if (pipeline::is_skipped(session_.document(), *node)) {
    state.kind = StageState::Kind::skipped;
    state.message = tr("This stage runs when its file is given.");
    return state;
  }
  if (passed_.contains(id)) {
    state.kind = StageState::Kind::done;
    return state;
  }
  const auto* result = last(id);
  if (result == nullptr) return {};
  state = result->state;
  if (state.kind == StageState::Kind::not_run || result->key == keys_.at(id)) return state;
  state = {};
  state.kind = StageState::Kind::out_of_date;
  state.message = tr("Something that this stage depends on was changed since it ran. Run the pipeline.");
  return state;
}

}  // namespace bole::desktop
