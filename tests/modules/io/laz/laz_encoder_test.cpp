// Chunks come back byte for byte, whatever is in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "io/core/las/las_info.h"
#include "modules/io/laz/records.h"

namespace bole::io {
namespace {

using namespace testing_io;

constexpr std::array formats{0, 1, 2, 3, 6, 7, 8};

void expect_back(const Records& records, const std::string& what) {
  const auto packing = laz::make_packing(records.format, records.length, 50'000);
  // What the record of the file says of the packing is what was meant.
  const auto said = laz::parse_packing(laz::packing_record(packing), static_cast<int>(records.length));
  ASSERT_EQ(said.items.size(), packing.items.size());
  const auto chunk = laz::encode_chunk(packing, records.bytes.data(), records.length, records.count());
  EXPECT_TRUE(decoded(said, records, chunk) == records.bytes)
      << what << ", format " << records.format << ", " << records.count() << " points of " << records.length
      << " bytes";
}

TEST(LazEncoder, AnyRecordComesBack) {
  for (const int format : formats)
    for (const std::size_t extra : {0U, 1U, 23U})
      for (const std::size_t count : {1U, 2U, 3U, 700U}) {
        const auto seed = static_cast<unsigned>(count + extra);
        expect_back(noise(format, extra, count, seed), "noise");
        expect_back(constant(format, extra, count, seed), "the same point");
        expect_back(walk(format, extra, count, seed), "a walk");
      }
}

TEST(LazEncoder, LongWalkComesBack) {
  for (const int format : formats) expect_back(walk(format, 4, 20'000, 3), "a long walk");
}

// One field after the other changes, all else stays: every layer by itself.
TEST(LazEncoder, EveryFieldByItselfComesBack) {
  for (const int format : formats)
    for (std::size_t k = 0; k < static_cast<std::size_t>(las::point_layout(format).size) + 2; ++k) {
      auto records = constant(format, 2, 300, 11);
      for (std::size_t i = 0; i < records.count(); ++i)
        records[i][k] = static_cast<std::uint8_t>(i % 7 < 3 ? i * i : records[i][k]);
      expect_back(records, "only byte " + std::to_string(k) + " changes");
    }
}

TEST(LazEncoder, ReturnsChannelsAndFlagsInAllCombinations) {
  for (const int format : {6, 7, 8}) {
    auto records = constant(format, 3, 256 * 8, 5);
    std::mt19937 random(1);
    for (std::size_t i = 0; i < records.count(); ++i) {
      records[i][las::field::returns] = static_cast<std::uint8_t>(i);                 // up to 15 of 15, also 9 of 2
      records[i][las::field::extended::flags] = static_cast<std::uint8_t>(random());  // scanner channels 0 to 3
      if (format > 6) records[i][30] = static_cast<std::uint8_t>(random());
      records[i][records.length - 1] = static_cast<std::uint8_t>(random());
    }
    expect_back(records, "returns and channels");
  }
}

TEST(LazEncoder, CoordinatesLeapOverTheWholeRange) {
  constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                         high = std::numeric_limits<std::int32_t>::max();
  constexpr std::array ends{low, high, 0, -1, 1, low + 1, high - 1, 1 << 30, -(1 << 30)};
  for (const int format : formats) {
    auto records = constant(format, 0, ends.size() * ends.size(), 2);
    for (std::size_t i = 0; i < records.count(); ++i) {
      las::store(records[i], ends[i % ends.size()]);
      las::store(records[i] + 4, ends[i / ends.size()]);
      las::store(records[i] + 8, ends[(i * 5) % ends.size()]);
    }
    expect_back(records, "leaps");
  }
}

TEST(LazEncoder, TimesOfAnyBitPattern) {
  for (const int format : {1, 3, 6, 8}) {
    auto records = constant(format, 0, 6000, 2);
    const auto at = static_cast<std::size_t>(las::point_layout(format).time);
    std::mt19937_64 random(9);
    std::array<std::uint64_t, 6> clocks{
        0, std::uint64_t{1} << 63, ~std::uint64_t{0}, 1234567890123, std::uint64_t{7} << 40, 5};
    for (std::size_t i = 0; i < records.count(); ++i) {
      auto& clock = clocks[(i / 3) % (i < 3000 ? 3 : 6)];
      constexpr std::array<std::uint64_t, 8> steps{
          0, 1000, 1000, 1000, 2000, 600'000, ~std::uint64_t{3000}, std::uint64_t{1} << 31};
      clock += i % 50 == 49 ? random() : steps[random() % steps.size()];
      las::store(records[i] + at, clock);
    }
    expect_back(records, "times");
  }
}

// The records that another encoder (lazrs) packed into the fixtures of the decoder, packed by ours: the same, and no
// larger by more than 2 %.
TEST(LazEncoder, NoLargerThanAnotherEncoder) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BOLE_SOURCE_DIR "/tests/data/laz")) {
    const auto name = entry.path().filename().string();
    if (entry.path().extension() != ".laz" || name.find("old") != std::string::npos) continue;
    const MappedFile file(entry.path());
    const LasInfo info = las::parse_info(file.bytes());
    if (std::ranges::find(formats, info.point_format) == formats.end()) continue;
    const auto theirs = laz::parse_packing(las::vlr_data(file.bytes(), *las::find_vlr(info, "laszip encoded", 22204)),
                                           info.record_length);
    const auto ours = laz::make_packing(info.point_format, static_cast<std::size_t>(info.record_length), 50'000);
    std::size_t their_bytes = 0, our_bytes = 0;
    const auto table = laz::read_chunk_table(file.bytes(), info.data_offset, info.points, theirs, info.record_length);
    ASSERT_TRUE(table);
    for (const auto& chunk : *table) {
      laz::ChunkDecoder decoder(theirs, info.record_length);
      const auto bytes = file.bytes().subspan(chunk.begin, chunk.end - chunk.begin);
      Records records{info.point_format, static_cast<std::size_t>(info.record_length), {}};
      records.bytes.resize(chunk.points * records.length);
      decoder.start(bytes, chunk.points);
      ASSERT_EQ(decoder.decode(records.bytes.data(), chunk.points), chunk.points);
      const auto packed = laz::encode_chunk(ours, records.bytes.data(), records.length, records.count());
      EXPECT_TRUE(decoded(ours, records, packed) == records.bytes) << name;
      their_bytes += bytes.size();
      our_bytes += packed.size();
    }
    EXPECT_LE(static_cast<double>(our_bytes), 1.02 * static_cast<double>(their_bytes)) << name;
    ++files;
  }
  EXPECT_GE(files, 9U);
}

TEST(LazEncoder, ChunkTableComesBack) {
  for (const std::uint32_t size : {50'000U, laz::variable_chunks}) {
    const auto packing = laz::make_packing(6, 30, size);
    std::vector<laz::Chunk> chunks;
    std::uint64_t at = 8, points = 0;
    for (const std::uint64_t n : {50'000U, 50'000U, 50'000U, 7U}) {
      const std::uint64_t bytes = 40 * n + 77;
      chunks.push_back({at, at + bytes, n});
      at += bytes;
      points += n;
    }
    std::vector<std::uint8_t> file(at);
    las::store(file.data(), at);
    const auto table = laz::encode_chunk_table(packing, chunks);
    file.insert(file.end(), table.begin(), table.end());
    const auto back = laz::read_chunk_table(file, 0, points, packing, 30);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->size(), chunks.size());
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      EXPECT_EQ((*back)[i].begin, chunks[i].begin);
      EXPECT_EQ((*back)[i].end, chunks[i].end);
      EXPECT_EQ((*back)[i].points, chunks[i].points);
    }
  }
}

TEST(LazEncoder, FormatsWithWaveformsAreRefused) {
  for (const int format : {4, 5, 9, 10, 11, -1}) EXPECT_THROW(laz::make_packing(format, 100, 50'000), Error);
  EXPECT_THROW(laz::make_packing(7, 35, 50'000), Error);
}

}  // namespace
}  // namespace bole::io
