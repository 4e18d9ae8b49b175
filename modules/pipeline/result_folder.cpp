#include "pipeline/result_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/atomic_file.h"
#include "base/drafts.h"
#include "base/error.h"
#include "base/verdict.h"
#include "pipeline/old_survey.h"
#include "pipeline/result_names.h"
#include "pipeline/written_files.h"

namespace bole::pipeline {
namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr std::string_view draft_prefix = ".bole-";
constexpr const char* swap_folder = ".bole-swap";
constexpr const char* journal_file = ".journal.json";
constexpr const char* summary_file = "summary.json";
constexpr const char* cache_folder = "cache";

std::optional<ordered_json> read_json(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  auto json = ordered_json::parse(in, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  return json;
}

// The summary of a run of Bole, or nothing where the folder has none.
std::optional<ordered_json> read_summary(const fs::path& folder) {
  auto summary = read_json(folder / summary_file);
  if (!summary || !summary->is_object() || !summary->contains("bole") || !summary->contains("files") ||
      !summary->at("files").is_array())
    return std::nullopt;
  return summary;
}

// Names of the files that belong to the survey in a folder.
std::set<std::string> own_files(const fs::path& folder) {
  std::set<std::string> names;
  const auto summary = read_summary(folder);
  if (!summary) return names;
  for (const auto& file : summary->at("files"))
    if (file.is_string()) names.insert(file.get<std::string>());
  names.insert({summary_file, failed_run_note, finished_early_note});
  return names;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.insert(entry.path().lexically_relative(folder).generic_string());
  return names;
}

std::string first_part(const std::string& name) { return name.substr(0, name.find('/')); }

bool is_draft_name(const std::string& name) { return name.starts_with(draft_prefix); }

// The process whose draft it is: ".bole-4711" gives 4711.
std::optional<long> owner_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  long id = 0;
  const auto [end, code] = std::from_chars(name.data() + prefix.size(), name.data() + name.size(), id);
  if (code != std::errc{} || (end != name.data() + name.size() && *end != '-')) return std::nullopt;
  return id;
}

std::string sibling_prefix(const fs::path& folder) { return "." + folder.filename().string() + ".bole-"; }

void remove_empty_folder_of(const fs::path& file, const fs::path& top) {
  std::error_code ignored;
  for (auto folder = file.parent_path(); folder != top && folder.string().size() > top.string().size();
       folder = folder.parent_path())
    if (!fs::is_empty(folder, ignored) || !fs::remove(folder, ignored)) return;
}

// Only one run at a time puts its results in place.
class SwapLock {
 public:
  explicit SwapLock(const fs::path& folder) {
    // The folder may have changed places while we waited.
    for (int attempt = 0; attempt < 10; ++attempt) {
      descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor_ < 0) return;
      ::flock(descriptor_, LOCK_EX);
      struct stat locked {
      }, now{};
      if (::fstat(descriptor_, &locked) == 0 && ::stat(folder.c_str(), &now) == 0 && locked.st_ino == now.st_ino)
        return;
      ::close(descriptor_);
      descriptor_ = -1;
    }
  }
  ~SwapLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  SwapLock(const SwapLock&) = delete;
  SwapLock& operator=(const SwapLock&) = delete;

 private:
  int descriptor_ = -1;
};

void rename_or_throw(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw failure("cannot put '" + to.string() + "' in place: " + error.message());
}

// Moves what a swap folder holds into its place and removes what its journal lists; may be repeated.
void roll_forward(const fs::path& folder) {
  const fs::path swap = folder / swap_folder;
  std::error_code ignored;
  if (!fs::is_directory(swap, ignored)) return;
  const auto journal = read_json(swap / journal_file);
  auto names = files_in(swap);
  names.erase(journal_file);
  // The summary comes last: it lists the files that are there.
  std::vector<std::string> order(names.begin(), names.end());
  std::stable_partition(order.begin(), order.end(), [](const std::string& name) { return name != summary_file; });
  for (const auto& name : order) {
    fs::create_directories((folder / name).parent_path(), ignored);
    rename_or_throw(swap / name, folder / name);
  }
  if (journal && journal->is_object() && journal->contains("remove"))
    for (const auto& name : journal->at("remove")) {
      const fs::path file = folder / name.get<std::string>();
      if (name == failed_run_folder)
        fs::remove_all(file, ignored);
      else
        fs::remove(file, ignored);
      remove_empty_folder_of(file, folder);
    }
  fs::remove_all(swap, ignored);
}

