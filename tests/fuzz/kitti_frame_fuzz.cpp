// A KITTI frame from memory.
#include "fuzz_cloud.h"
#include "io/core/clouds/kitti_frame.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "points", std::string(48, '@'));
  write_seed(folder, "cut_off", std::string("\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F\0\0", 18));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return bole::fuzz::read_as_cloud(bole::io::read_kitti_frame, data, size);
}
