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

// A small file may hold a very large one: the disk keeps some room for others.
void keep_room(const std::filesystem::path& path, const std::string& name, std::uint64_t written) {
  constexpr std::uintmax_t kept_bytes = std::uintmax_t{512} << 20;
  std::error_code failed;
  const auto space = std::filesystem::space(path.parent_path(), failed);
  if (!failed && space.available < kept_bytes)
    throw failure("the content of '" + name + "' has more than " + std::to_string(written >> 20) +
                      " MB, and the disk of '" + path.parent_path().string() + "' has " +
                      std::to_string(space.available >> 20) + " MB left",
                  "room on the disk for the whole content, and " + std::to_string(kept_bytes >> 20) + " MB more");
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
  constexpr std::uint64_t room_step_bytes = std::uint64_t{64} << 20;
  std::size_t left = 1;
  std::uint64_t written = 0, next_look = 0;
  try {
    while (true) {
      run.check_cancel();
      run.report(static_cast<double>(in.pos) / static_cast<double>(in.size), "decompressing " + name);
      ZSTD_outBuffer out{block.data(), block.size(), 0};
      const auto before = in.pos;
      left = ZSTD_decompressStream(context.get(), &out, &in);
      if (ZSTD_isError(left)) break;
      if (written >= next_look) {
        keep_room(path_, name, written);
        next_look = written + room_step_bytes;
      }
      write_all(file, block.data(), out.pos);
      written += out.pos;
      if (in.pos == in.size && out.pos < out.size) break;
      if (in.pos == before && out.pos == 0) break;
    }
    if (written == 0) throw bad_input("'" + name + "' holds nothing that can be decompressed", "a whole zstd file");
    judge(zstd_file, left == 0 && in.pos == in.size, written);
  } catch (...) {
    ::unlink(path_.c_str());
    throw;
  }
}

void ScratchCopy::judge(Bytes zstd_file, bool whole, std::uint64_t written) {
  if (whole) return;
  damage_ = "the compressed file is cut off or damaged: what comes before is read";
  const auto declared = ZSTD_getFrameContentSize(zstd_file.data(), zstd_file.size());
  if (declared == ZSTD_CONTENTSIZE_UNKNOWN || declared == ZSTD_CONTENTSIZE_ERROR || declared <= written) {
    damage_ += ". It does not say how much is missing";
    return;
  }
  lost_share_ = 1 - static_cast<double>(written) / static_cast<double>(declared);
}

ScratchCopy::~ScratchCopy() { ::unlink(path_.c_str()); }

}  // namespace bole::io
