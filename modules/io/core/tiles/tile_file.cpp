#include "io/core/tiles/tile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_header.h"
#include "io/core/laz/laz_chunk_encoder.h"

namespace bole::io::las {
namespace {

constexpr std::uint8_t compressed_bit = 0x80;
constexpr std::size_t block_bytes = std::size_t{4} << 20;

// Coordinate system and extra bytes as they are, the facts anew.
VlrList records_for(Bytes source, const LasInfo& info, const Facts& facts) {
  VlrList vlrs;
  for (const auto& vlr : info.vlrs)
    if (vlr.length <= max_vlr_bytes &&
        (vlr.user_id == "LASF_Projection" || (vlr.user_id == "LASF_Spec" && vlr.record_id == 4)))
      vlrs.add(vlr.user_id, vlr.record_id, vlr_data(source, vlr), vlr.description);
  const std::string text = facts_to_json(facts);
  vlrs.add(facts_user, facts_record, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
           "facts of the cloud (JSON)");
  return vlrs;
}

std::vector<std::uint8_t> header_for(Bytes source, const LasInfo& info, const VlrList& vlrs, const TileStatistics& s,
                                     bool packed) {
  const std::size_t size = load<std::uint16_t>(&source[94]);
  std::vector<std::uint8_t> h(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(size));
  store(&h[96], static_cast<std::uint32_t>(size + vlrs.bytes().size()));
  store(&h[100], vlrs.count());
  h[104] = static_cast<std::uint8_t>(info.point_format | (packed ? compressed_bit : 0));
  const bool legacy_counts = info.point_format <= 5 && s.points <= 0xffffffffULL;
  store(&h[107], static_cast<std::uint32_t>(legacy_counts ? s.points : 0));
  for (std::size_t i = 0; i < 5; ++i)
    store(&h[111 + 4 * i], static_cast<std::uint32_t>(legacy_counts ? s.by_return[i] : 0));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    store(&h[179 + 16 * k], s.box.max[k] * info.scale[axis] + info.offset[axis]);
    store(&h[187 + 16 * k], s.box.min[k] * info.scale[axis] + info.offset[axis]);
  }
  if (size >= 235) store(&h[227], std::uint64_t{0});  // waveforms stay behind
  if (size >= 375) {
    store(&h[235], std::uint64_t{0});
    store(&h[243], std::uint32_t{0});
    store(&h[247], s.points);
    for (std::size_t i = 0; i < 15; ++i) store(&h[255 + 8 * i], s.by_return[i]);
  }
  return h;
}

class TileWriter {
 public:
  TileWriter(const std::filesystem::path& path, const TileParts& parts, const Run& run)
      : out_(path), parts_(parts), run_(run) {}

  void put(Bytes bytes) {
    out_.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    at_ += bytes.size();
  }

  void put_parts() {
    std::ifstream in(parts_.path(), std::ios::binary);
    const std::uint64_t begin = at_;
    std::vector<std::uint8_t> block(block_bytes);
    for (std::size_t read = block.size(); read == block.size();) {
      run_.check_cancel();
      in.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(block.size()));
      read = static_cast<std::size_t>(in.gcount());
      put({block.data(), read});
    }
    if (at_ - begin != parts_.bytes())
      throw failure(
          fmt::format("'{}' cannot be read again: {} of {} bytes", parts_.path().string(), at_ - begin, parts_.bytes()),
          "the points of the tile", "Look at the disk, and cut the cloud again");
  }

  void put_packed(const laz::Packing& packing) {
    const std::uint64_t begin = at_;
    put_number(0);  // of the chunk table, once its place is known
    std::vector<laz::Chunk> chunks = parts_.chunks();
    for (auto& chunk : chunks) chunk.begin += at_, chunk.end += at_;
    put_parts();
    const std::uint64_t table_at = at_;
    put(laz::encode_chunk_table(packing, chunks));
    out_.stream().seekp(static_cast<std::streamoff>(begin));
    put_number(table_at);
  }

  void commit() { out_.commit(); }

 private:
  void put_number(std::uint64_t number) {
    std::uint8_t bytes[sizeof number];
    store(bytes, number);
    put(bytes);
  }

  AtomicFile out_;
  const TileParts& parts_;
  const Run& run_;
  std::uint64_t at_ = 0;
};

}  // namespace

void TileStatistics::add(const std::uint8_t* record, bool extended) {
  ++points;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto v = load<std::int32_t>(record + 4 * k);
    box.min[k] = std::min(box.min[k], v);
    box.max[k] = std::max(box.max[k], v);
  }
  const unsigned r = record[field::returns] & (extended ? 15U : 7U);
  if (r >= 1 && r <= by_return.size()) ++by_return[r - 1];
}

void write_tile_file(const std::filesystem::path& path, const TileParts& parts, Bytes source, const LasInfo& info,
                     const TileStatistics& statistics, const Facts& facts, const Run& run) {
  const bool packed = can_be_packed(info.point_format);
  VlrList vlrs = records_for(source, info, facts);
  laz::Packing packing;
  if (packed) {
    packing = packing_of_parts(info);
    vlrs.add("laszip encoded", 22204, laz::packing_record(packing), "LAZ");
  }
  TileWriter writer(path, parts, run);
  writer.put(header_for(source, info, vlrs, statistics, packed));
  writer.put(vlrs.bytes());
  packed ? writer.put_packed(packing) : writer.put_parts();
  writer.commit();
}

}  // namespace bole::io::las
