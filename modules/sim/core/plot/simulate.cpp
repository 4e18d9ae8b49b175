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
#include "sim/core/walk/disturbance.h"
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

Report report_of(const PlotRecipe& recipe, const Forest& forest, const PlotScene& scene, const RayScene& rays,
                 const Walk& walk, const sensor::SensorModel& sensor, const ScanStatistics& statistics,
                 double seconds) {
  Report report;
  const auto in_plot = std::ranges::count_if(forest.trees, &Tree::in_plot);
  report.message = recipe.name + ": " + std::to_string(in_plot) + " trees, " +
                   number_text(std::round(walk.duration_s())) + " s of " + sensor.name + ", " +
                   std::to_string(statistics.returns) + " returns";
  report.counts = {{"trees", in_plot},
                   {"trees_around", static_cast<std::int64_t>(forest.trees.size()) - in_plot},
                   {"saplings", static_cast<std::int64_t>(scene.vegetation.saplings.size())},
                   {"triangles", static_cast<std::int64_t>(rays.triangles())},
                   {"pulses", statistics.pulses},
                   {"returns", statistics.returns}};
  report.metrics = {
      {"recording", {walk.duration_s(), Unit::second}},
      {"walk", {walk.length_m(), Unit::metre}},
      {"pulses_per_second", {static_cast<double>(statistics.pulses) / std::max(1e-9, seconds)}},
      {"rays_per_second", {static_cast<double>(statistics.pulses) * RayBundle::size / std::max(1e-9, seconds)}}};
  report.facts["axes"] = "plot";
  return report;
}

using Entries = std::vector<OptionEntry<SimulationOptions>>;

Entries plot_and_sensor_entries() {
  using S = SimulationOptions;
  return {
      Option<S, std::string>{"plot",
                             &S::plot,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Plot recipe: a name in resources/plots or the path of a recipe file."},
      Option<S, int>{"seed",
                     &S::seed,
                     Unit::none,
                     {0, 2147483647},
                     Tier::basic,
                     "Seed of all randomness. The same seed gives the same bytes."},
      Option<S, std::string>{"sensor",
                             &S::sensor,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Sensor: a name in resources/sensors or the path of a sensor file."},
      Option<S, double>{"rotation_rate",
                        &S::rotation_hz,
                        Unit::hertz,
                        {1, 20},
                        Tier::advanced,
                        "Revolutions of the sensor per second."},
  };
}

Entries walk_entries() {
  using S = SimulationOptions;
  return {
      Option<S, std::string>{"walk",
                             &S::walk,
                             TextKind::input_path,
                             {},
                             Tier::advanced,
                             "File of way-points, one x_m,y_m per line in plot axes. Without it the walk leads along "
                             "parallel lines, or through the alleys of a vineyard."},
      Option<S, Carrier>{"carrier", &S::carrier, Tier::advanced,
                         "Carrier of the sensor: a walking person, or a tracked robot that rolls and pitches with the "
                         "ground under its tracks."},
      Option<S, double>{"speed", &S::speed, Unit::metre_per_second, {0.2, 3}, Tier::basic, "Walking speed."},
      Option<S, double>{"line_spacing",
                        &S::line_spacing,
                        Unit::metre,
                        {1, 50},
                        Tier::basic,
                        "Distance between the parallel lines of the walk."},
      Option<S, double>{"sensor_height",
                        &S::sensor_height,
                        Unit::metre,
                        {0.3, 4},
                        Tier::advanced,
                        "Height of the sensor above the ground."},
      Option<S, double>{"gait",
                        &S::gait,
                        Unit::none,
                        {0, 3},
                        Tier::advanced,
                        "Strength of the operator's bob, sway and hand motion, or of a robot's vibration. 1: an "
                        "ordinary step; 0: a smooth glide."},
      Option<S, double>{"stand_still",
                        &S::stand_still,
                        Unit::second,
                        {0, 60},
                        Tier::advanced,
                        "Time at rest before the walk starts."},
      Option<S, std::optional<double>>{"max_time",
                                       &S::max_time,
                                       Unit::second,
                                       {0.2, 3600},
                                       "none",
                                       Tier::advanced,
                                       "Longest recording. none: the whole walk is recorded."},
      Option<S, double>{"turn_on_spot",
                        &S::turn_on_spot,
                        Unit::degree,
                        {-720, 720},
                        Tier::expert,
                        "Turn on the spot at 90 deg/s, between standing still and walking."},
  };
}

Entries beam_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"noise",
                        &S::noise,
                        Unit::none,
                        {0, 10},
                        Tier::advanced,
                        "Factor on the range noise and on the laser biases of the sensor. 0 gives exact ranges."},
      Option<S, double>{"divergence",
                        &S::divergence,
                        Unit::none,
                        {0, 5},
                        Tier::advanced,
                        "Factor on the size of the laser beam. 0 gives rays without mixed pixels."},
      Option<S, double>{
          "dropouts", &S::dropouts, Unit::none, {0, 0.9}, Tier::expert, "Share of pulses lost at random."},
      Option<S, double>{"laser_bias",
                        &S::laser_bias,
                        Unit::metre,
                        {0, 0.1},
                        Tier::expert,
                        "Standard deviation of the constant range error of each laser."},
      Option<S, double>{"pulse_length",
                        &S::pulse_length,
                        Unit::metre,
                        {0, 3},
                        Tier::expert,
                        "Surfaces in one beam closer together than this give one range between them."},
      Option<S, bool>{"bark", &S::bark, Tier::expert, "Bark with fissures. Otherwise stems are smooth."},
      Option<S, bool>{"bark_facets", &S::bark_facets, Tier::expert,
                      "Bark in plates that lie at different depths, in place of smooth fissures."},
      Option<S, double>{"noise_growth",
                        &S::noise_growth,
                        Unit::none,
                        {0, 5},
                        Tier::expert,
                        "Share by which the range noise grows at grazing incidence and for beams that mostly miss: 1 "
                        "doubles it."},
      OnlyIf{"bark", {"true"}, {"bark_facets"}},
  };
}

