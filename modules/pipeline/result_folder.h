// The output folder of a run. Results are written aside, into a draft, and take the place of the survey before as one:
// whoever opens the folder finds one survey or the other, whole, whenever the process ends.
//
//   DIR/summary.json            lists the files of the survey ("files"); files that it does not list are foreign
//   DIR/.bole-PID               the draft of a run
//   DIR/.bole-swap              a draft that is being put in place, file by file; the next run goes on with it
//   PARENT/.NAME.bole-PID       a draft, or the survey before, while the two change places
//   DIR/failed_run, FAILED_RUN.txt   what a run that failed left beside the survey before
//   DIR/stems.changed-TIME.csv       a result that a person changed, kept when the next run wrote it anew
//
// Where DIR holds nothing foreign and the file system can, draft and survey change places in one step
// (renameat2 RENAME_EXCHANGE). Else a journal of renames does it.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace bole::pipeline {

// What became of the survey before when a run failed.
struct OldSurvey {
  std::string not_marked;    // what could not be marked as old, and why; empty when all was
  bool results_kept = true;  // what the failed run wrote is in failed_run/; else it was removed to make room
};

class ResultFolder {
 public:
  // Makes the folder, ends a swap that was interrupted, and removes what runs left that are no more. Throws
  // Error{bad_input} when `folder` is a file, Error{failed} when it cannot be made or written to. `replace_foreign`
  // allows to write over foreign files.
  explicit ResultFolder(const std::filesystem::path& folder, bool replace_foreign = false);
  // Removes the draft, and the folder where it made it and nothing was put there.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& draft() const { return draft_; }

  // Throws Error{bad_input} when a foreign file has the name of a result (result_names.h), or a folder that of a file:
  // such a folder is not written over whatever was allowed. Without `sinks` only summary.json is written.
  void refuse_foreign_files(bool sinks) const;

  // Whether the folder holds the survey of a run that went well.
  bool has_survey() const;

  // The files of the draft become the survey, together with those in `kept` (names in the folder), which stay as they
  // are. Other files of the survey before are removed, foreign ones never. Throws Error{bad_input} when a foreign file
  // is in the way, and Error{failed}; the survey before is then untouched.
  // A result that was changed since Bole wrote it is kept under another name. Gives a sentence on each of them, which
  // summary.json has as findings (changed_file_kept).
  std::vector<std::string> publish(const std::set<std::string>& kept);

  // The files of the draft join those in the folder, in place of files of the same names; nothing is removed. Throws as
  // publish() does.
  void add();

  // Keeps the survey before and marks it as old: in a text file, in its summary.json and on its pages. The draft
  // becomes failed_run/, unless its room is needed for the marks.
  OldSurvey keep_survey_before(const std::string& why);

 private:
  std::set<std::string> files_in_draft() const;
  void refuse_conflicts(const std::set<std::string>& files, const std::set<std::string>& ours) const;
  std::vector<std::string> keep_changed(const std::set<std::string>& files, const std::set<std::string>& kept) const;
  bool holds_only(const std::set<std::string>& ours) const;
  bool exchange(const std::set<std::string>& kept, const std::set<std::string>& ours);
  void move_file_by_file(const std::set<std::string>& stale);

  std::filesystem::path folder_, draft_;
  bool made_ = false;  // the folder was not there before
  bool replace_foreign_;
};

// Names of the marks, for programs and tests.
inline constexpr const char* failed_run_folder = "failed_run";
inline constexpr const char* failed_run_note = "FAILED_RUN.txt";
inline constexpr const char* finished_early_note = "FINISHED_EARLY.txt";

}  // namespace bole::pipeline
