// Points per second of slice and measurement on a plot of 3 M points.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "stems/core/breast_height_slice.h"
#include "stems/core/measure_stems.h"
#include "synthetic/stem_cloud.h"

namespace bole {
namespace {

constexpr std::size_t points_wanted = 3'000'000;

// 25 stems seen by rays, and as many points of ground and crowns as make a plot.
const synthetic::StemCloud& plot() {
  static const synthetic::StemCloud cloud = [] {
    synthetic::StemCloudOptions o;
    o.passes = 3;
    auto stems = synthetic::make_stem_cloud(synthetic::random_stand(25, 0.08, 0.40, 1), o);
    auto positions = stems.points.positions();
    auto height = stems.points.values<float>(arrays::height_above_ground);
    auto sx = stems.points.values<float>(arrays::sensor_x), sy = stems.points.values<float>(arrays::sensor_y),
         sz = stems.points.values<float>(arrays::sensor_z);
    auto time = stems.points.values<double>(arrays::time);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> u(-10, 10), crown(6, 15), ground(0, 0.05F);
    while (positions.size() < points_wanted) {
      const float z = positions.size() % 2 == 0 ? ground(random) : crown(random);
      positions.emplace_back(u(random), u(random), z), height.push_back(z);
      sx.push_back(0), sy.push_back(0), sz.push_back(1.6F), time.push_back(0);
    }
    stems.points = PointCloud(std::move(positions));
    stems.points.set_column(arrays::height_above_ground, std::move(height)),
        stems.points.set_column(arrays::time, std::move(time));
    stems.points.set_column(arrays::sensor_x, std::move(sx)), stems.points.set_column(arrays::sensor_y, std::move(sy)),
        stems.points.set_column(arrays::sensor_z, std::move(sz));
    return stems;
  }();
  return cloud;
}

void slice(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(stems::breast_height_slice(plot().points, {}, {}));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(plot().points.size()));
}
BENCHMARK(slice)->Unit(benchmark::kMillisecond);

void measure(benchmark::State& state) {
  std::size_t stems = 0;
  for (auto _ : state)
    stems = stems::measure_stems(plot().points, usual_breast_height_m, plot().dem, nullptr, {}, {}).stems.size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(plot().points.size()));
  state.counters["stems"] = static_cast<double>(stems);
}
BENCHMARK(measure)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace bole
