// Real files, as readers/manifest.csv describes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/las/las_reader.h"
#include "real_data.h"

namespace bole::io {
namespace {

const std::filesystem::path data = BOLE_SHARED_DATA_DIR;

struct Sample {
  std::string path;
  std::size_t points;
  Eigen::Vector3d min, max;
  std::size_t ground;  // points of class 2
};
void PrintTo(const Sample& s, std::ostream* out) { *out << s.path; }

class LasSample : public testing::TestWithParam<Sample> {};

TEST_P(LasSample, CountBoxAndClasses) {
  const auto path = data / GetParam().path;
  BOLE_NEEDS_REAL(path);
  const PointCloud cloud = read_las(path);
  ASSERT_EQ(cloud.size(), GetParam().points);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e30), high = -low;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = exact_position(cloud, i);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_LT((low - GetParam().min).cwiseAbs().maxCoeff(), 0.0011) << low.transpose();
  EXPECT_LT((high - GetParam().max).cwiseAbs().maxCoeff(), 0.0011) << high.transpose();
  const auto& classes = cloud.values<std::uint8_t>(arrays::classification);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(classes, 2)), GetParam().ground);
}

const Eigen::Vector3d min_simple(635619.85, 848899.7, 406.59), max_simple(638982.55, 853535.43, 586.38);
INSTANTIATE_TEST_SUITE_P(
    Manifest, LasSample,
    testing::Values(
        Sample{"readers/PDAL/simple.las", 1065, min_simple, max_simple, 276},
        Sample{"readers/PDAL/simple.laz", 1065, min_simple, max_simple, 276},
        Sample{"readers/PDAL/extrabytes.las", 1065, min_simple, max_simple, 276},
        Sample{"readers/PDAL/1.2-with-color.copc.laz", 1065, min_simple, max_simple, 276},
        Sample{"readers/PDAL/test1_4.las",
               1000,
               {1694038.446, 1816492.706, 5592.75},
               {1694539.677, 1816497.976, 5599.07},
               1000},
        Sample{"readers/PDAL/100-points.las", 100, {635717.85, 848953.74, 409.19}, {638944.95, 853483.3, 530.61}, 27},
        Sample{"readers/PDAL/autzen_trim.laz",
               110000,
               {636001.76, 848935.2, 406.26},
               {637179.22, 849497.9, 520.51},
               26107}));

TEST(LasSamples, EmptyFileIsAnEmptyCloud) {
  const auto path = data / "readers/PDAL/no-points.las";
  BOLE_NEEDS_REAL(path);
  EXPECT_EQ(read_las(path).size(), 0U);
}

TEST(LasSamples, CompressedEqualsUncompressed) {
  for (const std::string name : {"readers/loaders.gl/ripple", "readers/loaders.gl/pdrf6-1.4", "readers/PDAL/simple"}) {
    BOLE_NEEDS_REAL(data / (name + ".las"));
    const PointCloud plain = read_las(data / (name + ".las")), packed = read_las(data / (name + ".laz"));
    EXPECT_EQ(plain.positions(), packed.positions()) << name;
    EXPECT_EQ(plain.origin, packed.origin) << name;
    for (const auto& [column, values] : plain.columns())
      EXPECT_EQ(*values, packed.column(column)) << name << " " << column;
  }
}

// Numbers of all values that the format has, in steps of 1 m: no coordinates, but points as they were written. Sums and
// first points are those that laspy 2.5.4 gives (of all columns: tests/bench/peers/las_against_laspy.py).
struct RandomSample {
  std::string path;
  std::map<std::string, double> sums;
  std::array<double, 2> times;
};
void PrintTo(const RandomSample& s, std::ostream* out) { *out << s.path; }

class LasOfRandomNumbers : public testing::TestWithParam<RandomSample> {};

