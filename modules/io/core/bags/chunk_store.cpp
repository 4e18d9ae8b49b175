#include "io/core/bags/chunk_store.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>

#include "base/error.h"
#include "base/file_pages.h"

namespace bole::io {
namespace {

constexpr std::size_t kept_chunks = 4, kept_bytes = std::size_t{256} << 20;  // and the newest
constexpr std::uint64_t max_chunk_bytes = std::uint64_t{1} << 30;
constexpr std::size_t step_bytes = std::size_t{1} << 18;

// Room for the next piece of output: the vector grows by halves, and never beyond the limit.
std::size_t make_room(std::vector<std::uint8_t>& out, std::size_t used, std::uint64_t max_bytes) {
  if (used == out.size())
    out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(max_bytes, used + std::max(step_bytes, used / 2))));
  return out.size() - used;
}

Decompressed decompress_bz2(Bytes stored, std::uint64_t max_bytes) {
  Decompressed out;
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return out;
  std::size_t used = 0, taken = 0;
  int status = BZ_OK;
  while (status == BZ_OK) {
    const std::size_t room = make_room(out.bytes, used, max_bytes);
    const std::size_t input = std::min<std::size_t>(stored.size() - taken, step_bytes);
    stream.next_in = reinterpret_cast<char*>(const_cast<std::uint8_t*>(stored.data() + taken));
    stream.avail_in = static_cast<unsigned>(input);
    stream.next_out = reinterpret_cast<char*>(out.bytes.data() + used);
    stream.avail_out = static_cast<unsigned>(std::min(room, step_bytes));
    const unsigned offered = stream.avail_out;
    status = BZ2_bzDecompress(&stream);
    taken += input - stream.avail_in;
    used += offered - stream.avail_out;
    if (status == BZ_OK && input == stream.avail_in && offered == stream.avail_out) break;  // cut off, or full
  }
  out.whole = status == BZ_STREAM_END;
  BZ2_bzDecompressEnd(&stream);
  out.bytes.resize(used);
  return out;
}

Decompressed decompress_lz4(Bytes stored, std::uint64_t max_bytes) {
  Decompressed out;
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) return out;
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> owner(context, LZ4F_freeDecompressionContext);
  std::size_t used = 0, taken = 0;
  while (taken < stored.size()) {
    std::size_t room = make_room(out.bytes, used, max_bytes);
    std::size_t input = stored.size() - taken;
    const auto left = LZ4F_decompress(context, out.bytes.data() + used, &room, stored.data() + taken, &input, nullptr);
    if (LZ4F_isError(left)) break;
    taken += input;
    used += room;
    out.whole = left == 0;
    if (room == 0 && input == 0) break;  // full
  }
  out.bytes.resize(used);
  return out;
}

Decompressed decompress_zstd(Bytes stored, std::uint64_t max_bytes) {
  Decompressed out;
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, 27);
  std::size_t used = 0;
  ZSTD_inBuffer in{stored.data(), stored.size(), 0};
  while (in.pos < in.size) {
    const std::size_t room = make_room(out.bytes, used, max_bytes), before = in.pos;
    ZSTD_outBuffer piece{out.bytes.data() + used, room, 0};
    const auto left = ZSTD_decompressStream(context.get(), &piece, &in);
    if (ZSTD_isError(left)) break;
    used += piece.pos;
    out.whole = left == 0;
    if (piece.pos == 0 && in.pos == before) break;  // full
  }
  // What the decoder still holds after the last byte of input.
  while (!out.whole && in.pos == in.size) {
    const std::size_t room = make_room(out.bytes, used, max_bytes);
    ZSTD_outBuffer piece{out.bytes.data() + used, room, 0};
    const auto left = ZSTD_decompressStream(context.get(), &piece, &in);
    if (ZSTD_isError(left) || piece.pos == 0) break;
    used += piece.pos;
    out.whole = left == 0;
  }
  out.bytes.resize(used);
  return out;
}

}  // namespace

Compression compression_named(std::string_view name) {
  if (name.empty() || name == "none") return Compression::none;
  if (name == "bz2") return Compression::bz2;
  if (name == "lz4") return Compression::lz4;
  if (name == "zstd") return Compression::zstd;
  return Compression::unknown;
}

Decompressed decompress(Compression compression, Bytes stored, std::uint64_t max_bytes) {
  switch (compression) {
    case Compression::bz2:
      return decompress_bz2(stored, max_bytes);
    case Compression::lz4:
      return decompress_lz4(stored, max_bytes);
    case Compression::zstd:
      return decompress_zstd(stored, max_bytes);
    case Compression::none:
      return {{stored.begin(), stored.end()}, true};
    case Compression::unknown:
      break;
  }
  return {};
}

Bytes whole_message(Bytes stored, const std::string& name, std::vector<std::uint8_t>& room) {
  constexpr std::array<std::uint8_t, 4> zstd_magic{0x28, 0xB5, 0x2F, 0xFD};
  // The first byte of a CDR message is 0, so that the two cannot be taken for each other.
  if (stored.size() < zstd_magic.size() || !std::equal(zstd_magic.begin(), zstd_magic.end(), stored.begin()))
    return stored;
  auto content = decompress(Compression::zstd, stored, max_chunk_bytes);
  if (!content.whole) throw bad_input("a compressed message of '" + name + "' is damaged", "a whole zstd frame");
  room = std::move(content.bytes);
  return room;
}

std::uint32_t ChunkStore::add(Compression compression, Bytes stored, std::uint64_t size) {
  chunks_.push_back({compression, stored, size});
  return static_cast<std::uint32_t>(chunks_.size() - 1);
}

// Before a chunk is decompressed, so that the old ones are not held beside it.
void ChunkStore::make_way() const {
  std::size_t held = 0, count = 0;
  for (auto it = kept_.begin(); it != kept_.end(); ++it) {
    held += it->content.bytes.capacity();
    if (held <= kept_bytes && ++count < kept_chunks) continue;
    kept_.erase(it, kept_.end());
    return;
  }
}

Bytes ChunkStore::bytes(std::uint32_t index, bool* whole) const {
  const auto& chunk = chunks_[index];
  if (chunk.compression == Compression::none) {
    if (whole != nullptr) *whole = chunk.stored.size() == chunk.size;
    return chunk.stored;
  }
  auto found = std::ranges::find(kept_, index, &Kept::chunk);
  if (found == kept_.end()) {
    make_way();
    auto content = decompress(chunk.compression, chunk.stored, std::min(chunk.size, max_chunk_bytes));
    content.whole = content.bytes.size() == chunk.size;
    leave_memory(chunk.stored.data(), chunk.stored.size());
    kept_.push_front({index, std::move(content)});
  } else {
    kept_.splice(kept_.begin(), kept_, found);
  }
  if (whole != nullptr) *whole = kept_.front().content.whole;
  return kept_.front().content.bytes;
}

}  // namespace bole::io