// What is left of a folder that gave its place to `folder`: foreign entries and the cache go there, the rest is
// removed. The summary goes last: until then it tells which files are results. So this may be interrupted and done
// again.
void clear_former(const fs::path& former, const fs::path& folder) {
  std::error_code ignored;
  std::set<std::string> own{failed_run_folder};
  for (const auto& name : own_files(former)) own.insert(first_part(name));
  std::vector<fs::path> to_remove;
  for (const auto& entry : fs::directory_iterator(former, ignored)) {
    const auto name = entry.path().filename().string();
    if (name == summary_file && own.contains(name)) continue;
    if (!own.contains(name) && !is_draft_name(name) && !fs::exists(fs::symlink_status(folder / name, ignored)))
      fs::rename(entry.path(), folder / name, ignored);
    else if (own.contains(name) || is_draft_name(name) || name == cache_folder)
      to_remove.push_back(entry.path());
  }
  for (const auto& path : to_remove) fs::remove_all(path, ignored);
  if (own.contains(summary_file)) fs::remove(former / summary_file, ignored);
  fs::remove(former, ignored);  // unless something foreign is left in it
}

void remove_abandoned(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (const auto owner = owner_of(entry.path().filename().string(), draft_prefix); owner && !process_runs(*owner))
      fs::remove_all(entry.path(), ignored);
  const auto prefix = sibling_prefix(folder);
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(folder.parent_path(), ignored))
    if (const auto owner = owner_of(entry.path().filename().string(), prefix); owner && !process_runs(*owner))
      former.push_back(entry.path());
  for (const auto& path : former) clear_former(path, folder);
}

// Temporary files of killed processes: in the cache, and of earlier versions beside the results.
void remove_abandoned_files(const fs::path& folder) {
  for (const char* inner : {cache_folder, "figures"}) remove_abandoned_drafts(folder / inner);
  std::error_code ignored;
  bool any = false;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    any = any || entry.path().filename().string().find(".partial-") != std::string::npos;
  if (any) remove_abandoned_drafts(folder);
}

// Whether some process has its working folder in `folder`: it would stay behind in the folder that goes.
bool is_working_folder_of_somebody(const fs::path& folder) {
  std::error_code ignored;
  const auto prefix = folder.string() + "/";
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const auto working = fs::read_symlink(entry.path() / "cwd", ignored).string();
    if (working == folder.string() || working.starts_with(prefix)) return true;
  }
  return false;
}

bool same_owner_and_device(const fs::path& a, const fs::path& b) {
  struct stat one {
  }, other{};
  return ::stat(a.c_str(), &one) == 0 && ::stat(b.c_str(), &other) == 0 && one.st_uid == other.st_uid &&
         one.st_gid == other.st_gid && one.st_dev == other.st_dev;
}

std::string foreign_file_hint() {
  return "Choose another folder, move the file away, or allow that it is written over (--force)";
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& folder, bool replace_foreign) : replace_foreign_(replace_foreign) {
  std::error_code error;
  fs::path whole = fs::absolute(folder).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  if (fs::exists(whole, error) && !fs::is_directory(whole, error))
    throw bad_input("'" + folder.string() + "' is a file", "a folder for the results", "Give another --out DIR");
  made_ = fs::create_directories(whole, error);
  if (error) throw failure("cannot make the folder '" + folder.string() + "': " + error.message());
  folder_ = fs::canonical(whole, error);
  if (error) throw failure("cannot find the folder '" + folder.string() + "': " + error.message());
  {
    const SwapLock lock(folder_);
    roll_forward(folder_);
    remove_abandoned(folder_);
  }
  remove_abandoned_files(folder_);
  draft_ = folder_ / (std::string(draft_prefix) + std::to_string(::getpid()));
  // Of another run of this process into this folder.
  for (int n = 1; fs::exists(draft_, error); ++n)
    draft_ = folder_ / (std::string(draft_prefix) + std::to_string(::getpid()) + "-" + std::to_string(n));
  fs::create_directory(draft_, error);
  if (error)
    throw failure("cannot write into the folder '" + folder.string() + "': " + error.message(),
                  "a folder that may be written to");
  remember_draft(draft_);
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  fs::remove_all(draft_, ignored);
  forget_draft(draft_);
  if (made_) fs::remove(folder_, ignored);  // unless it holds something
}

