// Points per second of the readers, from files in memory or the page cache.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/scans/frame_source.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole {
namespace {

namespace fs = std::filesystem;

// Files of this process, gone with it.
class Files {
 public:
  Files() : dir_(fs::temp_directory_path() / "bole_bench_readers") {
    fs::create_directories(dir_);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 30);
    PointCloud::Positions positions;
    std::vector<float> intensity;
    for (int i = 0; i < 300000; ++i)
      positions.emplace_back(uniform(random), uniform(random), uniform(random)),
          intensity.push_back(std::floor(uniform(random)));
    PointCloud cloud(std::move(positions), {450000, 5400000, 300});
    cloud.set_column(arrays::intensity, std::move(intensity));
    io::write_cloud(dir_ / "a.ply", cloud);
    io::write_cloud(dir_ / "a.xyz", cloud);
    const auto model = sensor::load_sensor_model("vlp32c");
    sensor::PcapWriter writer(dir_ / "a.pcap");
    sensor::VelodyneEncoder encoder(
        model, sensor::VelodyneReturnMode::strongest,
        [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) { writer.write(bytes, time_s); });
    const std::vector<sensor::LaserEcho> echoes(model.channels.size(), {10, 40});
    for (int s = 0; s < 36000; ++s)
      encoder.add(1.7e9 + s * model.sequence_period_s, 20 * std::numbers::pi * s * model.sequence_period_s, echoes);
    writer.close();
  }
  ~Files() {
    std::error_code ignored;
    fs::remove_all(dir_, ignored);
  }
  fs::path operator/(const char* name) const { return dir_ / name; }

 private:
  fs::path dir_;
};

const Files& files() {
  static const Files instance;
  return instance;
}

void read_cloud_file(benchmark::State& state, const char* name) {
  const auto path = files() / name;
  std::size_t points = 0;
  for (auto _ : state) points += io::read_cloud(path).cloud.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(points));
}

void index_pcap(benchmark::State& state) {
  const auto path = files() / "a.pcap";
  std::size_t frames = 0;
  for (auto _ : state) frames += io::open_frame_source(path)->size();
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsRate);
}

void decode_pcap(benchmark::State& state) {
  const auto source = io::open_frame_source(files() / "a.pcap");
  ScanFrame frame;
  std::size_t points = 0;
  for (auto _ : state)
    for (std::size_t i = 0; i < source->size(); ++i) {
      source->read(i, frame);
      points += frame.size();
    }
  state.SetItemsProcessed(static_cast<std::int64_t>(points));
}

BENCHMARK_CAPTURE(read_cloud_file, ply, "a.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_cloud_file, xyz, "a.xyz")->Unit(benchmark::kMillisecond);
BENCHMARK(index_pcap)->Unit(benchmark::kMillisecond);
BENCHMARK(decode_pcap)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bole
