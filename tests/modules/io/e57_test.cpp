#include <gmock/gmock.h>

#include <algorithm>

#include "base/verdict.h"
#include "cloud/known_facts.h"
#include "e57_file.h"
#include "io/core/clouds/cloud_reader.h"
#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using test::E57File;
using test::pose_xml;
using test::ring_scan;
using testing::HasSubstr;

CloudReading read_e57_bytes(const std::vector<std::uint8_t>& file, const CloudReadOptions& options = {}) {
  return read_cloud(Bytes(file), "a.e57", options);
}

TEST(E57, ChecksumIsThatOfTheStandard) {
  EXPECT_EQ(e57::crc32c(bytes_of("123456789")), 0xE3069283U);  // RFC 3720
  // By its definition, bit by bit: the processor's instruction takes eight bytes at a time.
  std::string text;
  std::uint32_t seed = 1;
  for (int length = 0; length < 60; ++length) {
    std::uint32_t crc = ~0U;
    for (const char c : text) {
      crc ^= static_cast<std::uint8_t>(c);
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82F63B78U : crc >> 1;
    }
    EXPECT_EQ(e57::crc32c(bytes_of(text)), ~crc) << length;
    seed = seed * 1664525 + 1013904223;
    text += static_cast<char>(seed >> 24);
  }
}

TEST(E57, FieldsOfAllKindsInPacketsOfAnyLength) {
  for (const std::size_t records : {1, 7, 100, 5000}) {
    E57File file;
    file.records_per_packet = std::min<std::size_t>(records, 2000);
    file.scans = {ring_scan(4000)};
    const auto reading = read_e57_bytes(file.bytes());
    const auto& cloud = reading.cloud;
    ASSERT_EQ(cloud.size(), 3600U) << records;  // one of ten is invalid
    EXPECT_EQ(reading.report.counts.at("invalid_points"), 400);
    EXPECT_EQ(reading.report.facts.at("format"), "E57");
    const auto& intensity = cloud.values<float>(arrays::intensity);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::size_t record = i / 9 * 10 + i % 9;
      const auto& row = file.scans[0].rows[record];
      EXPECT_LT((cloud.position(i) - Eigen::Vector3d(row[0], row[1], row[2])).norm(), 2e-6);
      EXPECT_EQ(intensity[i], static_cast<float>(row[3]));
    }
  }
}

TEST(E57, SphericalCoordinatesComeFromTheScanner) {
  E57File file;
  file.scans = {{{{"sphericalRange", 64}, {"sphericalAzimuth", 64}, {"sphericalElevation", 64}}, {}, ""}};
  file.scans[0].rows = {{10, 0, 0}, {10, M_PI / 2, 0}, {2, 1, M_PI / 2}};
  const auto reading = read_e57_bytes(file.bytes());
  ASSERT_EQ(reading.cloud.size(), 3U);
  EXPECT_LT((reading.cloud.position(0) - Eigen::Vector3d(10, 0, 0)).norm(), 1e-6);
  EXPECT_LT((reading.cloud.position(1) - Eigen::Vector3d(0, 10, 0)).norm(), 1e-6);
  EXPECT_LT((reading.cloud.position(2) - Eigen::Vector3d(0, 0, 2)).norm(), 1e-6);
  EXPECT_EQ(reading.cloud.values<float>(arrays::range), (std::vector<float>{10, 10, 2}));
  EXPECT_EQ(reading.cloud.values<float>(arrays::sensor_z), (std::vector<float>{0, 0, 0}));
}

TEST(E57, PosesOfSeveralScansAreRaysAndPasses) {
  E57File file;
  file.scans = {ring_scan(100, pose_xml(500100, 5400020, 400)),
                ring_scan(50, pose_xml(500120, 5400020, 401, M_PI / 2))};
  const auto reading = read_e57_bytes(file.bytes());
  const auto& cloud = reading.cloud;
  ASSERT_EQ(cloud.size(), 135U);
  const auto& x = cloud.values<float>(arrays::sensor_x);
  const auto& z = cloud.values<float>(arrays::sensor_z);
  const auto& scan = cloud.values<std::int32_t>("scan");
  EXPECT_EQ(scan, cloud.values<std::int32_t>(arrays::pass));
  EXPECT_EQ(std::ranges::count(scan, 1), 45);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_NEAR(cloud.origin.x() + x[i], scan[i] == 0 ? 500100 : 500120, 1e-3);
    EXPECT_NEAR(cloud.origin.z() + z[i], 400 + scan[i], 1e-3);
    EXPECT_NEAR((cloud.position(i) - Eigen::Vector3d(scan[i] == 0 ? 500100 : 500120, 5400020, 400 + scan[i])).norm(),
                cloud.values<float>(arrays::range)[i], 1e-3);
  }
  // The first point of the second scan lies on its x axis, which its pose turns to y.
  EXPECT_LT((cloud.position(90) - Eigen::Vector3d(500120, 5400025, 401)).norm(), 1e-3);
  EXPECT_EQ(pose_origin(cloud.facts), PoseOrigin::given);
  EXPECT_TRUE(has_finding(reading.report, "scan_positions"));
}

