#include "report/compare/loop_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cloud/table_columns.h"
#include "io/core/clouds/cloud_reader.h"
#include "render/charts/trajectory_charts.h"
#include "render/maps/loop_sheet.h"

namespace bole::report {
namespace {

constexpr std::size_t max_runs = 4;
constexpr double cell_m = 0.01, low_m = 0.5, high_m = 2.5;  // of the map; heights above ground

std::vector<std::pair<double, double>> loops_of(const CompareData& data, std::size_t run) {
  std::vector<std::pair<double, double>> loops;
  if (data.loops == nullptr || !data.loops->has("from_time_s")) return loops;
  const auto runs = data.loops->integers("run");
  const auto from = data.loops->numbers("from_time_s"), to = data.loops->numbers("to_time_s");
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i] == static_cast<std::int64_t>(run) + 1) loops.emplace_back(from[i], to[i]);
  return loops;
}

std::string note_of(const CompareData& data, std::size_t run, std::size_t loops) {
  std::string note = fmt::format("{} loop closure{}", loops, loops == 1 ? "" : "s");
  if (data.groups == nullptr || !data.groups->has("ate_rmse_m")) return note;
  const auto runs = data.groups->integers("run");
  const auto ate = data.groups->numbers("ate_rmse_m");
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (data.groups->texts("scope")[i] == "run" && runs[i] == static_cast<std::int64_t>(run) + 1 &&
        std::isfinite(ate[i]))
      note += fmt::format(", ATE {:.1f} cm", 100 * ate[i]);
  return note;
}

// The window in the axes of the file.
std::string bounds_text(const render::MapWindow& window, const Pose& T_sheet_file) {
  Eigen::Vector2d lo = Eigen::Vector2d::Constant(1e300), hi = -lo;
  for (const double x : {window.lo().x(), window.hi().x()})
    for (const double y : {window.lo().y(), window.hi().y()}) {
      const Eigen::Vector2d p = (T_sheet_file.inverse() * Eigen::Vector3d(x, y, 0)).head<2>();
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  return fmt::format("{},{},{},{}", lo.x(), lo.y(), hi.x(), hi.y());
}

render::PlanDensity map_in(const std::string& file, const render::MapWindow& window, const Pose& T_sheet_file,
                           const Run& run) {
  if (file.empty()) return {};
  io::CloudReadOptions options;
  options.bounds = bounds_text(window, T_sheet_file);
  const auto cloud = io::read_cloud(file, options, run).cloud;
  const bool heights = cloud.has(arrays::height_above_ground);
  auto map = render::plan_density(window.lo(), window.hi(), cell_m);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (heights) {
      const double h = column_value(cloud.column(arrays::height_above_ground.name), i);
      if (!(h >= low_m && h <= high_m)) continue;
    }
    map.add((T_sheet_file * cloud.position(i)).head<2>());
  }
  return map;
}

}  // namespace

bool any_loops(const CompareData& data, const std::vector<std::size_t>& runs) {
  return std::ranges::any_of(runs, [&](std::size_t r) { return !loops_of(data, r).empty(); });
}

render::Figure loop_figure(const CompareData& data, std::vector<ComparedRunPath> paths, const Trajectory& reference,
                           bool common_axes, double width_mm, const Run& run) {
  if (paths.size() > max_runs) paths.resize(max_runs);
  std::vector<Pose> to_sheet(paths.size(), Pose::Identity());
  if (!common_axes) {
    const Trajectory common = reference.empty() ? paths.front().path : reference;
    for (std::size_t k = 0; k < paths.size(); ++k) {
      to_sheet[k] = render::alignment_to(paths[k].path, common).value_or(Pose::Identity());
      for (auto& pose : paths[k].path.poses) pose.T_target_sensor = to_sheet[k] * pose.T_target_sensor;
    }
  }
  const auto window = render::loop_window(paths[0].path, paths[1].path);
  std::vector<render::LoopRun> runs;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    run.check_cancel();
    const auto r = paths[k].run;
    auto loops = loops_of(data, r);
    runs.push_back({data.compared->texts("name")[r], note_of(data, r, loops.size()), paths[k].color, paths[k].path,
                    std::move(loops), map_in(data.runs->texts("cloud")[r], window, to_sheet[k], run)});
  }
  return render::loop_sheet(runs, reference, window, width_mm);
}

}  // namespace bole::report
