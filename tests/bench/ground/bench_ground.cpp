// Speed of the terrain model on synthetic forest floors of one and four million points.
#include <benchmark/benchmark.h>

#include "ground/core/model_ground.h"
#include "synthetic/terrain.h"

namespace {

bole::PointCloud forest(double points) {
  bole::synthetic::TerrainRecipe r;
  r.size_m = 40, r.rocks = 20, r.fallen_stems = 10, r.shrubs = 50, r.stems = 80, r.low_outlier_share = 0.0005;
  // About a quarter of the points are stems and crowns.
  r.ground_per_m2 = 0.75 * points / (r.size_m * r.size_m);
  return bole::synthetic::Terrain(r).cloud();
}

void model_ground(benchmark::State& state) {
  const auto cloud = forest(static_cast<double>(state.range(0)) * 1e6);
  for (auto _ : state) benchmark::DoNotOptimize(bole::ground::model_ground(cloud, {}, bole::Run{}));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(cloud.size()));
  state.counters["points"] = static_cast<double>(cloud.size());
}
BENCHMARK(model_ground)
    ->Arg(1)
    ->Arg(4)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
