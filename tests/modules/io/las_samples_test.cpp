// Real files, as readers/manifest.csv describes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

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

const Eigen::Vector3d simple_min(635619.85, 848899.7, 406.59), simple_max(638982.55, 853535.43, 586.38);
INSTANTIATE_TEST_SUITE_P(
    Manifest, LasSample,
    testing::Values(
        Sample{"readers/PDAL/simple.las", 1065, simple_min, simple_max, 276},
        Sample{"readers/PDAL/simple.laz", 1065, simple_min, simple_max, 276},
        Sample{"readers/PDAL/extrabytes.las", 1065, simple_min, simple_max, 276},
        Sample{"readers/PDAL/1.2-with-color.copc.laz", 1065, simple_min, simple_max, 276},
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
