// Speed of the simulator. `rays` counts every ray cast, `items` the pulses (8 rays each).
#include <benchmark/benchmark.h>

#include "base/resources.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/plot/recipe.h"
#include "sim/core/walk/route.h"
#include "sim/core/walk/scan.h"

namespace {

using namespace bole;
using namespace bole::sim;

void scan_plot(benchmark::State& state, const char* plot, const char* sensor_name) {
  const Forest forest = make_forest(read_recipe(resource_path(std::string("plots/") + plot + ".json")), 1);
  const PlotScene plot_scene = build_scene(forest, 1);
  const RayScene rays(plot_scene.model);
  const sensor::SensorModel sensor = sensor::load_sensor_model(sensor_name);
  const auto route =
      plan_route(walk_pattern(forest.recipe.size_m, 6), forest, plot_scene.vegetation.obstacles, Walk::step_m);
  WalkParameters parameters;
  parameters.stand_still_s = 0;
  parameters.max_s = 2;
  const Walk walk(route, forest.terrain, parameters, 1);
  ScanStatistics statistics;
  std::int64_t pulses = 0;
  for (auto _ : state) {
    statistics = scan(sensor, {}, rays, walk, sensor.rotation_hz, 1, {}, [](const FiringSequence&) {});
    pulses += statistics.pulses;
  }
  state.SetItemsProcessed(pulses);
  state.counters["rays"] =
      benchmark::Counter(static_cast<double>(pulses) * RayBundle::size, benchmark::Counter::kIsRate);
  state.counters["triangles"] = static_cast<double>(rays.triangles());
}

BENCHMARK_CAPTURE(scan_plot, demo_vlp32c, "demo", "vlp32c")
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan_plot, plot1_vlp32c, "plot1", "vlp32c")
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
