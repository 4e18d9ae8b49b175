// PLY from memory.
#include "fuzz_cloud.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/ply_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}}, {400000, 5000000, 0});
  cloud.set_column(arrays::intensity, std::vector<float>{1, 2});
  io::write_ply(folder / "binary", cloud);
  write_seed(folder, "ascii",
             "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
             "z\nproperty list uchar int f\nproperty uchar red\nend_header\n1 2 3 2 7 8 255\n4 5 6 0 1\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return bole::fuzz::read_as_cloud(bole::io::read_ply, data, size);
}
