// A run of a survey, as the comparison of runs takes it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cloud/plot_area.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"

namespace bole::evaluation {

struct ComparedRun {
  std::string name, system, preset, scan;
  std::string plot;  // empty where it is not named
  Table stems;       // tree_id, x_m, y_m, dbh_cm; `counted` tells which count where no rule is known
  std::optional<CountingRule> rule;
  std::optional<Table> reference;                 // trees in columns of their own:
  std::string reference_columns, reference_rows;  // as the options of evaluation.plot
  Trajectory trajectory, reference_trajectory;    // empty where there is none
};

// The outputs of io.read_runs; all but `runs` and `stems` may be null.
struct RunTables {
  const Table* runs = nullptr;
  const Table* stems = nullptr;
  const Table* poses = nullptr;
  const Table* boundaries = nullptr;
  const Table* reference_stems = nullptr;
  const Table* reference_poses = nullptr;
};

// Throws Error{bad_input} where a column is absent.
std::vector<ComparedRun> runs_of(const RunTables& tables);

// The rows whose column `run` is `run`, without this column and without columns that are empty in all of them.
Table rows_of_run(const Table& table, std::size_t run);

}  // namespace bole::evaluation
