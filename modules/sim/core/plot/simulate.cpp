#include "sim/core/plot/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/angles.h"
#include "base/version.h"
#include "sensor/core/sensor_model.h"
#include "sim/core/field/vineyard.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/plot/recipe.h"
#include "sim/core/plot/recipe_fields.h"
#include "sim/core/plot/truth.h"
#include "sim/core/scene/wind.h"
#include "sim/core/walk/disturbance.h"
#include "sim/core/walk/imu.h"
#include "sim/core/walk/route.h"
#include "sim/core/walk/scan.h"
#include "sim/core/walk/scan_writer.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

std::vector<Eigen::Vector2d> read_way_points(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw bad_input("cannot open the walk " + file.string(), "a readable file with one x_m,y_m per line");
  std::vector<Eigen::Vector2d> points;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#' || (number == 1 && line.find_first_of("xX") != std::string::npos)) continue;
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    double x = 0, y = 0;
    if (!(words >> x >> y) || !(std::abs(x) < 200 && std::abs(y) < 200))
      throw bad_input(file.string() + ":" + std::to_string(number) + " is '" + line.substr(0, 60) + "'",
                      "x_m,y_m in plot axes, within 200 m");
    if (points.size() >= 10000) throw bad_input(file.string() + " has more than 10000 way-points", "fewer");
    points.emplace_back(x, y);
  }
  if (points.size() < 2)
    throw bad_input(file.string() + " has " + std::to_string(points.size()) + " way-points", "at least 2");
  return points;
}

void write_recipe(const SimulationOptions& options, const PlotRecipe& recipe, const sensor::SensorModel& sensor,
                  const fs::path& file) {
  nlohmann::json json;
  json["version"] = version();
  json["plot"] = to_json(recipe);
  json["sensor"] = sensor.name;
  for (const auto& spec : option_table(&options).specs)
    std::visit([&](const auto& value) { json["options"][spec.name] = value; }, spec.get(&options));
  std::ofstream out(file, std::ios::binary);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) throw failure("cannot write " + file.string(), "a writable folder with free space");
}

void write_truth(const SimulationOptions& options, const Forest& forest, const Vegetation& vegetation,
                 const fs::path& dir) {
  write_csv(tree_table(forest), dir / "trees.csv");
  write_csv(sapling_table(vegetation.saplings), dir / "saplings.csv");
  write_csv(target_table(forest), dir / "targets.csv");
  write_dem(forest.terrain.raster(forest.half_side_m() + 4, options.dem_cell), dir / "dem.tif");
}

void write_inertial(const SimulationOptions& options, const Walk& walk, const fs::path& dir) {
  const fs::path file = dir / "imu.csv";
  // A unit of an older simulation would fit by its times, and SLAM would take it.
  fs::remove(file);
  if (options.imu == ImuGrade::none) return;
  auto record = simulate_imu([&](double t) { return walk.pose(t); }, walk.duration_s(), simulation_epoch_s,
                             {errors_of(options.imu), options.imu_rate, options.imu_time_offset},
                             static_cast<std::uint64_t>(options.seed));
  record.name = "simulated " + std::string(choice_name(options.imu)) + " unit";
  if (!options.imu_mount_known) record.T_sensor_imu.reset();
  write_imu(record, file);
}

