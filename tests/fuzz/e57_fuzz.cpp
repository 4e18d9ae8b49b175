// E57 from memory. Every second input gets right checksums, so that what lies behind them is reached.
#include "../modules/io/e57_file.h"
#include "fuzz_cloud.h"
#include "io/core/e57/e57_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  test::E57File file;
  file.scans = {test::ring_scan(60, test::pose_xml(1, 2, 3)), test::ring_scan(20, test::pose_xml(9, 2, 3))};
  file.records_per_packet = 13;
  const auto bytes = file.bytes();
  write_seed(folder, "two_scans", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  file.scans = {{{{"sphericalRange", 64}, {"sphericalAzimuth", 32}, {"sphericalElevation", 12, -2000, 0.0007}},
                 {{10, 1, 0.2}, {11, 2, -0.3}},
                 ""}};
  const auto angles = file.bytes();
  write_seed(folder, "spherical", {reinterpret_cast<const char*>(angles.data()), angles.size()});
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> file(data, data + size);
  if (size > 60 && file[50] % 2 == 0) bole::test::E57File::seal(file);
  return bole::fuzz::read_as_cloud(bole::io::read_e57, file.data(), file.size());
}