void ResultFolder::refuse_foreign_files(bool sinks) const {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const auto name = entry.path().filename();
    if (sinks && name.has_extension() && is_result_name(name.string()) && entry.is_directory(ignored))
      throw bad_input("'" + entry.path().string() + "' is a folder", "a name that is free for a result",
                      "Move it away or choose another folder");
  }
  if (replace_foreign_) return;
  const auto own = own_files(folder_);
  std::set<std::string> own_names;
  for (const auto& name : own) own_names.insert(first_part(name));
  std::string found;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const auto name = entry.path().filename().string();
    const bool written = sinks ? is_result_name(name) : name == summary_file;
    if (!written || own_names.contains(name)) continue;
    if (entry.is_directory(ignored) && name == "figures") continue;  // what lies in it is looked at one by one
    found += (found.empty() ? "" : ", ") + name;
  }
  if (!found.empty())
    throw bad_input("the folder '" + folder_.string() +
                        "' holds files that no run of Bole wrote and that have the "
                        "names of results: " +
                        found,
                    "a folder without them", foreign_file_hint());
}

bool ResultFolder::has_survey() const {
  const auto summary = read_summary(folder_);
  if (!summary) return false;
  const auto code = summary->value("exit_code", 1);
  return code == 0 || code == 4;
}

std::set<std::string> ResultFolder::files_in_draft() const { return files_in(draft_); }

void ResultFolder::refuse_conflicts(const std::set<std::string>& files, const std::set<std::string>& ours) const {
  std::error_code ignored;
  for (const auto& name : files) {
    const auto there = fs::symlink_status(folder_ / name, ignored);
    if (!fs::exists(there)) {
      // A file where a folder is needed.
      const auto top = folder_ / first_part(name);
      if (name.find('/') != std::string::npos && fs::exists(top, ignored) && !fs::is_directory(top, ignored))
        throw bad_input("'" + top.string() + "' is a file",
                        "a name that is free: results go into a folder of that name",
                        "Move it away or choose another folder");
      continue;
    }
    if (fs::is_directory(there))
      throw bad_input("'" + (folder_ / name).string() + "' is a folder", "a name that is free for a result",
                      "Move it away or choose another folder");
    if (!ours.contains(name) && !replace_foreign_)
      throw bad_input("'" + (folder_ / name).string() + "' was not written by Bole", "a name that is free for a result",
                      foreign_file_hint());
  }
}

std::vector<std::string> ResultFolder::publish(const std::set<std::string>& kept) {
  const SwapLock lock(folder_);
  roll_forward(folder_);
  const auto ours = own_files(folder_);
  const auto files = files_in_draft();
  refuse_conflicts(files, ours);
  auto told = keep_changed(files, kept);
  for (const auto& name : kept)
    if (name.ends_with(".html") && !files.contains(name)) unmark_page(folder_ / name);
  forget_draft(draft_);  // from here on it is the survey
  if (exchange(kept, ours)) return told;
  std::set<std::string> stale{failed_run_folder};
  for (const auto& name : ours)
    if (!files.contains(name) && !kept.contains(name)) stale.insert(name);
  move_file_by_file(stale);
  return told;
}

void ResultFolder::add() {
  const SwapLock lock(folder_);
  roll_forward(folder_);
  refuse_conflicts(files_in_draft(), {});
  forget_draft(draft_);
  std::error_code ignored;
  const auto entries = std::distance(fs::directory_iterator(folder_, ignored), fs::directory_iterator());
  if (entries > 1 || !exchange({}, {})) move_file_by_file({});
}

void ResultFolder::move_file_by_file(const std::set<std::string>& stale) {
  write_text_file(draft_ / journal_file, ordered_json{{"remove", stale}}.dump());
  rename_or_throw(draft_, folder_ / swap_folder);
  roll_forward(folder_);
}

// Whether all that lies in the folder may be taken out of it: results, the cache, the draft. Drafts of other runs,
// foreign files and empty folders may not.
bool ResultFolder::holds_only(const std::set<std::string>& ours) const {
  std::set<std::string> tops;
  for (const auto& name : ours) tops.insert(first_part(name));
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const auto name = entry.path().filename().string();
    if (name == cache_folder || name == failed_run_folder || entry.path() == draft_) continue;
    if (is_draft_name(name) || !tops.contains(name)) return false;
    if (!entry.is_directory()) continue;
    const auto inside = files_in(entry.path());
    if (inside.empty() ||
        !std::ranges::all_of(inside, [&](const std::string& file) { return ours.contains(name + "/" + file); }))
      return false;
  }
  return true;
}

