// Points as text: XYZ, CSV and PTS.
#include "fuzz_cloud.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/text_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}}, {400000, 5000000, 0});
  cloud.set_column(arrays::intensity, std::vector<float>{1, 2});
  io::write_xyz_cloud(folder / "xyz", cloud);
  write_seed(folder, "csv", "\"x\";y;z;treeID\n1,5;2;3;7\n");
  write_seed(folder, "pts", "2\n1 2 3 -100 1 2 3\n4 5 6 7 8 9 10\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::io::holds_text_points({data, size});
  return bole::fuzz::read_as_cloud(bole::io::read_text_cloud, data, size);
}
