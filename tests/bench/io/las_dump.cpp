// las_dump IN OUT.json [COPY.las]: reads a LAS or LAZ file and writes what was read for las_against_laspy.py: every
// column as a raw binary file beside OUT.json, exact coordinates as x, y, z. With COPY the cloud is also written as
// LAS (or LAZ or COPC, as its ending says). las_dump --time IN: seconds of the fastest of three readings.
// las_dump --pack IN.las OUT.laz: the very records of a LAS file as LAZ; prints the seconds of the fastest of three
// compressions, in memory, with all threads.
// las_dump --cloud IN OUT.json [BOUNDS [RESOLUTION]]: a cloud of any format, for clouds_against_peers.py.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/las/las_header.h"
#include "io/core/las/las_reader.h"
#include "io/core/laz/laz_chunk_encoder.h"

namespace {

template <class T>
void write_raw(const std::string& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void dump(const bole::PointCloud& cloud, const bole::Report& report, const std::string& out) {
  nlohmann::json columns;
  for (const auto& [name, column] : cloud.columns()) {
    std::visit([&, n = name](const auto& values) { write_raw(out + "." + n, values); }, *column);
    columns[name] = bole::array_type_name(bole::column_type(*column));
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) values[i] = bole::exact_position(cloud, i)[axis];
    const std::string name(1, "xyz"[axis]);
    write_raw(out + "." + name, values);
    columns[name] = "float64";
  }
  std::ofstream(out) << nlohmann::json{
      {"points", cloud.size()}, {"columns", columns}, {"crs", cloud.crs_wkt}, {"warnings", report.warnings}};
}

double seconds_of_best(const std::string& path) {
  double best = 1e30;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto cloud = bole::io::read_las(path);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

// As a program that knows nothing but records would write it: header and records of the file, and the one of LAZ.
void pack(const std::string& in, const std::string& out) {
  using namespace bole::io;
  const MappedFile mapped(in);
  const Bytes file = mapped.bytes();
  const LasInfo info = las::parse_info(file, false);
  const auto length = static_cast<std::size_t>(info.record_length);
  const std::uint8_t* const records = file.data() + info.data_offset;
  constexpr std::size_t chunk_points = 50'000;
  const auto packing = laz::make_packing(info.point_format, length, chunk_points);
  std::vector<std::vector<std::uint8_t>> chunks((info.points + chunk_points - 1) / chunk_points);
  double best = 1e30;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
      const std::size_t first = c * chunk_points;
      chunks[c] = laz::encode_chunk(packing, records + first * length, length,
                                    std::min<std::size_t>(chunk_points, info.points - first));
    });
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  las::VlrList vlr;
  vlr.add("laszip encoded", 22204, laz::packing_record(packing), "LAZ");
  std::vector<std::uint8_t> head(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(info.data_offset));
  head.insert(head.end(), vlr.bytes().begin(), vlr.bytes().end());
  las::store(&head[96], static_cast<std::uint32_t>(head.size()));
  las::store(&head[100], las::load<std::uint32_t>(&head[100]) + 1);
  head[104] |= 0x80;
  std::vector<laz::Chunk> places;
  std::uint64_t at = head.size() + 8;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    places.push_back({at, at + chunks[c].size(), std::min<std::size_t>(chunk_points, info.points - c * chunk_points)});
    at = places.back().end;
  }
  std::ofstream stream(out, std::ios::binary);
  const auto put = [&](Bytes bytes) {
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  put(head);
  put({reinterpret_cast<const std::uint8_t*>(&at), sizeof at});
  for (const auto& chunk : chunks) put(chunk);
  put(laz::encode_chunk_table(packing, places));
  std::printf("%.6f\n", best);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> args(argv + 1, argv + argc);
    if (args.size() == 2 && args[0] == "--time") {
      std::printf("%.6f\n", seconds_of_best(args[1]));
      return 0;
    }
    if (args.size() == 3 && args[0] == "--pack") {
      pack(args[1], args[2]);
      return 0;
    }
    if (args.size() < 2) return 2;
    if (args[0] == "--cloud" && args.size() >= 3) {
      bole::io::CloudReadOptions options;
      if (args.size() > 3) options.bounds = args[3];
      if (args.size() > 4) options.resolution = std::stod(args[4]);
      const auto reading = bole::io::read_cloud(args[1], options);
      dump(reading.cloud, reading.report, args[2]);
      return 0;
    }
    bole::Report report;
    const auto cloud = bole::io::read_las(args[0], {}, {}, &report);
    dump(cloud, report, args[1]);
    if (args.size() > 2) bole::io::write_cloud(args[2], cloud);
    return 0;
  } catch (const bole::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
