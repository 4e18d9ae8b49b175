#include "io/core/runs/run_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/core/path_list.h"
#include "base/no_number.h"
#include "cloud/trajectory.h"
#include "io/core/runs/plot_file.h"
#include "io/core/runs/run_summary.h"
#include "io/core/runs/stack_tables.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

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

struct Survey {
  fs::path folder;
  std::string name, plot, system;
  RunSummary summary;
  Table stems;
  std::optional<CountingRule> rule;
  std::optional<Table> reference;
  std::string reference_file;
  Trajectory trajectory, reference_trajectory;
};

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

class Reader {
 public:
  explicit Reader(Report& report) : report_(report) {}

  Survey read(const fs::path& folder, const std::string& name) {
    Survey s;
    s.folder = folder;
    s.name = name;
    const auto stems = folder / "stems.csv";
    if (!fs::is_regular_file(stems))
      throw bad_input("'" + folder.string() + "' holds no survey: there is no stems.csv in it",
                      "the output folder of a run that made a stem table",
                      fs::exists(folder / "FAILED_RUN.txt") ? "FAILED_RUN.txt says why the run failed" : "");
    s.stems = read_table(stems);
    if (s.stems.rows() == 0) look(s, "run_without_stems", "its stems.csv has no row");
    attempt(s, "summary.json", "what made this run is not known",
            [&](const fs::path& file) { s.summary = read_run_summary(file); });
    attempt(s, "plot.csv", "which of its trees count is only known by the column counted",
            [&](const fs::path& file) { s.rule = read_plot(file); });
    attempt(s, "trajectory.tum", "its trajectory takes no part",
            [&](const fs::path& file) { s.trajectory = read_trajectory(file); });
    take_reference(s);
    if (fs::exists(folder / "FAILED_RUN.txt"))
      look(s, "older_survey", "the last run in this folder failed: the survey before it is compared");
    if (fs::exists(folder / "FINISHED_EARLY.txt")) look(s, "finished_early", "this run was asked to finish early");
    if (s.summary.verdict == "refused") look(s, "refused_survey", "the verdict of this run is: refused");
    return s;
  }

 private:
  void look(const Survey& s, const char* code, const std::string& text) {
    report_.find(Severity::look, code, s.name + ": " + text);
  }

  template <class Read>
  void attempt(const Survey& s, const char* file, const char* without, Read read) {
    const auto path = s.folder / file;
    if (!fs::exists(path)) {
      report_.find(Severity::note, "run_file_missing", fmt::format("{}: there is no {}; {}", s.name, file, without));
      return;
    }
    try {
      read(path);
    } catch (const Error& error) {
      look(s, "run_file_damaged", fmt::format("{} cannot be read ({}); {}", file, error.what(), without));
    }
  }

  void take_reference(Survey& s) {
    const auto trees = s.folder / "reference_trees.csv", matches = s.folder / "matches.csv",
               path = s.folder / "reference_trajectory.tum";
    // Without a boundary the list would count trees that the run did not.
    if (s.rule && fs::exists(trees))
      attempt(s, "reference_trees.csv", "its reference takes no part", [&](const fs::path& file) {
        s.reference = read_table(file);
        s.reference_file = "reference_trees.csv";
      });
    else if (fs::exists(matches))
      attempt(s, "matches.csv", "its reference takes no part", [&](const fs::path& file) {
        s.reference = reference_in(read_table(file));
        if (s.reference) s.reference_file = "matches.csv";
      });
    if (fs::exists(path))
      attempt(s, "reference_trajectory.tum", "its reference trajectory takes no part",
              [&](const fs::path& file) { s.reference_trajectory = read_trajectory(file); });
  }

  // The reference trees that the run was compared with, of its table of matches.
  static std::optional<Table> reference_in(const Table& matches) {
    std::vector<std::size_t> picked;
    const auto& kind = matches.texts("kind");
    for (std::size_t i = 0; i < kind.size(); ++i)
      if (kind[i] == "matched" || kind[i] == "missed") picked.push_back(i);
    if (picked.empty()) return {};
    const Table rows = matches.subset(picked);
    Table out;
    out.set("tree_id", *rows.find(rows.has("ref_name") ? "ref_name" : "ref_id"));
    if (rows.has("ref_name") && rows.has("ref_id")) {  // names where there are any, else numbers
      auto ids = rows.texts("ref_name");
      for (std::size_t i = 0; i < ids.size(); ++i)
        if (ids[i].empty()) ids[i] = rows.text("ref_id", i);
      out.set("tree_id", std::move(ids));
    }
    out.set("x_m", rows.numbers("ref_x_m"));
    out.set("y_m", rows.numbers("ref_y_m"));
    out.set("dbh_cm", rows.numbers("ref_dbh_cm"));
    if (rows.has("species")) out.set("species", *rows.find("species"));
    return out;
  }

  Report& report_;
};

Table poses_table(const Trajectory& trajectory) {
  std::map<std::string, std::vector<double>> c;
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector3d p = pose.T_target_sensor.translation();
    const Eigen::Quaterniond q(pose.T_target_sensor.linear());
    c["time_s"].push_back(pose.time_s);
    c["x_m"].push_back(p.x());
    c["y_m"].push_back(p.y());
    c["z_m"].push_back(p.z());
    c["qx"].push_back(q.x());
    c["qy"].push_back(q.y());
    c["qz"].push_back(q.z());
    c["qw"].push_back(q.w());
  }
  Table t;
  for (const char* name : {"time_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"}) t.set(name, c[name]);
  return t;
}

