// One Livox frame (0.1 s, 24 000 pulses) from raw points to rows, and the steps that cost most.
#include <benchmark/benchmark.h>

#include "frame_chain.h"
#include "sim/core/field/simulate_field.h"

namespace {

using namespace bole;
using namespace bole::rows;

const sim::FieldScan& scan_of(const std::string& field) {
  static std::map<std::string, sim::FieldScan> scans;
  auto it = scans.find(field);
  if (it == scans.end()) {
    sim::FieldSimulationOptions o;
    o.field = field;
    it = scans.emplace(field, sim::simulate_field(o, {})).first;
  }
  return it->second;
}

ChainSettings settings() {
  ChainSettings s;
  s.ground.sensor_height = 0.45;
  s.trunks.centre = rows::TrunkCentre::face;
  s.rows.direction_deg = 90;
  return s;
}

void whole_frame(benchmark::State& state, const std::string& field) {
  const auto& scan = scan_of(field);
  const auto s = settings();
  for (auto _ : state) {
    Report report;
    const auto centres = centres_of(scan.frames[0], &scan.attitude, s, report);
    if (centres.rows() >= 2) benchmark::DoNotOptimize(find_rows(centres, s.rows, {}));
  }
  state.counters["points"] = static_cast<double>(scan.frames[0].size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scan.frames[0].size()));
}

void one_step(benchmark::State& state, int step) {
  const auto& scan = scan_of("metasequoia");
  const auto s = settings();
  const bole::Run run;
  const auto levelled = level(scan.frames[0], {}, &scan.attitude), dense = cut_region(levelled, s.region),
             thin = voxel_centroids(dense, s.voxel);
  const auto above = remove_ground(thin, s.ground, run), kept = radius_filter(above, s.radius, run),
             plants = mean_shift(kept, s.mean_shift, run);
  for (auto _ : state) {
    Report report;
    if (step == 0) benchmark::DoNotOptimize(level(scan.frames[0], {}, &scan.attitude));
    if (step == 1) benchmark::DoNotOptimize(cut_region(levelled, s.region));
    if (step == 2) benchmark::DoNotOptimize(voxel_centroids(dense, s.voxel));
    if (step == 3) benchmark::DoNotOptimize(remove_ground(thin, s.ground, run));
    if (step == 4) benchmark::DoNotOptimize(radius_filter(above, s.radius, run));
    if (step == 5) benchmark::DoNotOptimize(mean_shift(kept, s.mean_shift, run));
    if (step == 6) benchmark::DoNotOptimize(trunk_centres(plants, &dense, s.trunks, report));
  }
}

BENCHMARK_CAPTURE(whole_frame, tubes1, "tubes1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, metasequoia, "metasequoia")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, apple, "apple")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, level, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, region, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, voxel, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, remove_ground, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, radius_filter, 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, mean_shift, 5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_step, trunks, 6)->Unit(benchmark::kMillisecond);

}  // namespace
