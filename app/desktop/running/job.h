// One run of a document: waiting, under way or over.
#pragma once

#include <QDateTime>
#include <QString>
#include <chrono>
#include <memory>
#include <optional>

#include "document/survey.h"
#include "pipeline/document.h"
#include "vtkbridge/executor.h"

namespace bole::desktop {

enum class JobState { waiting, running, done, kept, failed, cancelled };
QString job_state_text(JobState state);

// What a run gave.
struct JobResult {
  vtkbridge::RunOutcome outcome;
  Results results;
  Survey survey;  // empty: nothing new to look at
};

struct Job {
  using Clock = std::chrono::steady_clock;

  int id = 0;
  QString title;    // of the document
  QString changes;  // options that differ from those of the run before, "slam.preset = loam"
  std::shared_ptr<const pipeline::PipelineDocument> document;  // as it stood when the run was asked for
  QString path;    // where the session kept the document; empty of one that is fetched
  int opened = 0;  // how many documents were opened until then, this one included
  QString output_dir;
  bool sinks = true;  // stages that write files run too
  bool asked = true;  // by a person, and not to show an edit
  QDateTime asked_at;

  JobState state = JobState::waiting;
  QString stage;        // in work
  double fraction = 0;  // of that stage
  QString what;
  bool ending = false;  // a person keeps what that stage has
  std::size_t stages_begun = 0, stages = 0;
  Clock::time_point began, stage_began, ended;
  std::optional<double> later_s;  // that the stages after this one took last time, when all of them are known

  vtkbridge::RunOutcome outcome;           // of a run that is over
  std::shared_ptr<const JobResult> whole;  // kept where the cache does not have it: of a run that was ended early

  bool over() const { return state != JobState::waiting && state != JobState::running; }
  bool has_result() const { return state == JobState::done || state == JobState::kept; }
  double elapsed_s(Clock::time_point now) const;
  // Of the stage in work and, when `later_s` is known, of those after it; nothing before there is something to go by,
  // nor while the stage ends early.
  std::optional<double> left_s(Clock::time_point now) const;
};

// "3 s", "2:05 min", "1:02:03 h".
QString duration_text(double seconds);

// An option that has another value in `after`; of stages that both have.
struct OptionChange {
  std::string stage, option, before, after;
};
std::vector<OptionChange> changed_options(const pipeline::PipelineDocument& before,
                                          const pipeline::PipelineDocument& after);

// "slam.preset = loam, slice.height = 1.4"; long values are shortened.
QString changes_text(const std::vector<OptionChange>& changes);

}  // namespace bole::desktop
