// PTX from memory.
#include "fuzz_cloud.h"
#include "io/core/clouds/ptx_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "two_cells",
             "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 2 3 0.5\n0 0 0 0.5\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::io::looks_like_ptx({data, size});
  return bole::fuzz::read_as_cloud(bole::io::read_ptx, data, size);
}
