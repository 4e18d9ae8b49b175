// What E57 files claim of their scans and cannot be so.
#include <gmock/gmock.h>

#include <algorithm>

#include "base/verdict.h"
#include "e57_file.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/turn_cloud.h"
#include "io/core/e57/e57_description.h"
#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using test::E57File;
using test::E57Scan;
using test::pose_xml;
using test::ring_scan;
using testing::HasSubstr;

CloudReading read_scans(const std::vector<E57Scan>& scans, const CloudReadOptions& options = {}) {
  E57File file;
  file.scans = scans;
  return read_cloud(Bytes(file.bytes()), "a.e57", options);
}

bool has_places(const CloudReading& reading) {
  const bool has = reading.cloud.has(arrays::sensor_x);
  EXPECT_EQ(has_finding(reading.report, "scan_positions_unknown"), !has);
  return has;
}

bool warns(const CloudReading& reading, const std::string& part) {
  return std::ranges::any_of(reading.report.warnings,
                             [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

// A ring of cells; `bits` of the indices: 0 where all are the same.
E57Scan grid(unsigned bits, const Eigen::Vector3d& shift, const std::string& xml = {}) {
  E57Scan scan{
      {{"cartesianX", 64}, {"cartesianY", 64}, {"cartesianZ", 64}, {"rowIndex", bits}, {"columnIndex", bits}}, {}, xml};
  for (int i = 0; i < 100; ++i)
    scan.rows.push_back({shift.x() + 5 * std::cos(0.1 * i), shift.y() + 5 * std::sin(0.1 * i), shift.z(),
                         static_cast<double>(bits == 0 ? 0 : i), static_cast<double>(bits == 0 ? 0 : i)});
  return scan;
}

TEST(E57Places, GridsInProjectedCoordinatesHaveNone) {
  EXPECT_TRUE(has_places(read_scans({grid(8, {0, 0, 1})})));
  EXPECT_FALSE(has_places(read_scans({grid(8, {500000, 5400000, 300})})));
  auto around = grid(8, {0, 0, 0});  // the origin is among them, and far from nearly all
  for (auto& row : around.rows) row[0] *= 1000, row[1] *= 1000;
  EXPECT_FALSE(has_places(read_scans({around})));
  CloudReadOptions given;
  given.scan_positions = ScanPositions::given;
  EXPECT_TRUE(read_scans({around}, given).cloud.has(arrays::sensor_x));
}

TEST(E57Places, IndicesThatAreAllTheSameAreNoGrid) { EXPECT_FALSE(has_places(read_scans({grid(0, {0, 0, 1})}))); }

TEST(E57Places, ShiftsOfCloudCompareAndMergedScansAreNone) {
  EXPECT_FALSE(has_places(
      read_scans({ring_scan(100, pose_xml(500100, 5400000, 0)), ring_scan(100, pose_xml(500300, 5400000, 0))})));
  const std::string merged =
      "<originalGuids type=\"Vector\"><vectorChild type=\"String\">a</vectorChild>"
      "<vectorChild type=\"String\">b</vectorChild></originalGuids>";
  EXPECT_FALSE(has_places(read_scans({ring_scan(100, pose_xml(12, 7, 0) + merged)})));
  EXPECT_TRUE(has_places(read_scans({ring_scan(100, pose_xml(12, 7, 0))})));
}

TEST(E57Places, TheFirstOfRegisteredScansMayHaveNoPose) {
  const auto reading = read_scans({ring_scan(100), ring_scan(100, pose_xml(12, 7, 0))});
  ASSERT_TRUE(has_places(reading));
  const auto& x = reading.cloud.values<float>(arrays::sensor_x);
  EXPECT_EQ(x.front(), 0);
  EXPECT_NEAR(x.back(), 12, 1e-5);
}

TEST(E57Fields, OfOtherNamesNeverStandInTheColumnsOfBole) {
  E57Scan scan{{{"cartesianX", 64},
                {"cartesianY", 64},
                {"cartesianZ", 64},
                {"intensity", 64},
                {"ext:x", 64},
                {"ext:intensity", 64},
                {"ext:range", 64},
                {"ext:sensor_x", 64},
                {"ext:time", 64},
                {"ext:scan", 64},
                {"a:foo", 64},
                {"b:foo", 64},
                {"_own", 64}},
               {{1, 2, 3, 4, 91, 92, 93, 94, 95, 96, 97, 98, 99}, {-1, -2, 3, 5, 91, 92, 93, 94, 95, 96, 97, 98, 99}},
               pose_xml(12, 7, 0)};
  const auto reading = read_scans({scan});
  const auto& cloud = reading.cloud;
  EXPECT_LT((cloud.position(0) - Eigen::Vector3d(13, 9, 3)).norm(), 1e-5);
  EXPECT_EQ(cloud.values<float>(arrays::intensity), (std::vector<float>{4, 5}));
  EXPECT_EQ(cloud.values<float>(arrays::sensor_x)[0], 12);
  EXPECT_NEAR(cloud.values<float>(arrays::range)[0], std::sqrt(14), 1e-6);
  EXPECT_FALSE(cloud.has(arrays::time));
  EXPECT_EQ(cloud.values<std::int32_t>("scan")[0], 0);
  EXPECT_EQ(cloud.values<double>("ext_x")[0], 91);
  EXPECT_EQ(cloud.values<double>("ext_intensity")[0], 92);
  EXPECT_EQ(cloud.values<double>("foo")[0], 97);
  EXPECT_EQ(cloud.values<double>("b_foo")[0], 98);
  EXPECT_EQ(cloud.values<double>("field_own")[0], 99);
}

TEST(E57Fields, EmptyCellsOfAGridAreNoPoints) {
  auto scan = grid(8, {0, 0, 1});
  for (const std::size_t i : {3, 7, 8}) scan.rows[i][0] = scan.rows[i][1] = scan.rows[i][2] = 0;
  const auto reading = read_scans({scan});
  EXPECT_EQ(reading.cloud.size(), 97U);
  EXPECT_EQ(reading.report.counts.at("empty_cells"), 3);
}

TEST(E57Numbers, RangesAreInMetresLikeTheirPoints) {
  CloudReadOptions feet;
  feet.unit = LengthUnit::foot;
  auto cloud = read_scans({ring_scan(100, pose_xml(12, 7, 0))}, feet).cloud;
  const auto& range = cloud.values<float>(arrays::range);
  EXPECT_NEAR(range[0], 5 * 0.3048, 1e-5);
  turn_cloud(cloud, 2 * rotation_to_z_up(UpAxis::y));
  EXPECT_NEAR(cloud.values<float>(arrays::range)[0], 10 * 0.3048, 1e-5);
}

TEST(E57Numbers, LimitsAsScaledIntegersAreScaled) {
  const auto reading = read_scans(
      {ring_scan(100,
                 "<intensityLimits type=\"Structure\"><intensityMinimum type=\"ScaledInteger\" scale=\"0.001\">0"
                 "</intensityMinimum><intensityMaximum type=\"ScaledInteger\" scale=\"0.001\" offset=\"1\">65535"
                 "</intensityMaximum></intensityLimits>")});
  EXPECT_NEAR(reading.report.metrics.at("intensity_max").value, 66.535, 1e-9);
}

TEST(E57Numbers, PosesThatAreNoneLeaveTheirScanOut) {
  for (const char* lie : {"NaN", "1,5"}) {
    auto xml = pose_xml(12.5, 7, 0);
    xml.replace(xml.find("12.5"), 9, lie);
    auto scan = ring_scan(100, "<name type=\"String\">west</name>" + xml);
    const auto reading = read_scans({ring_scan(100), scan});
    EXPECT_EQ(reading.cloud.size(), 90U) << lie;
    EXPECT_TRUE(warns(reading, "scan 1 ('west')")) << lie;
    EXPECT_TRUE(has_finding(reading.report, finding_code::input_incomplete)) << lie;
  }
}

TEST(E57Numbers, LimitsAndScalesThatAreNoneLeaveTheirScanOut) {
  const auto scan_with = [](const std::string& attributes) {
    const std::string xml =
        "<e57Root><data3D><vectorChild><points fileOffset=\"48\" recordCount=\"1\"><prototype "
        "type=\"Structure\"><cartesianX type=\"ScaledInteger\" " +
        attributes + "/></prototype></points></vectorChild></data3D></e57Root>";
    return e57::parse_description(bytes_of(xml));
  };
  EXPECT_EQ(scan_with("minimum=\"0\" maximum=\"9\" scale=\"0.1\"").scans[0].fields.size(), 1U);
  EXPECT_EQ(scan_with("minimum=\"0\"").scans[0].fields[0].scale, 1);
  for (const char* lie : {"scale=\"0,1\"", "minimum=\"1.5\"", "maximum=\"\"", "offset=\"nan\""}) {
    const auto description = scan_with(lie);
    EXPECT_TRUE(description.scans[0].fields.empty()) << lie;
    EXPECT_THAT(description.warnings.at(0), HasSubstr("scan 0")) << lie;
  }
}

}  // namespace
}  // namespace bole::io
