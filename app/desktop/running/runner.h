// Runs documents in a thread of its own, one after the other, so that the window never waits; signals arrive in the
// thread of the window.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "document/session.h"
#include "running/job.h"

namespace bole::desktop {

class Runner : public QObject {
  Q_OBJECT

 public:
  explicit Runner(Session& session, QObject* parent);
  ~Runner() override;  // cancels and waits

  bool running() const { return current_ != nullptr; }

  // Queues the document of the session as it stands now; gives the id of the job.
  // `asked`: by a person, also where no files are written.
  int start(const QString& output_dir, bool sinks = true, bool asked = false);

  using Deliver = std::function<void(const JobResult&)>;
  // The result of a job that is over, as it was: from memory or by running its document again, which the cache answers.
  // Throws bole::Error for a job without one. Ends with fetch_failed() when it cannot be had any more.
  void fetch(int id, Deliver deliver);
  void show_again(int id);  // to the window; throws bole::Error when it is of another document or gave no result

  void finish();        // keep the best so far of the running stage
  void cancel();        // the job that runs
  void cancel(int id);  // that one, whether it runs or waits
  void cancel_all();

  const std::vector<std::shared_ptr<Job>>& jobs() const { return jobs_; }  // in the order in which they were asked for
  std::shared_ptr<const Job> job(int id) const;                            // null when it is gone
  std::shared_ptr<const Job> current() const { return current_; }

  // What is shown: of the last run that gave something to look at. The three belong together; while the first run goes
  // on, survey() is what its stages gave so far.
  const Survey& survey() const { return survey_; }
  const vtkbridge::RunOutcome& outcome() const { return outcome_; }
  const Results& results() const { return results_; }
  // Another document is open: runs of the one before go on, but are not shown.
  void forget_survey();

 Q_SIGNALS:
  // Of runs of the document that is open, for the window: not of those that are fetched.
  void progressed(const QString& stage, double fraction, const QString& what);
  void finished(const vtkbridge::RunOutcome& outcome, const Results& results);  // empty: of another document
  void fetch_failed(const QString& why);
  void survey_begun();  // there is a map where there was nothing, or a stage added to it: stems, heights
  void job_began(int id);
  void job_ended(int id);
  void jobs_changed();                                             // state or progress of any
  void snapshot_taken(const QString& stage, const DataSet& part);  // of the job that runs, see cloud/preview.h

 private:
  struct Task {
    std::shared_ptr<Job> job;
    Deliver deliver;   // empty: to the window
    int document = 0;  // the count of documents when it was asked for
  };
  bool for_window(const Task& task) const { return !task.deliver && task.document == documents_; }
  int queue(std::shared_ptr<Job> job, Deliver deliver);
  void start_next();
  void work(const std::stop_token& cancel, const Job& job, const Survey& before);
  void show_early(const pipeline::StageNode& next, int job, Survey& seen, const std::stop_token& cancel);
  void note_progress(const QString& stage, double fraction, const QString& what);
  void end(const std::shared_ptr<const JobResult>& result);
  void take(const JobResult& result);
  void keep_whole(Job& job, const std::shared_ptr<const JobResult>& result);
  vtkbridge::RunSettings settings_for(const Job& job, const std::stop_token& cancel);

  Session& session_;
  std::vector<std::shared_ptr<Job>> jobs_;
  std::vector<Task> waiting_;
  Task task_;  // of `current_`
  std::shared_ptr<Job> current_;
  std::unique_ptr<vtkbridge::PipelineExecutor> executor_;
  std::jthread thread_;
  Survey survey_;
  vtkbridge::RunOutcome outcome_;
  Results results_;
  bool begun_ = false;                     // survey_ is the map of a run that goes on
  std::map<std::string, double> seconds_;  // that stages took last time, by id
  int last_id_ = 0, documents_ = 0;
};

}  // namespace bole::desktop
