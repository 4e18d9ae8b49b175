// Runs the document in a thread of its own, so that the window never waits; signals arrive in the thread of the window.
#pragma once

#include <QObject>
#include <memory>
#include <stop_token>
#include <thread>

#include "document/session.h"
#include "document/survey.h"
#include "vtkbridge/executor.h"

namespace bole::desktop {

class RunBehavior : public QObject {
  Q_OBJECT

 public:
  explicit RunBehavior(Session& session, QObject* parent);
  ~RunBehavior() override;  // cancels and waits

  bool running() const { return running_; }
  // `sinks`: stages that write files run too.
  void start(const QString& output_dir, bool sinks = true);
  void finish();  // keep the best so far of the running stage
  void cancel();
  const Survey& survey() const { return survey_; }  // of the last run that ended
  void forget_survey() { survey_ = {}; }

 Q_SIGNALS:
  void progressed(const QString& stage, double fraction, const QString& what);
  void finished(const RunOutcome& outcome, const Results& results);

 private:
  Session& session_;
  std::unique_ptr<PipelineExecutor> executor_;
  std::jthread thread_;
  Survey survey_;
  bool running_ = false;
};

}  // namespace bole::desktop
