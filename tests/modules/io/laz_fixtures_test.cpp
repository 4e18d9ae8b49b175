// The decoder against fixtures whose uncompressed records are known by hash (tests/data/laz/make_fixtures.py).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/core/bytes/mapped_file.h"
#include "io/core/las/las_reader.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io {
namespace {

const std::string folder = std::string(BOLE_SOURCE_DIR) + "/tests/data/laz/";

struct Expected {
  std::string file;
  int point_format = 0;
  std::size_t points = 0, record_length = 0;
  std::uint64_t fnv1a = 0;
};

void PrintTo(const Expected& e, std::ostream* out) { *out << e.file; }

std::vector<Expected> all_expected() {
  std::vector<Expected> out;
  std::ifstream in(folder + "expected.csv");
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream row(line);
    Expected e;
    row >> e.file >> e.point_format >> e.points >> e.record_length >> std::hex >> e.fnv1a;
    out.push_back(e);
  }
  return out;
}

std::uint64_t fnv1a(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (const auto b : bytes) value = (value ^ b) * 0x100000001b3;
  return value;
}

// All records, chunk by chunk.
std::vector<std::uint8_t> unpacked_records(Bytes file, const LasInfo& info) {
  const auto packing =
      laz::parse_packing(las::vlr_data(file, *las::find_vlr(info, "laszip encoded", 22204)), info.record_length);
  const auto table = laz::read_chunk_table(file, info.data_offset, info.points, packing, info.record_length);
  if (!table) return {};
  std::vector<std::uint8_t> out;
  laz::ChunkDecoder decoder(packing, info.record_length);
  for (const auto& chunk : *table) {
    const std::size_t at = out.size();
    EXPECT_EQ(decoder.start(file.subspan(chunk.begin, chunk.end - chunk.begin), chunk.points), chunk.points);
    out.resize(at + chunk.points * static_cast<std::size_t>(info.record_length));
    EXPECT_EQ(decoder.decode(out.data() + at, chunk.points), chunk.points);
    EXPECT_EQ(decoder.length(), chunk.end - chunk.begin);
  }
  return out;
}

// The same file without compression, in memory.
std::vector<std::uint8_t> uncompressed(Bytes file, const LasInfo& info) {
  std::vector<std::uint8_t> out(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(info.data_offset));
  out[104] &= 0x7f;
  const auto records = unpacked_records(file, info);
  out.insert(out.end(), records.begin(), records.end());
  return out;
}

void expect_equal(const PointCloud& a, const PointCloud& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.positions(), b.positions());
  ASSERT_EQ(a.columns().size(), b.columns().size());
  for (const auto& [name, column] : a.columns()) EXPECT_EQ(*column, b.column(name)) << name;
}

class LazFixture : public testing::TestWithParam<Expected> {};

TEST_P(LazFixture, DecodesToTheVeryBytes) {
  const MappedFile file(folder + GetParam().file);
  const LasInfo info = las::parse_info(file.bytes());
  EXPECT_TRUE(info.compressed);
  EXPECT_EQ(info.point_format, GetParam().point_format);
  EXPECT_EQ(info.points, GetParam().points);
  EXPECT_EQ(info.record_length, static_cast<int>(GetParam().record_length));
  EXPECT_EQ(fnv1a(unpacked_records(file.bytes(), info)), GetParam().fnv1a);
}

TEST_P(LazFixture, ReadsAsItsUncompressedTwin) {
  const MappedFile file(folder + GetParam().file);
  const auto twin = uncompressed(file.bytes(), las::parse_info(file.bytes()));
  Report report;
  const PointCloud cloud = read_las(folder + GetParam().file, {}, {}, &report);
  EXPECT_EQ(cloud.size(), GetParam().points);
  expect_equal(cloud, read_las(twin));
  for (const auto& text : report.warnings) EXPECT_THAT(text, testing::HasSubstr("withheld"));
}

// Without its chunk table a file is read chunk after chunk; only pointwise chunks of varying size cannot be told apart
// then.
TEST_P(LazFixture, ReadsWithoutItsChunkTable) {
  const MappedFile file(folder + GetParam().file);
  std::vector<std::uint8_t> broken(file.bytes().begin(), file.bytes().end());
  const LasInfo info = las::parse_info(broken);
  las::store(&broken[info.data_offset], std::uint64_t{7});
  Report report;
  const PointCloud cloud = read_las(broken, {}, {}, &report);
  expect_equal(cloud, read_las(file.bytes()));
  EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("no usable chunk table")));
}

// However short a file is cut, what can be read is what the whole file begins with.
TEST_P(LazFixture, CutFilesGiveWhatIsThere) {
  const MappedFile file(folder + GetParam().file);
  const LasInfo info = las::parse_info(file.bytes());
  const auto whole = unpacked_records(file.bytes(), info);
  std::size_t last = 0;
  for (std::size_t length = info.data_offset; length < file.bytes().size(); length += 97) {
    Report report;
    try {
      const PointCloud cloud = read_las(file.bytes().first(length), {.extra_bytes = false}, {}, &report, false);
      EXPECT_GE(cloud.size(), last);
      EXPECT_LE(cloud.size(), GetParam().points);
      last = cloud.size();
      for (std::size_t i = 0; i < cloud.size(); i += 13) {
        const double x =
            las::load<std::int32_t>(&whole[i * GetParam().record_length]) * info.scale.x() + info.offset.x();
        ASSERT_NEAR(exact_position(cloud, i).x(), x, 1e-6) << "point " << i << " of a file cut at " << length;
      }
      if (cloud.size() < GetParam().points) {
        EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("of 300 points read")));
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
      EXPECT_EQ(last, 0U);
    }
  }
  EXPECT_GT(last, 0U);
}

INSTANTIATE_TEST_SUITE_P(All, LazFixture, testing::ValuesIn(all_expected()),
                         [](const auto& test) { return test.param.file.substr(0, test.param.file.find('.')); });

}  // namespace
}  // namespace bole::io