Table boundary_table(const std::optional<CountingRule>& rule) {
  std::vector<double> x, y;
  if (rule)
    for (const auto& p : rule->area.outline()) {
      x.push_back(p.x());
      y.push_back(p.y());
    }
  Table t;
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  return t;
}

Table runs_table(const std::vector<Survey>& surveys) {
  Table t;
  const auto texts = [&](const char* name, auto value) {
    std::vector<std::string> out;
    for (const auto& s : surveys) out.push_back(value(s));
    t.set(name, std::move(out));
  };
  const auto counts = [&](const char* name, auto value) {
    std::vector<std::int64_t> out;
    for (const auto& s : surveys) out.push_back(static_cast<std::int64_t>(value(s)));
    t.set(name, std::move(out));
  };
  const auto rule_numbers = [&](const char* name, auto value) {
    std::vector<double> out;
    for (const auto& s : surveys) out.push_back(s.rule ? value(*s.rule) : no_number);
    t.set(name, std::move(out));
  };
  counts("run", [k = 0](const Survey&) mutable { return ++k; });
  texts("name", [](const Survey& s) { return s.name; });
  texts("system", [](const Survey& s) { return s.system; });
  texts("plot", [](const Survey& s) { return s.plot; });
  texts("folder", [](const Survey& s) { return s.folder.string(); });
  texts("scan", [](const Survey& s) { return s.summary.scan; });
  texts("preset", [](const Survey& s) { return s.summary.preset; });
  counts("poses_given", [](const Survey& s) { return s.summary.poses_given; });
  texts("axes", [](const Survey& s) { return s.summary.axes; });
  texts("verdict", [](const Survey& s) { return s.summary.verdict; });
  counts("stems", [](const Survey& s) { return s.stems.rows(); });
  counts("poses", [](const Survey& s) { return s.trajectory.poses.size(); });
  counts("has_plot", [](const Survey& s) { return s.rule.has_value(); });
  texts("shape", [](const Survey& s) { return s.rule ? to_table(*s.rule).facts.at("shape") : std::string(); });
  rule_numbers("centre_x_m", [](const CountingRule& r) { return r.area.centre.x(); });
  rule_numbers("centre_y_m", [](const CountingRule& r) { return r.area.centre.y(); });
  rule_numbers("width_m", [](const CountingRule& r) { return r.area.width_m; });
  rule_numbers("length_m", [](const CountingRule& r) { return r.area.length_m; });
  rule_numbers("bearing_rad", [](const CountingRule& r) { return r.area.bearing_rad; });
  rule_numbers("min_dbh_cm", [](const CountingRule& r) { return r.min_dbh_cm; });
  std::vector<double> breast_height_m;
  for (const auto& s : surveys) breast_height_m.push_back(s.summary.breast_height_m);
  t.set("breast_height_m", std::move(breast_height_m));
  texts("reference", [](const Survey& s) { return s.reference_file; });
  const auto own_columns = [](const Survey& s) { return s.reference_file == "reference_trees.csv"; };
  texts("reference_columns", [&](const Survey& s) { return own_columns(s) ? s.summary.reference_columns : ""; });
  texts("reference_rows", [&](const Survey& s) { return own_columns(s) ? s.summary.reference_rows : ""; });
  texts("cloud", [](const Survey& s) {
    for (const char* name : {"cloud.laz", "cloud.las", "cloud.ply"})
      if (fs::is_regular_file(s.folder / name)) return (s.folder / name).string();
    return std::string();
  });
  return t;
}

template <class Member>
Table stacked(const std::vector<Survey>& surveys, Member table_of) {
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
  std::vector<Survey> surveys;
  Reader reader(out.report);
  for (std::size_t i = 0; i < folders.size(); ++i) {
    run.report(static_cast<double>(i) / static_cast<double>(folders.size()), "read " + own_names[i]);
    run.check_cancel();
    surveys.push_back(reader.read(folders[i], names[i].empty() ? own_names[i] : names[i]));
    surveys.back().plot = plots[i];
    surveys.back().system = systems[i].empty() ? surveys.back().summary.system : systems[i];
  }
  out.runs = runs_table(surveys);
  out.stems = stacked(surveys, [](const Survey& s) -> const Table& { return s.stems; });
  out.poses = stacked(surveys, [](const Survey& s) { return poses_table(s.trajectory); });
  out.boundaries = stacked(surveys, [](const Survey& s) { return boundary_table(s.rule); });
  out.reference_stems = stacked(surveys, [](const Survey& s) { return s.reference.value_or(Table()); });
  out.reference_poses = stacked(surveys, [](const Survey& s) { return poses_table(s.reference_trajectory); });
  out.report.counts["runs"] = static_cast<std::int64_t>(surveys.size());
  out.report.counts["stems"] = static_cast<std::int64_t>(out.stems.rows());
  out.report.message = fmt::format("{} runs with {} stems", surveys.size(), out.stems.rows());
  return out;
}

}  // namespace bole::io
