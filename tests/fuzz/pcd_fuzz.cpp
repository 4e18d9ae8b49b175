// PCD from memory.
#include "fuzz_cloud.h"
#include "io/core/clouds/pcd_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT "
      "1\nPOINTS 2\nDATA ";
  write_seed(folder, "ascii", header + "ascii\n1 2 3 4.2e6\n4 5 nan 0\n");
  const std::string colours =
      "VERSION .7\nFIELDS x y z rgb rgba\nSIZE 4 4 4 4 4\nTYPE F F F U I\nCOUNT 1 1 1 2 1\nWIDTH 2\nHEIGHT 1\nDATA ";
  write_seed(folder, "colours", colours + "ascii\n1 2 3 66051 abc -1\n4 5 6 -1 1e30 nan\n");
  write_seed(folder, "binary", header + "binary\n" + std::string(32, '@'));
  write_seed(folder, "compressed",
             header + "binary_compressed\n" + std::string("\x06\0\0\0\x20\0\0\0\0@\xE0\x14\0\0", 14));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return bole::fuzz::read_as_cloud(bole::io::read_pcd, data, size);
}