TEST(E57, PlacesThatTheFileDoesNotSayAreNotTaken) {
  E57File file;
  file.scans = {ring_scan(100)};
  const auto without = read_e57_bytes(file.bytes());
  EXPECT_FALSE(without.cloud.has(arrays::sensor_x));
  EXPECT_TRUE(has_finding(without.report, "scan_positions_unknown"));
  CloudReadOptions options;
  options.scan_positions = ScanPositions::given;
  EXPECT_TRUE(read_e57_bytes(file.bytes(), options).cloud.has(arrays::sensor_x));

  // A pose that is a shift of the coordinates, not a place: the origin lies beside all points.
  file.scans = {ring_scan(100, pose_xml(100, 0, 0))};
  for (auto& row : file.scans[0].rows) row[0] += 30;
  const auto shifted = read_e57_bytes(file.bytes());
  EXPECT_FALSE(shifted.cloud.has(arrays::sensor_x));
  EXPECT_FALSE(shifted.cloud.has(arrays::range));
  EXPECT_TRUE(has_finding(shifted.report, "scan_positions_unknown"));
  options.scan_positions = ScanPositions::none;
  file.scans = {ring_scan(100, pose_xml(101, 0, 0))};
  EXPECT_TRUE(read_e57_bytes(file.bytes()).cloud.has(arrays::sensor_x));
  EXPECT_FALSE(read_e57_bytes(file.bytes(), options).cloud.has(arrays::sensor_x));
}

TEST(E57, TimesColoursGridsAndImages) {
  E57File file;
  test::E57Scan scan{{{"cartesianX", 32},
                      {"cartesianY", 32},
                      {"cartesianZ", 32},
                      {"rowIndex", 12},
                      {"columnIndex", 12},
                      {"colorRed", 8},
                      {"colorGreen", 8},
                      {"colorBlue", 8},
                      {"timeStamp", 64},
                      {"isIntensityInvalid", 1},
                      {"intensity", 32},
                      {"nor:normalX", 32}},
                     {{1, 2, 3, 7, 9, 255, 0, 51, 0.5, 0, 0.25, 1}, {2, 2, 3, 8, 9, 0, 255, 0, 1.5, 1, 0.5, 0}},
                     "<sensorVendor>Maker</sensorVendor><sensorModel>S1</sensorModel><acquisitionStart "
                     "type=\"Structure\"><dateTimeValue type=\"Float\">1.3e9</dateTimeValue></acquisitionStart>"
                     "<intensityLimits type=\"Structure\"><intensityMinimum type=\"Float\"/><intensityMaximum "
                     "type=\"Float\">1</intensityMaximum></intensityLimits>"};
  file.scans = {scan};
  file.xml = "<images2D type=\"Vector\"><vectorChild/><vectorChild/></images2D>";
  const auto reading = read_e57_bytes(file.bytes());
  const auto& cloud = reading.cloud;
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.values<std::uint16_t>(arrays::red), (std::vector<std::uint16_t>{65535, 0}));
  EXPECT_EQ(cloud.values<std::uint16_t>(arrays::blue)[0], 51 * 257);
  EXPECT_EQ(cloud.values<double>(arrays::time), (std::vector<double>{1.3e9 + 0.5, 1.3e9 + 1.5}));
  EXPECT_EQ(cloud.values<std::int32_t>("row"), (std::vector<std::int32_t>{7, 8}));
  EXPECT_EQ(cloud.values<float>("normalx"), (std::vector<float>{1, 0}));
  EXPECT_TRUE(std::isnan(cloud.values<float>(arrays::intensity)[1]));
  EXPECT_EQ(reading.report.counts.at("images_skipped"), 2);
  EXPECT_EQ(reading.report.metrics.at("intensity_max").value, 1);
  EXPECT_EQ(fact_text(cloud.facts, facts::sensor), "Maker S1");
}

TEST(E57, ADamagedPageCostsThePointsInIt) {
  E57File file;
  file.scans = {ring_scan(4000)};
  file.records_per_packet = 2000;
  auto bytes = file.bytes();
  bytes[5 * E57File::page + 100] ^= 0x10;
  const auto reading = read_e57_bytes(bytes);
  EXPECT_EQ(reading.report.counts.at("damaged_pages"), 1);
  EXPECT_TRUE(has_finding(reading.report, "damaged_pages"));
  EXPECT_TRUE(has_finding(reading.report, finding_code::input_incomplete));
  EXPECT_GT(reading.cloud.size(), 3000U);
  EXPECT_LT(reading.cloud.size(), 3600U);
  // What is left is right, and stands in its place.
  for (std::size_t i = 0; i < reading.cloud.size(); ++i)
    EXPECT_NEAR(reading.cloud.position(i).head<2>().norm(), 5, 1e-5);
}

