// COPC from memory, by bounds and resolution: its octree of pages.
#include <string>

#include "fuzz_target.h"
#include "io/core/las/las_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  std::filesystem::copy_file(BOLE_SOURCE_DIR "/tests/data/copc/octree.copc.laz", folder / "octree",
                             std::filesystem::copy_options::overwrite_existing);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::fuzz::allow_bad_input([&] {
    bole::io::LasReadOptions options;
    if (size % 3 != 0) options.bounds = bole::io::parse_bounds("500004,5400004,500012,5400010");
    if (size % 2 == 0) options.resolution = 0.4;
    bole::Report report;
    bole::io::read_las(bole::io::Bytes(data, size), options, {}, &report, false);
  });
  bole::fuzz::allow_bad_input([&] {
    bole::io::parse_bounds({reinterpret_cast<const char*>(data), std::min<std::size_t>(size, 64)});
  });
  return 0;
}