Entries disturbance_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"gap_at",
                        &S::gap_at,
                        Unit::second,
                        {0, 3600},
                        Tier::expert,
                        "Time after the start at which packets begin to be lost."},
      Option<S, double>{"gap", &S::gap, Unit::second, {0, 600}, Tier::expert, "Duration of the packet loss."},
      Option<S, double>{"blind_sector",
                        &S::blind_sector,
                        Unit::degree,
                        {0, 350},
                        Tier::expert,
                        "Sector around the back of the sensor from which nothing returns."},
      Option<S, double>{
          "rain", &S::rain, Unit::none, {0, 0.9}, Tier::expert, "Share of pulses that end at a rain drop."},
      Option<S, bool>{"companion", &S::companion, Tier::expert, "A person walks around the operator, 1.2 m away."},
      Unless{"gap", {"0"}, {"gap_at"}},
  };
}

Entries truth_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"trajectory_rate",
                        &S::trajectory_rate,
                        Unit::hertz,
                        {1, 1000},
                        Tier::expert,
                        "Poses per second in trajectory.tum."},
      Option<S, double>{"dem_cell", &S::dem_cell, Unit::metre, {0.05, 5}, Tier::expert, "Cell size of dem.tif."},
  };
}

}  // namespace

const OptionTable& option_table(const SimulationOptions*) {
  static const OptionTable table = [] {
    Entries all;
    for (const auto& part :
         {plot_and_sensor_entries(), walk_entries(), beam_entries(), disturbance_entries(), truth_entries()})
      all.insert(all.end(), part.begin(), part.end());
    return make_option_table<SimulationOptions>(std::move(all));
  }();
  return table;
}

Report simulate(const SimulationOptions& options, const fs::path& out_dir, const Run& run) {
  const auto seed = static_cast<std::uint64_t>(options.seed);
  const sensor::SensorModel sensor = sensor::load_sensor_model(options.sensor);
  if (sensor.rosette) throw bad_input("the sensor " + sensor.name + " scans rosettes", "a sensor that scans lines");
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
                   radians(options.turn_on_spot), options.carrier},
                  seed);
  run.check_cancel();
  run.report(0.03, "building the ray tracer");
  const RayScene rays(scene.model);
  write_truth(options, forest, scene.vegetation, out_dir);
  write_tum(walk.trajectory(options.trajectory_rate, simulation_epoch_s), out_dir / "trajectory.tum");
  write_recipe(options, recipe, sensor, out_dir / "recipe.json");

  const auto start = std::chrono::steady_clock::now();
  const auto writer = make_scan_writer(sensor, out_dir, simulation_epoch_s);
  const BeamParameters beam{options.noise,        options.divergence, options.dropouts,    options.laser_bias,
                            options.pulse_length, options.bark,       options.bark_facets, options.noise_growth};
  Disturbance disturbance({options.gap_at, options.gap, radians(options.blind_sector), options.rain, options.companion,
                           options.sensor_height, options.noise},
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
