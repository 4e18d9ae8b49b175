#include "io/core/clouds/take_cloud.h"

#include <gmock/gmock.h>

#include <cmath>

#include "cloud/known_facts.h"
#include "io/core/clouds/see_cloud.h"

namespace bole::io {
namespace {

using testing::HasSubstr;

PointCloud three_points() {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}, {std::nanf(""), 0, 0}}, {500000, 5400000, 0});
  cloud.set_column("Reflectance", std::vector<float>{1, 2, 3});
  cloud.set_column("red", std::vector<std::uint16_t>{7, 8, 9});
  cloud.facts["clock"] = "utc";
  cloud.crs_wkt = "PROJCS[...]";
  cloud.axes = Axes::global;
  return cloud;
}

TEST(TakeCloud, IsReadAsAFileIs) {
  const auto reading = take_cloud(three_points());
  ASSERT_EQ(reading.cloud.size(), 2U);
  EXPECT_EQ(reading.report.counts.at("dropped_points"), 1);
  EXPECT_EQ(reading.report.facts.at("format"), "memory");
  EXPECT_TRUE(reading.cloud.position(1).isApprox(Eigen::Vector3d(500004, 5400005, 6)));
  EXPECT_EQ(reading.cloud.values<float>(arrays::intensity), (std::vector<float>{1, 2}));
  EXPECT_EQ(reading.cloud.values<std::uint16_t>(arrays::red), (std::vector<std::uint16_t>{7, 8}));
}

TEST(TakeCloud, FactsAndAxesStayUnlessTheOptionsNameThem) {
  EXPECT_EQ(take_cloud(three_points()).cloud.axes, Axes::global);
  CloudReadOptions options;
  options.axes = Axes::plot;
  const auto cloud = take_cloud(three_points(), options).cloud;
  EXPECT_EQ(cloud.axes, Axes::plot);
  EXPECT_EQ(cloud.facts.at("clock"), "utc");
  EXPECT_EQ(cloud.crs_wkt, "PROJCS[...]");
}

TEST(TakeCloud, UnitAxisAndBoundsHold) {
  SeeCloudOptions options;
  options.unit = LengthUnit::centimetre;
  options.up = UpAxis::y;
  options.reading.bounds = "0,0,300,300";
  const auto reading = see_cloud(PointCloud({{100, 200, -50}, {400, 0, 0}}), options).reading;
  ASSERT_EQ(reading.cloud.size(), 1U);
  EXPECT_EQ(reading.report.counts.at("points_outside_bounds"), 1);
  EXPECT_TRUE(reading.cloud.position(0).isApprox(Eigen::Vector3d(1, 0.5, 2)));
  EXPECT_THAT(reading.report.message, HasSubstr("1 points, given in memory"));
}

TEST(TakeCloud, NumbersThatAreNoCoordinatesAreRefused) {
  EXPECT_THROW(take_cloud(PointCloud({{1e30F, 0, 0}, {0, 1e30F, 0}})), Error);
}

}  // namespace
}  // namespace bole::io
