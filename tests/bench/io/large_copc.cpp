// large_copc OUT.copc.laz MILLION_POINTS [MEMORY_MIB = 512]: a forest of any size, 200 points on each square metre, as
// a COPC file: ground, stems and crowns. The octree is built as that of a cloud that does not fit into memory, cube by
// cube; no record lies on disk before it is in the octree. Prints what it took.
#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/random.h"
#include "io/core/copc/copc_build.h"

namespace {

using namespace bole;
using io::las::store;

constexpr double tile_m = 20, points_per_m2 = 200, tree_m = 5, step_m = 0.001, lowest_m = -20, highest_m = 60;
constexpr std::size_t record_bytes = 30;
constexpr std::size_t tile_points = static_cast<std::size_t>(tile_m * tile_m * points_per_m2);

double ground_at(double x, double y) { return 4 * std::sin(x / 90) + 3 * std::cos(y / 70) + 0.3 * std::sin(x / 7); }

struct Point {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  int kind = 2;  // class: 2 ground, 4 stems, 5 crowns
};

Point point_of(int column, int row, std::size_t i) {
  Random random(11, static_cast<std::uint64_t>(column) << 32 | static_cast<std::uint32_t>(row), i);
  Point p;
  const double x = tile_m * (column + random.uniform()), y = tile_m * (row + random.uniform());
  const double chance = random.uniform();
  p.place = {x, y, ground_at(x, y) + random.normal(0, 0.015)};
  if (chance < 0.4) return p;
  Random tree(13, static_cast<std::uint64_t>(x / tree_m) << 32 | static_cast<std::uint32_t>(y / tree_m));
  const double tx = tree_m * (std::floor(x / tree_m) + tree.uniform(0.2, 0.8)),
               ty = tree_m * (std::floor(y / tree_m) + tree.uniform(0.2, 0.8));
  const double height = tree.uniform(12, 28), radius = tree.uniform(0.08, 0.25), angle = random.angle();
  const bool stem = chance < 0.5;
  const double up = stem ? random.uniform() * 0.6 * height : height * (0.45 + 0.55 * std::sqrt(random.uniform()));
  const double crown = tree.uniform(1.2, 2.6) * std::sqrt(std::max(0.05, 1 - std::pow(2 * up / height - 1.2, 2)));
  const double r =
      stem ? radius * (1 - 0.5 * up / height) + random.normal(0, 0.004) : crown * std::sqrt(random.uniform());
  p.place = {tx + r * std::cos(angle), ty + r * std::sin(angle), ground_at(tx, ty) + up};
  p.kind = stem ? 4 : 5;
  return p;
}

void write_record(const Point& p, std::uint64_t number, std::uint8_t* record) {
  for (int k = 0; k < 3; ++k) store(record + 4 * k, static_cast<std::int32_t>(std::llround(p.place[k] / step_m)));
  const double up = p.place.z() - ground_at(p.place.x(), p.place.y());
  store(record + 12, static_cast<std::uint16_t>(p.kind == 2 ? 900 + number % 64 : 300 + 40 * up + number % 32));
  record[14] = 0x11;
  record[16] = static_cast<std::uint8_t>(p.kind);
  store(record + 22, 3e8 + 2e-6 * static_cast<double>(number));
}

// Of the tiles that reach into the box.
std::vector<std::uint8_t> records_within(int tiles, const std::array<std::int32_t, 3>& low,
                                         const std::array<std::int32_t, 3>& high) {
  constexpr double crown_m = 3.5;                  // by how much points lie beyond their tile
  if (high[2] * step_m < lowest_m + 1) return {};  // below the ground
  const auto first = [&](std::int32_t steps) {
    return std::max(0, static_cast<int>(std::floor((steps * step_m - crown_m) / tile_m)));
  };
  const auto last = [&](std::int32_t steps) {
    return std::min(tiles - 1, static_cast<int>(std::floor((steps * step_m + crown_m) / tile_m)));
  };
  std::vector<std::array<int, 2>> wanted;
  for (int row = first(low[1]); row <= last(high[1]); ++row)
    for (int column = first(low[0]); column <= last(high[0]); ++column) wanted.push_back({column, row});
  std::vector<std::uint8_t> records(wanted.size() * tile_points * record_bytes);
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t t) {
    const auto [column, row] = wanted[t];
    const auto number =
        (static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(tiles) + static_cast<std::uint64_t>(column)) *
        tile_points;
    for (std::size_t i = 0; i < tile_points; ++i)
      write_record(point_of(column, row, i), number + i, &records[(t * tile_points + i) * record_bytes]);
  });
  return records;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw bad_input("the arguments do not fit", "OUT.copc.laz MILLION_POINTS [MEMORY_MIB]");
    const double millions = std::atof(argv[2]);
    const int tiles = std::max(1, static_cast<int>(std::ceil(std::sqrt(1e6 * millions / tile_points))));
    io::copc::RecordStream stream;
    stream.form.point_format = 6;
    stream.form.record_length = record_bytes;
    stream.form.grid = {Eigen::Vector3d::Constant(step_m), {500'000, 5'400'000, 300}};
    const auto side = static_cast<std::int32_t>((tiles * tile_m + 4) / step_m);
    // All points lie above the middle, so that no cube of a larger side has a part of the heights only.
    stream.low = {-4000, -4000, static_cast<std::int32_t>((2 * lowest_m - highest_m) / step_m)};
    stream.high = {side, side, static_cast<std::int32_t>(highest_m / step_m)};
    stream.points = static_cast<std::uint64_t>(tiles) * static_cast<std::uint64_t>(tiles) * tile_points;
    stream.encoding = 17;  // WKT, adjusted standard GPS time
    stream.within = [&](const std::array<std::int32_t, 3>& low, const std::array<std::int32_t, 3>& high) {
      return records_within(tiles, low, high);
    };
    io::copc::BuildOptions options;
    if (argc > 3) options.memory_bytes = static_cast<std::size_t>(std::atof(argv[3])) << 20;
    const std::filesystem::path out = argv[1];
    const auto start = std::chrono::steady_clock::now();
    const auto built = io::copc::build_copc(out, stream, std::filesystem::absolute(out).parent_path(), options);
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    fmt::print(
        "{} points, {} nodes in {} levels, hierarchy {} bytes, file {:.2f} GB\n"
        "{:.0f} s, processor time {} s, at most {} MiB of memory\n",
        built.points, built.nodes, built.levels, built.hierarchy_bytes, 1e-9 * std::filesystem::file_size(out),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
        used.ru_utime.tv_sec + used.ru_stime.tv_sec, used.ru_maxrss / 1024);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
