#include "evaluation/core/compared_run.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/option.h"

namespace bole::evaluation {
namespace {

bool is_empty(const Table::Values& values) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&values))
    return std::ranges::all_of(*numbers, [](double v) { return std::isnan(v); });
  if (const auto* texts = std::get_if<std::vector<std::string>>(&values))
    return std::ranges::all_of(*texts, [](const std::string& v) { return v.empty(); });
  return std::get<std::vector<std::int64_t>>(values).empty();
}

Trajectory trajectory_of(const Table& poses) {
  Trajectory out;
  if (poses.rows() == 0) return out;
  const auto time = poses.numbers("time_s"), x = poses.numbers("x_m"), y = poses.numbers("y_m"),
             z = poses.numbers("z_m"), qx = poses.numbers("qx"), qy = poses.numbers("qy"), qz = poses.numbers("qz"),
             qw = poses.numbers("qw");
  for (std::size_t i = 0; i < poses.rows(); ++i) {
    StampedPose pose;
    pose.time_s = time[i];
    pose.T_target_sensor.linear() = Eigen::Quaterniond(qw[i], qx[i], qy[i], qz[i]).normalized().toRotationMatrix();
    pose.T_target_sensor.translation() = Eigen::Vector3d(x[i], y[i], z[i]);
    out.poses.push_back(pose);
  }
  out.axes = Axes::plot;
  return out;
}

CountingRule rule_of(const Table& runs, const Table* boundaries, std::size_t row) {
  Table plot;
  plot.facts["shape"] = runs.texts("shape")[row];
  for (const char* name : {"centre_x_m", "centre_y_m", "width_m", "length_m", "bearing_rad", "min_dbh_cm"})
    plot.facts[name] = number_text(runs.numbers(name)[row]);
  const Table outline = boundaries != nullptr ? rows_of_run(*boundaries, row + 1) : Table();
  for (const char* name : {"x_m", "y_m"})
    plot.set(name, outline.rows() > 0 ? outline.numbers(name) : std::vector<double>());
  return counting_rule(plot);
}

}  // namespace

Table rows_of_run(const Table& table, std::size_t run) {
  const auto runs = table.integers("run");
  std::vector<std::size_t> picked;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i] == static_cast<std::int64_t>(run)) picked.push_back(i);
  const Table part = table.subset(picked);
  Table out;
  for (const auto& column : part.columns())
    if (column.name != "run" && !is_empty(column.values)) out.set(column.name, column.values);
  return out;
}

std::vector<ComparedRun> runs_of(const RunTables& tables) {
  const auto& runs = *tables.runs;
  std::vector<ComparedRun> out;
  const auto part = [](const Table* table, std::size_t run) { return table ? rows_of_run(*table, run) : Table(); };
  for (std::size_t i = 0; i < runs.rows(); ++i) {
    ComparedRun r;
    r.name = runs.texts("name")[i];
    r.system = runs.texts("system")[i];
    r.preset = runs.texts("preset")[i];
    r.scan = runs.texts("scan")[i];
    r.plot = runs.texts("plot")[i];
    r.stems = part(tables.stems, i + 1);
    if (runs.integers("has_plot")[i] != 0) r.rule = rule_of(runs, tables.boundaries, i);
    if (auto reference = part(tables.reference_stems, i + 1); reference.rows() > 0) r.reference = std::move(reference);
    r.reference_columns = runs.texts("reference_columns")[i];
    r.reference_rows = runs.texts("reference_rows")[i];
    r.trajectory = trajectory_of(part(tables.poses, i + 1));
    r.reference_trajectory = trajectory_of(part(tables.reference_poses, i + 1));
    out.push_back(std::move(r));
  }
  return out;
}

}  // namespace bole::evaluation
