// The folder of one survey: what `bole run` wrote into it, read to be compared.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "io/core/runs/run_summary.h"

namespace bole::io {

struct SurveyFolder {
  std::filesystem::path folder;
  std::string name, plot, system;
  RunSummary summary;
  Table stems;
  std::optional<CountingRule> rule;
  std::optional<Table> reference;
  std::string reference_file;
  Trajectory trajectory, reference_trajectory;
  Table loops;  // from_time_s, to_time_s: the loop closures of the run
};

// Needs stems.csv: Error{bad_input} without it. Whatever else is missing or damaged becomes a finding in `report` that
// begins with `name`. `plot` and `system` stay empty.
SurveyFolder read_survey_folder(const std::filesystem::path& folder, const std::string& name, Report& report);

// A row per survey, as RunFolders::runs.
Table runs_table(const std::vector<SurveyFolder>& surveys);
// time_s, x_m, y_m, z_m, qx, qy, qz, qw.
Table poses_table(const Trajectory& trajectory);
// x_m, y_m: vertices of the plot; empty without a rule.
Table boundary_table(const std::optional<CountingRule>& rule);

}  // namespace bole::io