TEST_P(LasOfRandomNumbers, AreReadAsTheyWereWritten) {
  const auto path = data / GetParam().path;
  BOLE_NEEDS_REAL(path);
  const CloudReading reading = read_cloud(path);
  const PointCloud& cloud = reading.cloud;
  ASSERT_EQ(cloud.size(), 1024U);
  const Eigen::Vector3d first[] = {{373598160, 295657190, 195961234}, {1448380368, 362706660, 0}};
  constexpr double float_steps = 128;  // half of a step of float32 numbers at 2^31 m
  EXPECT_LE((cloud.position(0) - first[0]).cwiseAbs().maxCoeff(), float_steps);
  EXPECT_LE((cloud.position(1) - first[1]).head<2>().cwiseAbs().maxCoeff(), float_steps);
  EXPECT_EQ(cloud.values<double>(arrays::time)[0], GetParam().times[0]);
  EXPECT_EQ(cloud.values<double>(arrays::time)[1], GetParam().times[1]);
  for (const auto& [name, sum] : GetParam().sums) {
    ASSERT_TRUE(cloud.has(name)) << name;
    double found = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) found += column_value(cloud.column(name), i);
    EXPECT_EQ(found, sum) << name;
  }
  const auto& findings = reading.report.findings;
  const auto told = std::ranges::find(findings, "implausible_coordinates", &Finding::code);
  ASSERT_NE(told, findings.end());
  EXPECT_EQ(told->severity, Severity::refused);
  EXPECT_THAT(told->text, testing::HasSubstr("1024 of 1024 points"));
}

const std::map<std::string, double> format_6{{"intensity", 33049351},
                                             {"return_number", 8038},
                                             {"number_of_returns", 7728},
                                             {"synthetic", 548},
                                             {"key_point", 530},
                                             {"withheld", 494},
                                             {"overlap", 493},
                                             {"scanner_channel", 1605},
                                             {"scan_direction", 459},
                                             {"edge_of_flight_line", 482},
                                             {"classification", 128752},
                                             {"user_data", 134435},
                                             {"point_source_id", 34989761},
                                             {"FIELD_0", 128667},
                                             {"FIELD_1", 133381},
                                             {"FIELD_2", 135182},
                                             {"FIELD_3", 129830}};
const std::map<std::string, double> format_8{{"intensity", 32866212},
                                             {"return_number", 8088},
                                             {"number_of_returns", 7669},
                                             {"synthetic", 551},
                                             {"key_point", 538},
                                             {"withheld", 483},
                                             {"overlap", 491},
                                             {"scanner_channel", 1640},
                                             {"scan_direction", 467},
                                             {"edge_of_flight_line", 482},
                                             {"classification", 130942},
                                             {"user_data", 135880},
                                             {"point_source_id", 35203431},
                                             {"red", 35042160},
                                             {"green", 34304961},
                                             {"blue", 35497485},
                                             {"near_infrared", 34543291},
                                             {"FIELD_0", 126265},
                                             {"FIELD_1", 124947},
                                             {"FIELD_2", 128277},
                                             {"FIELD_3", 119763}};
INSTANTIATE_TEST_SUITE_P(
    Manifest, LasOfRandomNumbers,
    testing::Values(
        RandomSample{"readers/loaders.gl/pdrf6-1.4.las", format_6, {{0x1.1a277bbe41301p-2, 0x1.1a277bb841309p-128}}},
        RandomSample{"readers/loaders.gl/pdrf6-1.4.laz", format_6, {{0x1.1a277bbe41301p-2, 0x1.1a277bb841309p-128}}},
        RandomSample{"readers/loaders.gl/pdrf8-1.4.laz", format_8, {{0x1.1a277bbe41301p-2, 0x1.1a27fbb871309p+0}}}));

TEST(LasSamples, UserDefinedGeoTiffKeysBecomeWkt) {
  const auto path = data / "readers/PDAL/autzen_trim.laz";
  BOLE_NEEDS_REAL(path);
  const LasInfo info = las_info(path);
  EXPECT_THAT(info.crs_wkt, testing::HasSubstr("PROJCS"));
  EXPECT_THAT(info.crs_wkt, testing::HasSubstr("Lambert_Conformal_Conic"));
  EXPECT_THAT(info.warnings, testing::Contains(testing::HasSubstr("0.3048 m), not in metres")));
}

}  // namespace
}  // namespace bole::io
