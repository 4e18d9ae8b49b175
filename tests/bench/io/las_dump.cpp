// las_dump IN OUT.json [COPY.las]: reads a LAS or LAZ file and writes what was read for las_against_laspy.py: every
// column as a raw binary file beside OUT.json, exact coordinates as x, y, z. With COPY the cloud is also written as
// LAS. las_dump --time IN: seconds of the fastest of three readings.
// las_dump --cloud IN OUT.json [BOUNDS [RESOLUTION]]: a cloud of any format, for clouds_against_peers.py.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/las/las_reader.h"
#include "io/core/las/las_writer.h"

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

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> args(argv + 1, argv + argc);
    if (args.size() == 2 && args[0] == "--time") {
      std::printf("%.6f\n", seconds_of_best(args[1]));
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
    if (args.size() > 2) bole::io::write_las(args[2], cloud);
    return 0;
  } catch (const bole::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
