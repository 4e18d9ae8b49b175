#include "behaviors/run_behavior.h"

#include <vtkDataObject.h>

#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/vtkBoleStage.h"

namespace bole::desktop {
namespace {

// The outputs of all stages that ran, as core data. Called in the worker: stored results are read here.
Results collect(const PipelineExecutor& executor, const RunOutcome& outcome) {
  Results results;
  for (const auto& stage : outcome.stages) {
    if (stage.state != StageState::done && stage.state != StageState::from_cache) continue;
    auto* object = executor.stage(stage.record.id);
    if (!object) continue;
    for (const auto& port : object->GetType()->outputs) {
      if (port.kind == DataKind::frames) continue;
      const auto data = attached(object->GetOutputDataObject(object->FindOutputPort(port.name.c_str())));
      if (data) results[stage.record.id].set(port.name, data->get());
    }
  }
  return results;
}

// The index of the points is made here too, for it takes seconds on a large cloud. What a cancelled run left is not
// shown: the views keep what they have.
Survey survey_to_show(const RunOutcome& outcome, const Results& results, const Survey& before,
                      const std::stop_token& cancel) {
  Run run;
  run.cancel = cancel;
  try {
    return survey_of(outcome, results, before, run);
  } catch (const Error&) {
    return before;
  }
}

}  // namespace

RunBehavior::RunBehavior(Session& session, QObject* parent) : QObject(parent), session_(session) {}

RunBehavior::~RunBehavior() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void RunBehavior::start(const QString& output_dir, bool sinks) {
  if (running_) return;
  if (thread_.joinable()) thread_.join();
  running_ = true;
  executor_ = std::make_unique<PipelineExecutor>(session_.document());
  thread_ = std::jthread([this, output_dir, sinks, before = survey_](std::stop_token cancel_token) {
    RunSettings settings;
    settings.output_dir = output_dir.toStdString();
    settings.cancel = cancel_token;
    settings.sinks = sinks;
    settings.progress = [this](const std::string& stage, double fraction, std::string_view what) {
      Q_EMIT progressed(QString::fromStdString(stage), fraction,
                        QString::fromUtf8(what.data(), static_cast<int>(what.size())));
    };
    auto outcome = executor_->run(settings);
    auto results = collect(*executor_, outcome);
    auto survey = survey_to_show(outcome, results, before, cancel_token);
    QMetaObject::invokeMethod(
        this,
        [this, outcome = std::move(outcome), results = std::move(results), survey = std::move(survey)] {
          running_ = false;
          survey_ = survey;
          Q_EMIT finished(outcome, results);
        },
        Qt::QueuedConnection);
  });
}

void RunBehavior::finish() {
  if (running_) executor_->finish_running_stage();
}

void RunBehavior::cancel() { thread_.request_stop(); }

}  // namespace bole::desktop