Report report_of(const PlotRecipe& recipe, const Forest& forest, const PlotScene& scene, const RayScene& rays,
                 const Walk& walk, const sensor::SensorModel& sensor, const ScanStatistics& statistics,
                 double seconds) {
  Report report;
  const auto in_plot = std::ranges::count_if(forest.trees, [](const Tree& t) { return t.in_plot && !t.pole; });
  const auto poles = std::ranges::count_if(forest.trees, &Tree::pole);
  report.message = recipe.name + ": " + std::to_string(in_plot) + " trees, " +
                   number_text(std::round(walk.duration_s())) + " s of " + sensor.name + ", " +
                   std::to_string(statistics.returns) + " returns";
  report.counts = {{"trees", in_plot},
                   {"trees_around", static_cast<std::int64_t>(forest.trees.size()) - in_plot - poles},
                   {"saplings", static_cast<std::int64_t>(scene.vegetation.saplings.size())},
                   {"triangles", static_cast<std::int64_t>(rays.triangles())},
                   {"pulses", statistics.pulses},
                   {"returns", statistics.returns}};
  if (poles > 0) report.counts["poles"] = poles;
  report.metrics = {
      {"recording", {walk.duration_s(), Unit::second}},
      {"walk", {walk.length_m(), Unit::metre}},
      {"pulses_per_second", {static_cast<double>(statistics.pulses) / std::max(1e-9, seconds)}},
      {"rays_per_second", {static_cast<double>(statistics.pulses) * RayBundle::size / std::max(1e-9, seconds)}}};
  report.facts["axes"] = "plot";
  return report;
}

}  // namespace

Report simulate(const SimulationOptions& options, const fs::path& out_dir, const Run& run) {
  const auto seed = static_cast<std::uint64_t>(options.seed);
  const sensor::SensorModel sensor = sensor::load_sensor_model(options.sensor);
  const PlotRecipe recipe = read_recipe(find_recipe("plots", options.plot));
  std::error_code error;
  fs::create_directories(out_dir, error);
  if (error) throw failure("cannot make the folder " + out_dir.string() + ": " + error.message());

  run.report(0, "growing the plot");
  const Forest forest = make_forest(recipe, seed);
  run.check_cancel();
  const PlotScene scene = build_scene(forest, seed);
  run.check_cancel();
  run.report(0.02, "planning the walk");
  const auto way_points = !options.walk.empty()  ? read_way_points(options.walk)
                          : recipe.is_vineyard() ? vineyard_pattern(recipe.vineyard)
                                                 : walk_pattern(recipe.size_m, options.line_spacing);
  const auto route = plan_route(way_points, forest, scene.vegetation.obstacles, Walk::step_m);
  const Walk walk(route, forest.terrain,
                  {options.speed, options.sensor_height, options.gait, options.stand_still, options.max_time,
                   radians(options.turn_on_spot), options.carrier, radians(options.mount_tilt)},
                  seed);
  run.check_cancel();
  run.report(0.03, "building the ray tracer");
  std::optional<Wind> wind;
  if (options.wind > 0)
    wind.emplace(forest.trees, scene.vegetation.low_plants, WindParameters{options.wind, radians(options.wind_from)},
                 walk.duration_s(), seed);
  const auto writer = make_scan_writer(sensor, out_dir, simulation_epoch_s, options.rotation_hz, options.dual_return);
  const RayScene rays(scene.model, wind ? &*wind : nullptr);
  write_truth(options, forest, scene.vegetation, out_dir);
  write_tum(walk.trajectory(options.trajectory_rate, simulation_epoch_s), out_dir / "trajectory.tum");
  write_inertial(options, walk, out_dir);
  write_recipe(options, recipe, sensor, out_dir / "recipe.json");

  const auto start = std::chrono::steady_clock::now();
  const BeamParameters beam{options.noise,        options.divergence,
                            options.dropouts,     options.laser_bias,
                            options.pulse_length, options.bark,
                            options.bark_facets,  options.noise_growth,
                            options.wet,          radians(options.angle_error),
                            options.dual_return,  sensor.packet == sensor::PacketFormat::ouster};
  Disturbance disturbance({options.gap_at, options.gap, radians(options.blind_sector), options.rain, options.companion,
                           options.operator_body, options.clock_jitter, options.sensor_height, options.noise},
                          sensor, walk, seed);
  const auto statistics =
      scan(sensor, beam, rays, walk, options.rotation_hz, seed, run.part(0.06, 1), [&](FiringSequence s) {
        if (disturbance.apply(s)) writer->add(s);
      });
  writer->close();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  Report report = report_of(recipe, forest, scene, rays, walk, sensor, statistics, seconds);
  if (run.asked_to_finish()) report.status = Status::finished_early;
  return report;
}

}  // namespace bole::sim