TEST(E57, ADamagedPacketHeaderEndsItsScanAlone) {
  E57File file;
  file.scans = {ring_scan(1000, pose_xml(0, 0, 0)), ring_scan(1000, pose_xml(20, 0, 0))};
  auto bytes = file.bytes();
  bytes[1 * E57File::page + 3] ^= 0xFF;
  const auto reading = read_e57_bytes(bytes);
  const auto& scan = reading.cloud.values<std::int32_t>("scan");
  EXPECT_EQ(std::ranges::count(scan, 1), 900);
  EXPECT_LT(std::ranges::count(scan, 0), 900);
}

TEST(E57, ADamagedDescriptionIsRefused) {
  E57File file;
  file.scans = {ring_scan(10)};
  auto bytes = file.bytes();
  bytes[bytes.size() - E57File::page + 700] ^= 1;
  EXPECT_THAT(error_of([&] { read_e57_bytes(bytes); }), HasSubstr("checksum"));
}

TEST(E57, CutLyingAndEmptyFiles) {
  E57File file;
  file.scans = {ring_scan(4000)};
  auto bytes = file.bytes();
  for (const std::size_t size :
       {std::size_t{8}, std::size_t{47}, std::size_t{48}, bytes.size() / 2, bytes.size() - 1025})
    EXPECT_NE(error_of([&] {
                read_e57_bytes({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
              }),
              "no error")
        << size;
  file.declared_more = 1'000'000'000'000ULL;
  const auto lying = read_e57_bytes(file.bytes());
  EXPECT_EQ(lying.cloud.size(), 3600U);
  EXPECT_TRUE(has_finding(lying.report, finding_code::input_incomplete));
  file.declared_more = 0;
  file.scans = {ring_scan(0)};
  EXPECT_EQ(read_e57_bytes(file.bytes()).cloud.size(), 0U);
  file.scans.clear();
  EXPECT_EQ(read_e57_bytes(file.bytes()).cloud.size(), 0U);
}

TEST(E57, ScansThatCannotBeReadAreNamed) {
  E57File file;
  file.scans = {ring_scan(100), {{{"intensity", 8}}, {{1}, {2}}, ""}};
  const auto reading = read_e57_bytes(file.bytes());
  EXPECT_EQ(reading.cloud.size(), 90U);
  EXPECT_TRUE(std::ranges::any_of(reading.report.warnings,
                                  [](const std::string& w) { return w.find("scan 1 has no coord") != w.npos; }));
}

TEST(E57, BoundsAreThoseOfTheFile) {
  E57File file;
  file.scans = {ring_scan(1000, pose_xml(100, 0, 0)), ring_scan(1000, pose_xml(200, 0, 0))};
  CloudReadOptions options;
  options.bounds = "150,-10,250,10";
  EXPECT_EQ(read_e57_bytes(file.bytes(), options).cloud.size(), 900U);
  options.bounds = "150,-10,160,10";
  EXPECT_THAT(error_of([&] { read_e57_bytes(file.bytes(), options); }), HasSubstr("bounds"));
}

// Counts of readers/manifest.csv.
TEST(E57Samples, AreReadAsTheManifestSays) {
  BOLE_NEEDS_SHARED("readers/libE57Format-test-data");
  EXPECT_EQ(read_cloud(shared("readers/libE57Format-test-data/bunnyInt32.e57")).cloud.size(), 30571U);
  const auto cube = read_cloud(shared("readers/libE57Format-test-data/ColouredCubeFloat.e57"));
  EXPECT_EQ(cube.cloud.size(), 7680U);
  EXPECT_TRUE(cube.cloud.has(arrays::red));
  EXPECT_EQ(read_cloud(shared("readers/libE57Format-test-data/ZeroPoints.e57")).cloud.size(), 0U);
  const auto spherical = read_cloud(shared("readers/e57/tiny_spherical.e57"));
  EXPECT_EQ(spherical.cloud.size(), 180U);  // of 360, half are marked as invalid
  EXPECT_EQ(spherical.report.counts.at("invalid_points"), 180);
  EXPECT_TRUE(spherical.cloud.has(arrays::sensor_x));
  EXPECT_EQ(read_cloud(shared("readers/e57/tinyCartesianFloatRgb.e57")).cloud.size(), 2090U);
}

// Its damaged page is that of the description.
TEST(E57Samples, TheCorruptOneIsRefused) {
  BOLE_NEEDS_SHARED("readers/e57");
  EXPECT_THAT(error_of([] { read_cloud(shared("readers/e57/corrupt_crc.e57")); }), HasSubstr("checksum"));
}

}  // namespace
}  // namespace bole::io
