#include "running/runner.h"

#include <vtkDataObject.h>

#include <algorithm>
#include <utility>

#include "running/preview_channel.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/vtkBoleStage.h"

namespace bole::desktop {
namespace {

constexpr std::size_t max_jobs = 100;
// What changes in the window makes it put its 3-D view on the screen anew: with software OpenGL that is work.
constexpr std::chrono::milliseconds progress_gap{150};

// The outputs of all stages that ran, as core data. Called in the worker: stored results are read here, unless only
// those are asked for that are in memory.
Results collect(const vtkbridge::PipelineExecutor& executor, const vtkbridge::RunOutcome& outcome,
                bool in_memory = false) {
  Results results;
  for (const auto& stage : outcome.stages) {
    if (stage.state != vtkbridge::StageState::done && stage.state != vtkbridge::StageState::from_cache) continue;
    auto* object = executor.stage(stage.record.id);
    if (!object) continue;
    for (const auto& port : object->GetType()->outputs) {
      if (vtkbridge::has_steps(port.kind)) continue;
      auto* output = object->GetOutputDataObject(object->FindOutputPort(port.name.c_str()));
      const auto data = output ? vtkbridge::attached(output) : nullptr;  // none of a stage that was left out
      if (data && (!in_memory || data->loaded())) results[stage.record.id].set(port.name, data->get());
    }
  }
  return results;
}

// The index of the points is made here too, for it takes seconds on a large cloud; that of `seen`, when they are the
// same. Empty when the run was cancelled or gave nothing to look at.
Survey survey_to_show(const vtkbridge::RunOutcome& outcome, const Results& results, const Survey& seen,
                      const std::stop_token& cancel) {
  if (outcome.exit_code == 3) return {};
  Run run;
  run.cancel = cancel;
  try {
    return survey_of(outcome, results, seen, [&](const auto& points) {
      return seen.points && seen.index && same_places(*points, *seen.points)
                 ? seen.index
                 : std::make_shared<const PointIndex>(points, run);
    });
  } catch (const Error&) {
    return {};
  }
}

bool has_heights(const DataSet& outputs) {
  return outputs.has("points") && outputs.cloud("points").has(arrays::height_above_ground);
}

// The poses of a plant are worth a look before its cloud is, and that before its traits.
bool grows_in_sight(const pipeline::PipelineDocument& document) {
  return std::ranges::any_of(document.stages(), [](const pipeline::StageNode& node) {
    return std::ranges::any_of(node.type->outputs, [](const auto& port) { return port.kind == DataKind::views; });
  });
}

bool ended_early(const vtkbridge::RunOutcome& outcome) {
  return std::ranges::any_of(outcome.stages,
                             [](const auto& s) { return s.record.report.status == Status::finished_early; });
}

JobState state_after(const vtkbridge::RunOutcome& outcome) {
  if (outcome.exit_code == 3) return JobState::cancelled;
  if (outcome.exit_code != 0) return JobState::failed;
  return ended_early(outcome) ? JobState::kept : JobState::done;
}

std::shared_ptr<Job> job_for(std::shared_ptr<const pipeline::PipelineDocument> document, const QString& output_dir,
                             bool sinks) {
  auto job = std::make_shared<Job>();
  job->title = QString::fromStdString(document->title());
  job->document = std::move(document);
  job->output_dir = output_dir;
  job->sinks = job->asked = sinks;
  job->stages = job->document->in_order().size();
  return job;
}

}  // namespace

Runner::Runner(Session& session, QObject* parent) : QObject(parent), session_(session) {}

Runner::~Runner() {
  waiting_.clear();
  cancel();
  if (thread_.joinable()) thread_.join();
}

int Runner::start(const QString& output_dir, bool sinks, bool asked) {
  auto job = job_for(std::make_shared<const pipeline::PipelineDocument>(session_.document()), output_dir, sinks);
  job->path = session_.path();
  job->opened = documents_;
  job->asked = sinks || asked;
  return queue(std::move(job), {});
}

int Runner::queue(std::shared_ptr<Job> job, Deliver deliver) {
  job->id = ++last_id_;
  job->asked_at = QDateTime::currentDateTime();
  const auto before = std::find_if(jobs_.rbegin(), jobs_.rend(), [&](const auto& j) {
    return j->asked && j->document->source() == job->document->source();
  });
  if (before != jobs_.rend()) job->changes = changes_text(changed_options(*(*before)->document, *job->document));
  if (jobs_.size() >= max_jobs && jobs_.front()->over()) jobs_.erase(jobs_.begin());
  jobs_.push_back(job);
  waiting_.push_back({job, std::move(deliver), documents_});
  if (!current_) start_next();
  Q_EMIT jobs_changed();
  return job->id;
}

void Runner::start_next() {
  if (current_ || waiting_.empty()) return;
  if (thread_.joinable()) thread_.join();
  task_ = std::move(waiting_.front());
  waiting_.erase(waiting_.begin());
  current_ = task_.job;
  current_->state = JobState::running;
  current_->began = current_->stage_began = Job::Clock::now();
  executor_ = std::make_unique<vtkbridge::PipelineExecutor>(*current_->document);
  // The worker gets a copy of the job: the job itself belongs to the window.
  thread_ = std::jthread([this, job = *current_, before = survey_](const std::stop_token& cancel_token) {
    work(cancel_token, job, before);
  });
  Q_EMIT job_began(current_->id);
}

vtkbridge::RunSettings Runner::settings_for(const Job& job, const std::stop_token& cancel_token) {
  vtkbridge::RunSettings settings;
  settings.output_dir = job.output_dir.toStdString();
  settings.cancel = cancel_token;
  settings.sinks = job.sinks;
  // Some stages report every small step. More than a person can read only keeps the window busy.
  settings.progress = [this, last_stage = std::string(), last = Job::Clock::time_point()](
                          const std::string& stage, double fraction, std::string_view what) mutable {
    const auto now = Job::Clock::now();
    if (stage == last_stage && now - last < progress_gap) return;
    last_stage = stage;
    last = now;
    QMetaObject::invokeMethod(
        this,
        [this, stage = QString::fromStdString(stage), fraction,
         what = QString::fromUtf8(what.data(), static_cast<int>(what.size()))] {
          note_progress(stage, fraction, what);
        },
        Qt::QueuedConnection);
  };
  settings.preview = [this](const pipeline::StageNode& node) {
    return std::make_shared<PreviewChannel>(this, [this, id = QString::fromStdString(node.id)](const DataSet& part) {
      if (for_window(task_)) Q_EMIT snapshot_taken(id, part);
    });
  };
  return settings;
}

void Runner::work(const std::stop_token& cancel_token, const Job& job, const Survey& before) {
  auto result = std::make_shared<JobResult>();
  try {
    auto settings = settings_for(job, cancel_token);
    Survey seen = before;
    if (seen.empty())
      settings.preview = [&, preview = settings.preview](const pipeline::StageNode& node) {
        show_early(node, job.id, seen, cancel_token);
        return preview(node);
      };
    result->outcome = executor_->run(settings);
    result->results = collect(*executor_, result->outcome);
    result->survey = survey_to_show(result->outcome, result->results, seen, cancel_token);
  } catch (const std::exception& e) {  // a stored result that cannot be read
    if (result->outcome.exit_code == 0) result->outcome.exit_code = 1;
    result->outcome.error = e.what();
    result->survey = {};
  }
  QMetaObject::invokeMethod(
      this, [this, result] { end(result); }, Qt::QueuedConnection);
}

// Where nothing was seen before the run, the map is shown as soon as it has heights, and again whenever a stage added
// to it: stems, heights, places. What is made from views is shown whenever there is more of it. Called as `next`
// begins, while what it takes is in memory.
void Runner::show_early(const pipeline::StageNode& next, int job, Survey& seen, const std::stop_token& cancel_token) {
  const bool grows = grows_in_sight(executor_->document());
  vtkbridge::RunOutcome so_far;
  for (const auto* node : executor_->document().in_order()) {
    if (node->id == next.id) break;
    vtkbridge::StageOutcome stage;
    stage.record.id = node->id;
    stage.record.type = node->type->name;
    stage.state = vtkbridge::StageState::done;
    so_far.stages.push_back(std::move(stage));
  }
  const auto results = collect(*executor_, so_far, true);
  if (!grows && !std::ranges::any_of(results, [](const auto& r) { return has_heights(r.second); })) return;
  auto now = survey_to_show(so_far, results, seen, cancel_token);
  if (now.empty() || (now.points == seen.points && now.poses == seen.poses && now.stems == seen.stems)) return;
  seen = std::move(now);
  QMetaObject::invokeMethod(
      this,
      [this, survey = seen, job] {
        if (!current_ || current_->id != job || task_.deliver || task_.document != documents_) return;
        survey_ = survey;
        begun_ = true;
        Q_EMIT survey_begun();
      },
      Qt::QueuedConnection);
}

void Runner::note_progress(const QString& stage, double fraction, const QString& what) {
  if (!current_) return;
  auto& job = *current_;
  if (job.stage != stage) {
    job.stage = stage;
    job.ending = false;
    job.stage_began = Job::Clock::now();
    job.later_s = 0;
    bool after = false;
    std::size_t begun = 0;
    for (const auto* node : job.document->in_order()) {
      if (!after) ++begun;
      if (after && (job.sinks || !node->type->writes_files)) {
        const auto known = seconds_.find(node->id);
        if (known == seconds_.end())
          job.later_s.reset();
        else if (job.later_s)
          *job.later_s += known->second;
      }
      after = after || node->id == stage.toStdString();
    }
    job.stages_begun = begun;
  }
  job.fraction = fraction;
  job.what = what;
  if (for_window(task_)) Q_EMIT progressed(stage, fraction, what);
  Q_EMIT jobs_changed();
}

void Runner::end(const std::shared_ptr<const JobResult>& result) {
  const auto task = std::exchange(task_, {});  // what still comes of it is not shown
  auto& job = *task.job;
  current_.reset();
  job.ended = Job::Clock::now();
  job.state = state_after(result->outcome);
  job.outcome = result->outcome;
  if (job.state == JobState::kept) keep_whole(job, result);
  for (const auto& stage : result->outcome.stages)
    if (stage.state == vtkbridge::StageState::done) seconds_[stage.record.id] = stage.record.report.seconds;
  // What is shown, and the next one, before anybody listens and asks for them.
  if (for_window(task)) {
    if (std::exchange(begun_, false)) survey_ = {};  // what was shown early goes with the run that is cancelled
    take(*result);
  }
  start_next();
  if (task.deliver && result->outcome.exit_code == 0)
    task.deliver(*result);
  else if (task.deliver)
    Q_EMIT fetch_failed(QString::fromStdString(result->outcome.error));
  else if (for_window(task))
    Q_EMIT finished(result->outcome, result->results);
  else
    Q_EMIT finished({}, {});  // of a document that is not open any more
  Q_EMIT job_ended(job.id);
  Q_EMIT jobs_changed();
}

void Runner::fetch(int id, Deliver deliver) {
  const auto asked = job(id);
  if (!asked) throw bad_input("run " + std::to_string(id) + " is not in the list any more", "one that is");
  if (!asked->has_result())
    throw bad_input("run " + std::to_string(id) + " gave no result", "one that was not cancelled and did not fail");
  if (asked->whole) return deliver(*asked->whole);
  queue(job_for(asked->document, asked->output_dir, false), std::move(deliver));
}

void Runner::show_again(int id) {
  const auto asked = job(id);
  if (asked && asked->opened != documents_ && asked->path != session_.path())
    throw bad_input("run " + std::to_string(id) + " is of " + asked->path.toStdString(),
                    "a run of the pipeline in hand", "Open that pipeline first");
  fetch(id, [this, document = documents_](const JobResult& result) {
    if (document != documents_) return;
    take(result);
    Q_EMIT finished(result.outcome, result.results);
  });
}

// A run that was cancelled or gave nothing leaves what is shown as it is.
void Runner::take(const JobResult& result) {
  if (result.survey.empty()) return;
  survey_ = result.survey;
  outcome_ = result.outcome;
  results_ = result.results;
}

// Results that the cache does not have are large: only those of the last two stay.
void Runner::keep_whole(Job& job, const std::shared_ptr<const JobResult>& result) {
  constexpr int max_kept = 2;
  int kept = 0;
  job.whole = result;
  for (auto j = jobs_.rbegin(); j != jobs_.rend(); ++j)
    if ((*j)->whole && ++kept > max_kept) (*j)->whole.reset();
}

void Runner::forget_survey() {
  survey_ = {};
  begun_ = false;
  outcome_ = {};
  results_.clear();
  ++documents_;
}

std::shared_ptr<const Job> Runner::job(int id) const {
  const auto it = std::ranges::find_if(jobs_, [&](const auto& j) { return j->id == id; });
  return it == jobs_.end() ? nullptr : *it;
}

void Runner::finish() {
  if (!running()) return;
  executor_->finish_running_stage();
  current_->ending = true;
  Q_EMIT jobs_changed();
}

void Runner::cancel() { thread_.request_stop(); }

void Runner::cancel(int id) {
  if (current_ && current_->id == id) return cancel();
  const auto it = std::ranges::find_if(waiting_, [&](const auto& t) { return t.job->id == id; });
  if (it == waiting_.end()) return;
  it->job->state = JobState::cancelled;
  waiting_.erase(it);
  Q_EMIT jobs_changed();
}

void Runner::cancel_all() {
  while (!waiting_.empty()) cancel(waiting_.back().job->id);
  cancel();
}

}  // namespace bole::desktop
