#include "io/core/runs/survey_folder.h"

#include <fmt/format.h>

#include <utility>

#include "io/core/runs/plot_file.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

class SurveyReader {
 public:
  explicit SurveyReader(Report& report) : report_(report) {}

  SurveyFolder read(const fs::path& folder, const std::string& name) {
    SurveyFolder s;
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
    take_loops(s);
    if (fs::exists(folder / "FAILED_RUN.txt"))
      look(s, "older_survey", "the last run in this folder failed: the survey before it is compared");
    if (fs::exists(folder / "FINISHED_EARLY.txt")) look(s, "finished_early", "this run was asked to finish early");
    if (s.summary.verdict == "refused") look(s, "refused_survey", "the verdict of this run is: refused");
    return s;
  }

 private:
  void look(const SurveyFolder& s, const char* code, const std::string& text) {
    report_.find(Severity::look, code, s.name + ": " + text);
  }

  template <class Read>
  void attempt(const SurveyFolder& s, const char* file, const char* without, Read read) {
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

  void take_reference(SurveyFolder& s) {
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

  // Of surveys with loop closures alone; a map made from given poses has none.
  void take_loops(SurveyFolder& s) {
    if (!fs::exists(s.folder / "loops.csv")) return;
    attempt(s, "loops.csv", "its loop closures are not drawn", [&](const fs::path& file) {
      const Table all = read_table(file);
      s.loops.set("from_time_s", all.numbers("from_time_s"));
      s.loops.set("to_time_s", all.numbers("to_time_s"));
    });
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

}  // namespace

SurveyFolder read_survey_folder(const fs::path& folder, const std::string& name, Report& report) {
  return SurveyReader(report).read(folder, name);
}

}  // namespace bole::io
