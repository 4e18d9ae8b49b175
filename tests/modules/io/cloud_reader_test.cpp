#include "io/core/clouds/cloud_reader.h"

#include <gmock/gmock.h>

#include <Eigen/LU>

#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/verdict.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/pcd_reader.h"
#include "io/core/clouds/sensor_arrays.h"
#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

CloudReading read(const std::string& text, const std::string& name, const CloudReadOptions& options = {}) {
  return read_cloud(bytes_of(text), name, options);
}

TEST(ReadPly, AsciiWithListsAndOtherElementsBefore) {
  const auto r = read(
      "ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nelement vertex "
      "2\r\nproperty float x\r\nproperty list uchar float weights\r\nproperty float y\r\nproperty float z\r\n"
      "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\nproperty float "
      "scalar_Intensity\r\nend_header\r\n3 0 1 2\r\n1 2 9 9 2 3 255 0 128 7.5\r\n4 0 5 6 1 2 3 8\r\n",
      "a.ply");
  ASSERT_EQ(r.cloud.size(), 2U);
  EXPECT_EQ(r.cloud.position(0), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(r.cloud.values<std::uint16_t>("red")[0], 65535);
  EXPECT_EQ(r.cloud.values<std::uint16_t>("blue")[0], 128 * 257);
  EXPECT_EQ(r.cloud.values<float>("intensity")[1], 8);
}

std::string binary_ply(bool big_endian, double x, std::size_t declared) {
  std::string file = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\nelement vertex " + std::to_string(declared) +
                     "\nproperty double x\nproperty double y\nproperty double z\nproperty int GpsTime\nend_header\n";
  const auto append = [&](auto value) {
    std::string bytes;
    put(bytes, value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    file += bytes;
  };
  for (int i = 0; i < 3; ++i) {
    append(x + i * 0.001);
    append(5400000.25);
    append(100.5);
    append(i);
  }
  return file;
}

TEST(ReadPly, BothEndiansKeepLargeCoordinates) {
  for (const bool big : {false, true}) {
    const auto r = read(binary_ply(big, 450000.123, 3), "a.ply");
    ASSERT_EQ(r.cloud.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(r.cloud.position(i).x(), 450000.123 + 0.001 * static_cast<double>(i), 1e-5);
    EXPECT_NEAR(r.cloud.position(0).y(), 5400000.25, 1e-5);
    EXPECT_EQ(r.cloud.values<double>("time")[2], 2);
    EXPECT_TRUE(r.report.warnings.empty());
  }
}

TEST(ReadPly, HostileCountsAllocateNothing) {
  const auto r = read(binary_ply(false, 1, 4'000'000'000'000ULL), "a.ply");
  EXPECT_EQ(r.cloud.size(), 3U);
  ASSERT_EQ(r.report.warnings.size(), 1U);
  EXPECT_THAT(r.report.warnings[0], HasSubstr("4000000000000 points, 3 are present"));
}

TEST(ReadPly, ErrorsNameTheLine) {
  EXPECT_THAT(error_of([] { read("ply\nformat ascii 1.0\nelement vertex many\n", "a.ply"); }), HasSubstr("line 3"));
  EXPECT_THAT(error_of([] { read("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "a.ply"); }),
              HasSubstr("type 'quad'"));
  EXPECT_THAT(error_of([] { read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n", "a.ply"); }),
              HasSubstr("does not end"));
  EXPECT_THAT(error_of([] {
                read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
                     "a.ply");
              }),
              HasSubstr("no z"));
  EXPECT_EQ(read("ply\nformat ascii 1.0\nend_header\n", "a.ply").cloud.size(), 0U);
}

TEST(ReadPcd, AsciiWithPackedColoursAndNan) {
  const auto r = read(
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb label\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH "
      "3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n1 2 3 4.2108e+06 7\nnan nan nan 0 0\n4 5 6 2.3693558e-38 9\n",
      "a.pcd");
  ASSERT_EQ(r.cloud.size(), 2U);
  EXPECT_EQ(r.report.counts.at("dropped_points"), 1);
  const auto rgb = std::bit_cast<std::uint32_t>(4.2108e+06F);
  EXPECT_EQ(r.cloud.values<std::uint16_t>("red")[0], (rgb >> 16 & 255) * 257);
  EXPECT_EQ(r.cloud.values<std::uint16_t>("blue")[0], (rgb & 255) * 257);
  EXPECT_EQ(r.cloud.values<double>("label")[1], 9);
}

// Literal runs only: enough to be valid LZF.
std::string lzf_literals(const std::string& data) {
  std::string out;
  for (std::size_t i = 0; i < data.size(); i += 32) {
    const auto part = data.substr(i, 32);
    out += static_cast<char>(part.size() - 1);
    out += part;
  }
  return out;
}

std::string compressed_pcd(std::uint32_t unpacked, const std::string& packed) {
  std::string file =
      "VERSION .7\nFIELDS x y z intensity\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 10\nHEIGHT 1\nDATA "
      "binary_compressed\n";
  put(file, static_cast<std::uint32_t>(packed.size()));
  put(file, unpacked);
  return file + packed;
}

TEST(ReadPcd, CompressedDataIsFieldAfterField) {
  std::string data;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 10; ++i) put(data, static_cast<float>(100 * axis + i));
  for (int i = 0; i < 10; ++i) put(data, static_cast<std::uint8_t>(i));
  const auto r = read(compressed_pcd(130, lzf_literals(data)), "a.pcd");
  ASSERT_EQ(r.cloud.size(), 10U);
  EXPECT_EQ(r.cloud.position(3), Eigen::Vector3d(3, 103, 203));
  EXPECT_EQ(r.cloud.values<float>("intensity")[9], 9);
  EXPECT_THAT(error_of([&] { read(compressed_pcd(4'000'000'000U, lzf_literals(data)), "a.pcd"); }),
              HasSubstr("for 10 points"));
  EXPECT_THAT(error_of([&] { read(compressed_pcd(130, lzf_literals(data).substr(0, 60)), "a.pcd"); }),
              HasSubstr("damaged"));
}

TEST(Lzf, ReferencesOverlapTheirOwnOutput) {
  // 'a' 'b', then 5 bytes from 2 back: "ab" "ababa"
  const std::vector<std::uint8_t> packed{1, 'a', 'b', 3 << 5, 1};
  const auto out = lzf_unpack(packed, 7);
  EXPECT_EQ(std::string(out.begin(), out.end()), "abababa");
  EXPECT_THROW(lzf_unpack(std::vector<std::uint8_t>{1 << 5, 9}, 3), Error);
  EXPECT_THROW(lzf_unpack(packed, 6), Error);
  EXPECT_THROW(lzf_unpack(packed, 1U << 31), Error);
}

TEST(ReadPcd, BinaryThatIsCutOffGivesWhatIsThere) {
  std::string file =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 4\nWIDTH 1000000000\nHEIGHT "
      "1000000000\nPOINTS 1000000000000000000\nDATA binary\n";
  for (int i = 0; i < 5; ++i) {
    put(file, static_cast<float>(i));
    put(file, 2.F);
    put(file, 3.F);
    put(file, 0U);
  }
  file += "xyz";
  const auto r = read(file, "a.pcd");
  EXPECT_EQ(r.cloud.size(), 5U);
  EXPECT_THAT(r.report.warnings.at(0), HasSubstr("5 are present"));
  EXPECT_FALSE(r.cloud.has("_"));
}

TEST(ReadPcd, ErrorsNameTheHeaderEntry) {
  const std::string good = "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    auto text = good;
    text.replace(text.find(from), from.size(), to);
    return error_of([&] { read(text, "a.pcd"); });
  };
  EXPECT_EQ(read(good, "a.pcd").cloud.size(), 1U);
  EXPECT_THAT(with("SIZE 4 4 4", "SIZE 4 4"), HasSubstr("SIZE has 2 entries"));
  EXPECT_THAT(with("SIZE 4 4 4", "SIZE 4 3 4"), HasSubstr("'y'"));
  EXPECT_THAT(with("DATA ascii", "DATA zip"), HasSubstr("'zip'"));
  EXPECT_THAT(with("WIDTH 1", "WIDTH -5"), HasSubstr("WIDTH has '-5'"));
  EXPECT_THAT(with("DATA ascii\n1 2 3\n", ""), HasSubstr("no line DATA"));
  EXPECT_THAT(with("FIELDS x y z", "FIELDS x y w"), HasSubstr("no z"));
}

TEST(ReadText, FindsDelimiterHeaderAndColumns) {
  struct Case {
    const char* text;
    const char* columns;
    Eigen::Vector3d first;
  };
  const Case cases[] = {
      {"1 2 3\n4 5 6\n", "x y z", {1, 2, 3}},
      {"1.5,2.5,3.5,17\n4,5,6,18\n", "x y z intensity", {1.5, 2.5, 3.5}},
      {"1,5;2,25;3,0\n", "x y z", {1.5, 2.25, 3.0}},
      {"1,5 2,25 3,0\n", "x y z", {1.5, 2.25, 3.0}},
      {"//X Y Z Intensity\n1 2 3 4\n", "x y z intensity", {1, 2, 3}},
      {"id\tZ\tY\tX\n7\t1\t2\t3\n", "id z y x", {3, 2, 1}},
      {"\"x\",\"y\",\"z\",\"treeID\"\n1,2,3,5\n", "x y z tree_id", {1, 2, 3}},
      {"2\n1 2 3 -1200 10 20 30\n4 5 6 100 1 2 3\n", "x y z intensity red green blue", {1, 2, 3}},
      {"1 2 3 0.1 -0.9 0.2\n", "x y z column_4 column_5 column_6", {1, 2, 3}},
      {"# a comment\n\n% another\n+1 2e0 3\n", "x y z", {1, 2, 3}},
      {"1 2 3\r4 5 6\r", "x y z", {1, 2, 3}},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.text);
    const auto r = read(c.text, "a.txt");
    EXPECT_EQ(r.report.facts.at("columns"), c.columns);
    ASSERT_GE(r.cloud.size(), 1U);
    EXPECT_EQ(r.cloud.position(0), c.first);
    EXPECT_TRUE(r.report.warnings.empty());
  }
}

TEST(ReadText, ColumnsCanBeSaid) {
  CloudReadOptions options;
  options.columns = "_ y x z time";
  const auto r = read("9 2 1 3 100.25\n", "a.asc", options);
  EXPECT_EQ(r.cloud.position(0), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(r.cloud.values<double>("time")[0], 100.25);
  options.columns = "x y z a b c d";
  EXPECT_THAT(error_of([&] { read("1 2 3 4 5\n", "a.asc", options); }), HasSubstr("names 7 columns, the file has 5"));
}

TEST(ReadText, WordsAmongNumbersAreTold) {
  const auto r = read("x,y,z,classification,height\n1,2,3,ground,4\n4,5,6,vegetation,\n7,8,9,2,nan\n", "a.csv");
  EXPECT_EQ(r.cloud.size(), 3U);
  ASSERT_EQ(r.report.findings.size(), 1U);
  EXPECT_EQ(r.report.findings[0].code, "words_for_numbers");
  EXPECT_THAT(r.report.findings[0].text, HasSubstr("'classification' holds words in 2 lines (the first: 'ground')"));
}

TEST(ReadText, BadLinesAreCountedAndTheFirstIsNamed) {
  const auto r = read("x y z\n1 2 3\n4 5\nfoo bar baz\n7 8 9\n10 11 12\n", "a.xyz");
  EXPECT_EQ(r.cloud.size(), 3U);
  EXPECT_EQ(r.report.counts.at("bad_lines"), 2);
  EXPECT_THAT(r.report.warnings.at(0), HasSubstr("line 3"));
  EXPECT_THAT(error_of([] { read("1 2 3\na\nb\nc\n", "a.xyz"); }), HasSubstr("line 2"));
  EXPECT_THAT(error_of([] { read("dear forester,\nthis is a letter\n", "a.txt"); }), HasSubstr("three numbers"));
}

TEST(ReadText, DecimalCommasBetweenCommasAreRefused) {
  EXPECT_THAT(error_of([] { read("x,y,z,intensity\n1,250,2,500,3,750,7\n", "a.csv"); }),
              testing::AllOf(HasSubstr("line 2 has 7 fields"), HasSubstr("needed: 4"), HasSubstr("decimal commas")));
  // Without a header: six columns of whole numbers, of which every second has three digits.
  EXPECT_THAT(error_of([] { read("1,250,2,500,3,750\n4,125,5,000,6,875\n", "a.csv"); }),
              HasSubstr("no decimal points"));
  CloudReadOptions options;
  options.delimiter = Delimiter::comma;  // somebody who knows
  EXPECT_EQ(read("1,250,2,500,3,750\n4,125,5,000,6,875\n", "a.csv", options).cloud.position(0),
            Eigen::Vector3d(1, 250, 2));
  EXPECT_EQ(read("1,2,3,10,200,30\n4,5,6,7,8,9\n", "a.csv").cloud.size(), 2U);  // colours: digits differ
  EXPECT_EQ(read("x;y;z\n1,25;2,5;3,75\n", "a.csv").cloud.position(0), Eigen::Vector3d(1.25, 2.5, 3.75));
}

TEST(ReadText, MoreFieldsThanTheHeaderAreRefusedInAnyLine) {
  EXPECT_THAT(error_of([] { read("x y z\n1 2 3\n4 5 6 7\n", "a.xyz"); }), HasSubstr("line 3 has 4 fields"));
  EXPECT_THAT(error_of([] { read("1 2 3\n4 5 6 7\n", "a.xyz"); }), HasSubstr("line 2 has 4 fields"));
  EXPECT_EQ(read("x,y,z\n1,2,3,\n4,5,6,,\n", "a.csv").cloud.size(), 2U);  // empty ones are nothing
}

TEST(ReadText, PosesAreNoPoints) {
  EXPECT_THAT(error_of([] { read("1 0 0 5 0 1 0 6 0 0 1 7\n", "poses.txt"); }), HasSubstr("io.read_trajectory"));
  EXPECT_THAT(error_of([] { read("10.5 1 2 3 0 0 0 1\n11 1 2 3 0 0 0.6 0.8\n", "walk.txt"); }),
              HasSubstr("io.read_trajectory"));
  EXPECT_EQ(read("10.5 1 2 3 0 0 0 5\n", "a.txt").cloud.size(), 1U);
}

TEST(ReadText, NumbersOfRowsAreNoCoordinates) {
  const auto numbered = "1 512.25 3.5 12\n2 512.3 3.7 12\n3 512.1 3.4 12\n4 512.7 3.3 12\n5 512.5 3.1 12\n";
  EXPECT_THAT(error_of([&] { read(numbered, "a.txt"); }),
              testing::AllOf(HasSubstr("the first column counts the rows"), HasSubstr("\"_ x y z\"")));
  CloudReadOptions named;
  named.columns = "_ x y z";
  EXPECT_EQ(read(numbered, "a.txt", named).cloud.position(0), Eigen::Vector3d(512.25, 3.5, 12));
  // A line of a grid of whole metres.
  EXPECT_EQ(read("0 7 1 9\n1 7 1 9\n2 7 1 9\n3 7 1 9\n4 7 1 9\n5 7 1 9\n", "a.txt").cloud.size(), 6U);
}

TEST(ReadText, ADeclaredNumberOfPointsIsCompared) {
  const auto fewer = read("100\n1 2 3\n4 5 6\n", "a.pts"), more = read("1\n1 2 3\n4 5 6\n", "a.pts");
  EXPECT_TRUE(has_finding(fewer.report, finding_code::input_incomplete));
  EXPECT_TRUE(has_finding(more.report, "points_behind_header"));
  EXPECT_EQ(more.cloud.size(), 2U);
}

TEST(ReadCloud, CoordinatesBeyondTheEarthAreRefused) {
  EXPECT_THAT(error_of([] { read("1 2 3\n1e30 2 3\n", "a.xyz"); }),
              HasSubstr("1 of 2 points lie more than 100 000 km from the origin"));
  std::string text;
  for (int i = 0; i < 200; ++i) text += "500000.5 5600000 120\n";
  EXPECT_TRUE(has_finding(read(text + "1e12 2 3\n", "a.xyz").report, "implausible_coordinates"));
}

// A header that declares such coordinates wrote them; one that does not stands above noise.
TEST(ReadCloud, CoordinatesBeyondTheEarthAreReadWhereTheHeaderDeclaresThem) {
  const TempDir dir;
  PointCloud cloud;
  cloud.scale.setConstant(1000);
  cloud.set_positions({{0, 0, 0}, {2e11F, 1e9F, 5e8F}, {-3e11F, 0, 7e10F}});
  write_cloud(dir / "far.las", cloud);
  const auto far = read_cloud(dir / "far.las");
  ASSERT_EQ(far.cloud.size(), 3U);
  ASSERT_EQ(far.report.findings.size(), 1U);
  EXPECT_EQ(far.report.findings[0].code, "implausible_coordinates");
  EXPECT_EQ(far.report.findings[0].severity, Severity::refused);
  std::string text = file_text(dir / "far.las");
  const double declared = 10;  // max x
  std::memcpy(text.data() + 179, &declared, sizeof declared);
  EXPECT_THAT(error_of([&] { read(text, "far.las"); }), HasSubstr("2 of 3 points lie more than 100 000 km"));
}

TEST(ReadCloud, APipeIsNoFile) {
  const TempDir dir;
  ASSERT_EQ(::mkfifo((dir / "a.las").c_str(), 0600), 0);  // nobody writes into it: to open it would take for ever
  EXPECT_THAT(error_of([&] { read_cloud(dir / "a.las"); }), HasSubstr("is not a file"));
}

TEST(ReadText, NanAndInfinityAreDroppedAndCounted) {
  const auto r = read("1 2 3\nnan 2 3\n1 inf 3\n4 5 6\n", "a.xyz");
  EXPECT_EQ(r.cloud.size(), 2U);
  EXPECT_EQ(r.report.counts.at("dropped_points"), 2);
}

TEST(ReadCloud, UnitsAndUpAxis) {
  CloudReadOptions options;
  options.unit = LengthUnit::millimetre;
  options.up = UpAxis::y;
  const auto r = read("1000 2000 3000\n", "a.xyz", options);
  EXPECT_TRUE(r.cloud.position(0).isApprox(Eigen::Vector3d(1, -3, 2), 1e-6));
  options = {};
  options.up = UpAxis::x;
  EXPECT_EQ(read("1 2 3\n", "a.xyz", options).cloud.position(0), Eigen::Vector3d(-3, 2, 1));
  EXPECT_NEAR(rotation_to_z_up(UpAxis::x).determinant(), 1, 1e-12);
  EXPECT_NEAR(rotation_to_z_up(UpAxis::y).determinant(), 1, 1e-12);
}

TEST(ReadCloud, AnOutlierDoesNotTakeTheOrigin) {
  std::string text = "0 0 0\n";
  for (int i = 0; i < 100; ++i) text += "450000.1234 5400000.5678 " + std::to_string(i) + "\n";
  const auto r = read(text, "a.xyz");
  EXPECT_NEAR(r.cloud.position(50).x(), 450000.1234, 1e-5);
  EXPECT_NEAR(r.cloud.position(50).y(), 5400000.5678, 1e-5);
}

TEST(ReadCloud, OtherFilesGetASentence) {
  EXPECT_THAT(error_of([] { read("ASTM-E57 and so on", "a.e57"); }), HasSubstr("E57"));
  EXPECT_THAT(error_of([] { read(std::string("\xD4\xC3\xB2\xA1", 4) + std::string(20, '\0'), "a.pcap"); }),
              HasSubstr("io.read_scan"));
  EXPECT_THAT(error_of([] { read(std::string("\x1F\x8B\x08\x00", 4), "a.xyz.gz"); }), HasSubstr("Unpack"));
  EXPECT_THAT(error_of([] { read("", "a.xyz"); }), HasSubstr("empty"));
  EXPECT_THAT(error_of([] { read(std::string(100, '\1'), "a.dat"); }), HasSubstr("format of this file is not known"));
  EXPECT_THAT(error_of([] { read_cloud(std::filesystem::path("/nowhere/a.ply")); }), HasSubstr("/nowhere/a.ply"));
  EXPECT_THAT(error_of([] { read_cloud(std::filesystem::path("/tmp")); }), HasSubstr("folder"));
}

PointCloud sample_cloud() {
  PointCloud::Positions positions{{0.5F, 1.25F, 2.F}, {-3.F, 4.F, 5.F}};
  PointCloud cloud(positions, {450000, 5400000, 0});
  cloud.set_column(arrays::intensity, std::vector<float>{1, 100});
  cloud.set_column(arrays::time, std::vector<double>{1.7e9 + 0.123456, 1.7e9 + 1});
  cloud.set_column(arrays::classification, std::vector<std::uint8_t>{2, 5});
  cloud.set_column(arrays::tree_id, std::vector<std::int32_t>{0, 12});
  cloud.set_column(arrays::red, std::vector<std::uint16_t>{65535, 257});
  cloud.set_column(arrays::green, std::vector<std::uint16_t>{0, 257});
  cloud.set_column(arrays::blue, std::vector<std::uint16_t>{0, 257});
  for (const auto& axis : sensor_arrays)
    cloud.set_column(axis, std::vector<float>{1.5F + static_cast<float>(axis.name.back() - 'x'), -2.25F});
  return cloud;
}

Eigen::Vector3d sensor_position(const PointCloud& cloud, std::size_t i) {
  Eigen::Vector3d p = cloud.origin;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] += static_cast<double>(cloud.values<float>(sensor_arrays[static_cast<std::size_t>(axis)])[i]);
  return p;
}

TEST(WriteCloud, ComesBackEqual) {
  const TempDir dir;
  const auto cloud = sample_cloud();
  for (const char* name : {"a.ply", "a.csv", "a.xyz", "a.las", "a.laz", "a.copc.laz"}) {
    SCOPED_TRACE(name);
    write_cloud(dir / name, cloud);
    const auto back = read_cloud(dir / name).cloud;
    ASSERT_EQ(back.size(), cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) EXPECT_LT((back.position(i) - cloud.position(i)).norm(), 1e-4);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      EXPECT_LT((sensor_position(back, i) - sensor_position(cloud, i)).norm(), 1e-3);
    EXPECT_EQ(back.values<float>("intensity"), cloud.values<float>("intensity"));
    EXPECT_EQ(back.values<double>("time"), cloud.values<double>("time"));
    EXPECT_EQ(back.values<std::uint8_t>("classification"), cloud.values<std::uint8_t>("classification"));
    EXPECT_EQ(back.values<std::int32_t>("tree_id"), cloud.values<std::int32_t>("tree_id"));
    EXPECT_EQ(back.values<std::uint16_t>("red"), cloud.values<std::uint16_t>("red"));
  }
  EXPECT_THAT(error_of([&] { write_cloud(dir / "a.doc", cloud); }), HasSubstr(".doc"));
  EXPECT_THAT(error_of([&] { write_cloud("/proc/nowhere/a.ply", cloud); }), HasSubstr("cannot write"));
}

TEST(WriteCloud, FactsComeBackFromPly) {
  const TempDir dir;
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}});
  write_cloud(dir / "plain.ply", cloud);
  EXPECT_TRUE(read_cloud(dir / "plain.ply").cloud.facts.empty());
  cloud.facts = {{"sensor", "Dôme \"64\"\nend_header"}, {"range_noise_m", "0.005"}};
  write_cloud(dir / "cloud.ply", cloud);
  const auto back = read_cloud(dir / "cloud.ply");
  EXPECT_EQ(back.cloud.facts, cloud.facts);
  EXPECT_EQ(back.cloud.positions(), cloud.positions());
  EXPECT_TRUE(back.report.warnings.empty());
}

TEST(ReadPly, DamagedFactsAreLeftOutWithAWarning) {
  const auto r = read(
      "ply\nformat ascii 1.0\ncomment Bole facts {\"sensor\":\"VL\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n1 2 3\n",
      "a.ply");
  EXPECT_EQ(r.cloud.size(), 1U);
  EXPECT_TRUE(r.cloud.facts.empty());
  EXPECT_THAT(r.report.warnings, testing::ElementsAre(HasSubstr("the facts of the file are damaged")));
}

TEST(WriteCloud, TheSensorIsTurnedAndScaledWithThePoints) {
  const TempDir dir;
  const auto cloud = sample_cloud();
  CloudReadOptions options;
  options.up = UpAxis::y;
  options.unit = LengthUnit::foot;
  const Eigen::Matrix3d matrix = metres_per_unit(options.unit) * rotation_to_z_up(options.up);
  for (const char* name : {"a.ply", "a.csv", "a.las"}) {
    SCOPED_TRACE(name);
    write_cloud(dir / name, cloud);
    const auto back = read_cloud(dir / name, options).cloud;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_LT((back.position(i) - matrix * cloud.position(i)).norm(), 1e-3);
      EXPECT_LT((sensor_position(back, i) - matrix * sensor_position(cloud, i)).norm(), 1e-3);
    }
  }
}

TEST(ReadCloud, ColoursOfPcdThatArePackedTwiceOrAreNoNumbers) {
  const auto text = [](const char* fields, const char* sizes, const char* types, const char* counts, const char* rows) {
    return std::string("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ") + fields + "\nSIZE 4 4 4 " + sizes + "\nTYPE F F F " +
           types + "\nCOUNT 1 1 1 " + counts + "\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n" + rows;
  };
  const auto colour_of = [&](const std::string& file) {
    const auto cloud = read_cloud(bytes_of(file), "a.pcd").cloud;
    std::vector<int> bytes;
    for (const char* name : {"red", "green", "blue"}) bytes.push_back(cloud.values<std::uint16_t>(name).at(0) / 257);
    return bytes;
  };
  const std::vector<int> first{1, 2, 3};  // 0x010203
  EXPECT_EQ(colour_of(text("rgb rgba", "4 4", "U U", "1 1", "1 2 3 66051 16777215\n")), first);
  EXPECT_EQ(colour_of(text("rgb", "4", "U", "2", "1 2 3 66051 16777215\n")), first);
  EXPECT_EQ(colour_of(text("rgb", "4", "U", "1", "1 2 3 abc\n")), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(colour_of(text("rgb", "4", "U", "1", "1 2 3 -1\n")), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(colour_of(text("rgb", "4", "U", "1", "1 2 3 1e30\n")), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(colour_of(text("rgb", "4", "I", "1", "1 2 3 -16711165\n")), first);  // 0xFF010203
}

TEST(ReadCloud, EveryFileOfTheManifest) {
  BOLE_NEEDS_SHARED("readers");
  struct Case {
    const char* file;
    std::size_t points;
  };
  const Case cases[] = {
      {"PDAL/utm17_space.pcd", 10},
      {"PDAL/autzen-utm.pcd", 1065},
      {"PDAL/simple_text.ply", 3},
      {"PDAL/simple_binary.ply", 3},
      {"loaders.gl/ripple.pts", 10201},
      {"loaders.gl/ripple.ptx", 10201},
      {"loaders.gl/ripple_ascii.ply", 10201},
      {"loaders.gl/ripple_bin.ply", 10201},
      {"loaders.gl/simple-ascii.pcd", 213},
      {"loaders.gl/Zaghetto.pcd", 59750},
      {"trimesh/points_cloudcompare.xyz", 101},
      {"trimesh/points_bin.ply", 5},
      {"trimesh/ply_empty_header.ply", 0},
      {"happly/platonic_shelf_big_endian.ply", 50},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.file);
    CloudReading r;
    ASSERT_NO_THROW(r = read_cloud(shared("readers/" + std::string(c.file))));
    EXPECT_EQ(r.cloud.size() + static_cast<std::size_t>(r.report.counts["dropped_points"]), c.points);
  }
  EXPECT_THAT(error_of([] { read_cloud(shared("readers/e57/corrupt_crc.e57")); }), HasSubstr("E57"));
}

TEST(ReadCloud, TheSameCloudFromFourFormatsAgrees) {
  BOLE_NEEDS_SHARED("readers");
  const auto first = read_cloud(shared("readers/loaders.gl/ripple_bin.ply")).cloud;
  for (const char* name : {"ripple_ascii.ply", "ripple.pts", "ripple.ptx"}) {
    SCOPED_TRACE(name);
    const auto other = read_cloud(shared("readers/loaders.gl/" + std::string(name))).cloud;
    ASSERT_EQ(other.size(), first.size());
    Eigen::Vector3d sum_first = Eigen::Vector3d::Zero(), sum_other = Eigen::Vector3d::Zero(), low = sum_first,
                    high = sum_first, low_other = sum_first, high_other = sum_first;
    for (std::size_t i = 0; i < first.size(); ++i) {
      sum_first += first.position(i);
      sum_other += other.position(i);
      low = low.cwiseMin(first.position(i));
      high = high.cwiseMax(first.position(i));
      low_other = low_other.cwiseMin(other.position(i));
      high_other = high_other.cwiseMax(other.position(i));
    }
    EXPECT_LT((sum_first - sum_other).norm() / static_cast<double>(first.size()), 1e-3);
    EXPECT_LT((low - low_other).norm() + (high - high_other).norm(), 1e-2);
  }
}

}  // namespace
}  // namespace bole::io
