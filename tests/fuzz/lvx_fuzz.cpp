// An LVX or LVX2 file.
#include <algorithm>

#include "../modules/io/lvx_bytes.h"
#include "fuzz_target.h"
#include "io/core/scans/livox_lvx.h"

namespace {

namespace maker = bole::testing_lvx;

std::string file_of(bool lvx2, std::uint8_t type, const std::string& firing, int count) {
  maker::File file(lvx2, {{0, lvx2 ? 9 : 7}, {1, 3, true, 1, 2, 3, 0.1F, 0.2F, 0.3F}});
  for (std::uint64_t b = 0; b < 3; ++b)
    file.block(file.package(0, type, b * 50'000'000, maker::times(firing, count)) +
               file.package(0, lvx2 ? 0 : 6, b * 50'000'000, maker::inertial(0, 0, 0, 0, 0, 1)));
  return file.bytes();
}

}  // namespace

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  const auto point = maker::tagged(maker::cartesian(1000, 2000, 3000, 4), 0);
  write_seed(folder, "single", file_of(false, 2, point, 96));
  write_seed(folder, "dual", file_of(false, 4, point + point, 48));
  write_seed(folder, "sphere", file_of(false, 3, "1234567890", 96));
  write_seed(folder, "second", file_of(true, 1, point, 20));
  write_seed(folder, "low", file_of(true, 2, "12345678", 20));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::fuzz::allow_bad_input([&] {
    bole::io::FrameSourceOptions options;
    options.keep_partial_frames = size % 2 == 0;
    const bole::io::LvxSource source(bole::io::Bytes(data, size), "fuzz", options, {});
    bole::ScanFrame frame;
    for (std::size_t i = 0; i < std::min<std::size_t>(source.size(), 8); ++i) source.read(i, frame);
  });
  return 0;
}
