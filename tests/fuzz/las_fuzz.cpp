// LAS and LAZ from memory.
#include "fuzz_target.h"
#include "io/core/las/las_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  for (const auto& file : std::filesystem::directory_iterator(BOLE_SOURCE_DIR "/tests/data/laz"))
    if (file.path().extension() == ".laz")
      std::filesystem::copy_file(file.path(), folder / file.path().filename(),
                                 std::filesystem::copy_options::overwrite_existing);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::fuzz::allow_bad_input([&] {
    bole::Report report;
    bole::io::read_las(bole::io::Bytes(data, size), {.drop_withheld = size % 2 == 0}, {}, &report, false);
  });
  return 0;
}
