#include "io/core/bags/scratch_copy.h"

#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/file_pages.h"

namespace bole::io {
namespace {

void write_all(int file, const std::uint8_t* data, std::size_t size) {
  while (size > 0) {
    const auto written = ::write(file, data, size);
    if (written <= 0)
      throw failure("the scratch file for a compressed recording cannot be written", "room on the disk");
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

}  // namespace

bool is_zstd(Bytes file) {
  return file.size() >= 4 && file[0] == 0x28 && file[1] == 0xB5 && file[2] == 0x2F && file[3] == 0xFD;
}

ScratchCopy::ScratchCopy(Bytes zstd_file, const std::string& name, const Run& run) {
  int file = -1;
  for (const auto& folder : scratch_folders(run)) {
    auto text = (folder / "bole_bag_XXXXXX").string();
    if (file = ::mkstemp(text.data()); file < 0) continue;
    path_ = text;
    break;
  }
  if (file < 0)
    throw failure("there is no folder for the content of '" + name + "'", "a folder that may be written to");
  const std::unique_ptr<int, void (*)(int*)> closing(&file, [](int* f) { ::close(*f); });
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  std::vector<std::uint8_t> block(ZSTD_DStreamOutSize());
  ZSTD_inBuffer in{zstd_file.data(), zstd_file.size(), 0};
  std::size_t left = 1, written = 0;
  try {
    while (true) {
      run.check_cancel();
      run.report(static_cast<double>(in.pos) / static_cast<double>(in.size), "decompressing " + name);
      ZSTD_outBuffer out{block.data(), block.size(), 0};
      const auto before = in.pos;
      left = ZSTD_decompressStream(context.get(), &out, &in);
      if (ZSTD_isError(left)) break;
      write_all(file, block.data(), out.pos);
      written += out.pos;
      if (in.pos == in.size && out.pos < out.size) break;
      if (in.pos == before && out.pos == 0) break;
    }
    if (written == 0) throw bad_input("'" + name + "' holds nothing that can be decompressed", "a whole zstd file");
  } catch (...) {
    ::unlink(path_.c_str());
    throw;
  }
}

ScratchCopy::~ScratchCopy() { ::unlink(path_.c_str()); }

}  // namespace bole::io
