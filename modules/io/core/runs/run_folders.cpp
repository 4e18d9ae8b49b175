#include "io/core/runs/run_folders.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/core/path_list.h"
#include "io/core/runs/stack_tables.h"
#include "io/core/runs/survey_folder.h"

namespace bole::io {
namespace fs = std::filesystem;

const OptionTable& option_table(const RunFolderOptions*) {
  using S = RunFolderOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"folders",
                             &S::folders,
                             TextKind::input_path,
                             {path_separator},
                             Tier::basic,
                             "Output folders of bole run or bole survey, with commas between."},
      Option<S, std::string>{"names",
                             &S::names,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Names of the runs in tables and figures, with commas between; empty: the names of the "
                             "folders."},
      Option<S, std::string>{"systems",
                             &S::systems,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "What made each run, with commas between. Runs of one system are pooled; empty: the "
                             "preset of each run."},
      Option<S, std::string>{"plots",
                             &S::plots,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Plot of each run, with commas between. plot1 to plot4 list the published figures of "
                             "these plots; empty: runs whose stems agree share a plot."},
  });
  return table;
}

namespace {

std::vector<std::string> list_of(const std::string& text) {
  static const OptionSpec& lists = option_table(static_cast<const RunFolderOptions*>(nullptr)).at("folders");
  return input_paths(lists, text);
}

// A list that is given must have an entry for each run.
std::vector<std::string> labels(const std::string& text, const char* option, std::size_t runs) {
  auto list = list_of(text);
  if (list.empty()) list.resize(runs);
  if (list.size() != runs)
    throw bad_input(fmt::format("{} {} for {} folders", list.size(), option, runs),
                    "one for each folder, in their order", fmt::format("runs.{}=A,B", option));
  return list;
}

std::vector<fs::path> folders_of(const std::string& text) {
  std::vector<fs::path> folders;
  for (const auto& path : list_of(text)) {
    const auto folder = fs::weakly_canonical(path);
    if (!fs::is_directory(folder))
      throw bad_input("'" + path + "' is no folder", "the output folder of a run (bole run ... --out FOLDER)");
    if (std::ranges::find(folders, folder) != folders.end())
      throw bad_input("the folder '" + path + "' is named twice", "different runs",
                      "A run compared with itself has no differences, and pooled twice counts its trees twice");
    folders.push_back(folder);
  }
  if (folders.empty())
    throw bad_input("no folder is named", "the output folders of two or more runs", "--set runs.folders=A,B");
  return folders;
}

// The last part of each path, with the part before it where that does not tell them apart, else the whole path.
std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    const auto same = [&](const fs::path& other) { return other.filename() == folder.filename(); };
    const bool alone = std::ranges::count_if(folders, same) == 1;
    names.push_back((alone ? folder.filename() : folder.parent_path().filename() / folder.filename()).string());
  }
  const auto short_names = names;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::count(short_names, short_names[i]) > 1) names[i] = folders[i].string();
  return names;
}

template <class Member>
Table stacked(const std::vector<SurveyFolder>& surveys, Member table_of) {
  std::vector<Table> parts;
  for (const auto& s : surveys) parts.push_back(table_of(s));
  std::vector<const Table*> pointers;
  for (const auto& part : parts) pointers.push_back(&part);
  return stack_tables(pointers);
}

}  // namespace

RunFolders read_run_folders(const RunFolderOptions& options, const Run& run) {
  RunFolders out;
  const auto folders = folders_of(options.folders);
  const auto names = labels(options.names, "names", folders.size()),
             systems = labels(options.systems, "systems", folders.size()),
             plots = labels(options.plots, "plots", folders.size()), own_names = names_of(folders);
  std::vector<SurveyFolder> surveys;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    run.report(static_cast<double>(i) / static_cast<double>(folders.size()), "read " + own_names[i]);
    run.check_cancel();
    surveys.push_back(read_survey_folder(folders[i], names[i].empty() ? own_names[i] : names[i], out.report));
    surveys.back().plot = plots[i];
    surveys.back().system = systems[i].empty() ? surveys.back().summary.system : systems[i];
  }
  out.runs = runs_table(surveys);
  out.stems = stacked(surveys, [](const SurveyFolder& s) -> const Table& { return s.stems; });
  out.poses = stacked(surveys, [](const SurveyFolder& s) { return poses_table(s.trajectory); });
  out.boundaries = stacked(surveys, [](const SurveyFolder& s) { return boundary_table(s.rule); });
  out.loops = stacked(surveys, [](const SurveyFolder& s) -> const Table& { return s.loops; });
  out.reference_stems = stacked(surveys, [](const SurveyFolder& s) { return s.reference.value_or(Table()); });
  out.reference_poses = stacked(surveys, [](const SurveyFolder& s) { return poses_table(s.reference_trajectory); });
  out.report.counts["runs"] = static_cast<std::int64_t>(surveys.size());
  out.report.counts["stems"] = static_cast<std::int64_t>(out.stems.rows());
  out.report.message = fmt::format("{} runs with {} stems", surveys.size(), out.stems.rows());
  return out;
}

}  // namespace bole::io
