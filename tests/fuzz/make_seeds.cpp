// Writes one small valid file of each kind where the fuzzers start from.
//   make_seeds FOLDER   gives FOLDER/pcap/..., FOLDER/ply/... and so on
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "base/atomic_file.h"
#include "base/error.h"
#include "io/core/clouds/cloud_writer.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace {

using namespace bole;

void write_packets(const std::filesystem::path& folder) {
  for (const char* name : {"vlp16", "vlp32c"}) {
    const auto model = sensor::load_sensor_model(name);
    std::filesystem::create_directories(folder / "pcap");
    std::filesystem::create_directories(folder / "velodyne");
    sensor::PcapWriter writer(folder / "pcap" / name);
    sensor::VelodyneEncoder encoder(
        model, sensor::VelodyneReturnMode::dual, [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) {
          writer.write(bytes, time_s);
          write_text_file(folder / "velodyne" / name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        });
    const std::vector<sensor::LaserEcho> near(model.channels.size(), {3, 7}), far(model.channels.size(), {9, 1});
    for (int s = 0; s < 40; ++s) encoder.add(1.7e9 + s * model.sequence_period_s, 3.13 + 0.0035 * s, near, far);
    writer.close();
  }
}

void write_clouds(const std::filesystem::path& folder) {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}}, {400000, 5000000, 0});
  cloud.set_column(arrays::intensity, std::vector<float>{1, 2});
  io::write_ply(folder / "ply" / "binary", cloud);
  write_text_file(folder / "ply" / "ascii",
                  "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
                  "z\nproperty list uchar int f\nproperty uchar red\nend_header\n1 2 3 2 7 8 255\n4 5 6 0 1\n");
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT "
      "1\nPOINTS 2\nDATA ";
  write_text_file(folder / "pcd" / "ascii", header + "ascii\n1 2 3 4.2e6\n4 5 nan 0\n");
  const std::string colours =
      "VERSION .7\nFIELDS x y z rgb rgba\nSIZE 4 4 4 4 4\nTYPE F F F U I\nCOUNT 1 1 1 2 1\nWIDTH 2\nHEIGHT 1\nDATA ";
  write_text_file(folder / "pcd" / "colours", colours + "ascii\n1 2 3 66051 abc -1\n4 5 6 -1 1e30 nan\n");
  write_text_file(folder / "pcd" / "binary", header + "binary\n" + std::string(32, '@'));
  write_text_file(folder / "pcd" / "compressed",
                  header + "binary_compressed\n" + std::string("\x06\0\0\0\x20\0\0\0\0@\xE0\x14\0\0", 14));
  io::write_xyz_cloud(folder / "text" / "xyz", cloud);
  write_text_file(folder / "text" / "csv", "\"x\";y;z;treeID\n1,5;2;3;7\n");
  write_text_file(folder / "text" / "pts", "2\n1 2 3 -100 1 2 3\n4 5 6 7 8 9 10\n");
  write_text_file(folder / "text" / "ptx",
                  "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 2 3 0.5\n0 0 0 0.5\n");
}

void write_tables(const std::filesystem::path& folder) {
  write_text_file(folder / "table" / "csv", "# axes: plot\ntree_id,dbh_cm,note\n1,20.5,\"a, \"\"b\"\"\"\n2,,\n");
  write_text_file(folder / "table" / "tum", "# time x y z\n1.5 0 0 0 0 0 0 1\n2.5 1 0 0 0 0 0.707 0.707\n");
  write_text_file(folder / "table" / "kitti", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  write_text_file(folder / "track" / "nmea",
                  "$GNGGA,132819.60,4134.49795459,N,09345.03431408,W,2,10,0.9,278.161,M,-31.442,M,6.6,0133*6A\r\n"
                  "$GNRMC,132819.60,A,4134.49795459,N,09345.03431408,W,0.148,124.888,180320,11.5985,E,D*3F\r\n");
  write_text_file(folder / "track" / "columns", "80150.95 0 288334.55 4615913.838 283.908 0\n");
  write_text_file(folder / "track" / "csv", "time_s,x_m,y_m\n0,1,2\n1,2,2\n");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  try {
    write_packets(arguments[1]);
    write_clouds(arguments[1]);
    write_tables(arguments[1]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
  return 0;
}