// False where draft and folder cannot change places; nothing was done then.
bool ResultFolder::exchange(const std::set<std::string>& kept, const std::set<std::string>& ours) {
  const fs::path parent = folder_.parent_path();
  if (parent == folder_ || ::access(parent.c_str(), W_OK) != 0 || !same_owner_and_device(draft_, folder_) ||
      !same_owner_and_device(draft_, parent) || is_working_folder_of_somebody(folder_))
    return false;
  if (!holds_only(ours)) return false;
  std::error_code error;
  for (const auto& name : kept) {
    if (fs::exists(draft_ / name, error)) continue;
    fs::create_directories((draft_ / name).parent_path(), error);
    fs::create_hard_link(folder_ / name, draft_ / name, error);
    if (error) return false;
  }
  struct stat status {};
  if (::stat(folder_.c_str(), &status) != 0 || ::chmod(draft_.c_str(), status.st_mode & 07777) != 0) return false;
  const fs::path aside = parent / (sibling_prefix(folder_) + std::to_string(::getpid()));
  fs::rename(draft_, aside, error);
  if (error) return false;
  if (::renameat2(AT_FDCWD, aside.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) != 0) {
    rename_or_throw(aside, draft_);
    return false;
  }
  clear_former(aside, folder_);
  return true;
}

// Puts what of the survey before was changed, and what the run does not leave as it is, into the draft under another
// name, and notes in the summary of the draft what was written and what was kept.
std::vector<std::string> ResultFolder::keep_changed(const std::set<std::string>& files,
                                                    const std::set<std::string>& kept) const {
  auto summary = read_summary(draft_);
  if (!summary) return {};
  const auto before = read_summary(folder_);
  auto records = before && before->contains("written") ? before->at("written") : ordered_json::object();
  std::vector<std::string> told;
  for (const auto& name : changed_files(folder_, records)) {
    if (kept.contains(name) && !files.contains(name)) continue;
    const auto other = name_of_changed(folder_, name);
    std::error_code error;
    fs::create_directories((draft_ / other).parent_path(), error);
    fs::create_hard_link(folder_ / name, draft_ / other, error);
    if (error) fs::copy_file(folder_ / name, draft_ / other, error);
    if (error)
      throw failure("'" + name + "' was changed since Bole wrote it and cannot be kept: " + error.message(),
                    "space for a copy", "Move it away or choose another folder");
    told.push_back(name + " was changed after Bole wrote it: the changed file is kept as " + other +
                   ", and this survey does not hold what was typed into it");
    (*summary)["findings"].push_back(
        {{"code", "changed_file_kept"}, {"severity", severity_name(Severity::note)}, {"text", told.back()}});
  }
  auto written = ordered_json::object();
  for (const auto& file : summary->at("files")) {
    const auto name = file.get<std::string>();
    if (name == summary_file) continue;
    if (files.contains(name))
      written[name] = record_of(draft_ / name);
    else if (records.is_object() && records.contains(name))
      written[name] = records[name];
  }
  if (!written.empty()) (*summary)["written"] = std::move(written);
  write_text_file(draft_ / summary_file, summary->dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  return told;
}

OldSurvey ResultFolder::keep_survey_before(const std::string& why) {
  const SwapLock lock(folder_);
  if (!read_summary(folder_)) return {"summary.json: it cannot be read", false};
  const auto files = own_files(folder_);
  OldSurvey old;
  std::error_code error;
  fs::remove_all(folder_ / failed_run_folder, error);
  fs::rename(draft_, folder_ / failed_run_folder, error);
  old.results_kept = !error;
  old.not_marked = mark_survey(folder_, files, why);
  if (old.not_marked.empty()) return old;
  // The marks matter more than what the failed run wrote.
  fs::remove_all(folder_ / failed_run_folder, error);
  fs::remove_all(draft_, error);
  old.results_kept = false;
  old.not_marked = mark_survey(folder_, files, why);
  return old;
}

}  // namespace bole::pipeline
