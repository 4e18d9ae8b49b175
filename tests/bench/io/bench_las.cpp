// Points per second of the LAS and LAZ readers and the LAS writer.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "io/core/las/las_reader.h"
#include "io/core/las/las_writer.h"

namespace {

using bole::PointCloud;

const std::filesystem::path folder = std::filesystem::temp_directory_path() / "bole_bench_las";

// A cloud as a SLAM run leaves it: 2 M points with time and intensity.
PointCloud synthetic(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-50, 50);
  PointCloud::Positions positions(count);
  std::vector<float> intensity(count);
  std::vector<double> time(count);
  for (std::size_t i = 0; i < count; ++i) {
    positions[i] = {uniform(random), uniform(random), uniform(random)};
    intensity[i] = static_cast<float>(i % 256), time[i] = 3e8 + 1e-6 * static_cast<double>(i);
  }
  PointCloud cloud(std::move(positions), {691000, 5334000, 500});
  cloud.set_column(bole::arrays::intensity, intensity);
  cloud.set_column(bole::arrays::time, time);
  return cloud;
}

constexpr std::size_t count = 2'000'000;

const std::filesystem::path& synthetic_file() {
  static const std::filesystem::path path = [] {
    bole::io::write_las(folder / "synthetic.las", synthetic(count));
    return folder / "synthetic.las";
  }();
  return path;
}

void read(benchmark::State& state, const std::filesystem::path& path) {
  std::size_t points = 0;
  for (auto _ : state) points += bole::io::read_las(path).size();
  state.SetItemsProcessed(static_cast<std::int64_t>(points));
}

void ReadLas(benchmark::State& state) { read(state, synthetic_file()); }
BENCHMARK(ReadLas)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void ReadLaz(benchmark::State& state, const char* sample) {
  const auto path = std::filesystem::path(BOLE_SHARED_DATA_DIR) / sample;
  if (!std::filesystem::exists(path)) return state.SkipWithError("the sample is absent");
  read(state, path);
}
BENCHMARK_CAPTURE(ReadLaz, pointwise_format3, "als_ground/AHN3.laz")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(ReadLaz, layered_format6, "tls_spanner/TLS_Clip.laz")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void WriteLas(benchmark::State& state) {
  const PointCloud cloud = synthetic(count);
  for (auto _ : state) bole::io::write_las(folder / "written.las", cloud);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}
BENCHMARK(WriteLas)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
