#include "cloud/large_cloud.h"

#include <gtest/gtest.h>

namespace bole {
namespace {

constexpr std::size_t points = 9'000'000;  // 36 MB of floats

std::vector<float> ranges() {
  std::vector<float> values(points);
  for (std::size_t i = 0; i < points; ++i) values[i] = 0.5F * static_cast<float>(i);
  return values;
}

PointCloud make_cloud() {
  PointCloud cloud(PointCloud::Positions(points, Eigen::Vector3f(1, 2, 3)));
  cloud.set_column(arrays::range, ranges());
  cloud.set_column(arrays::stem, std::vector<std::uint8_t>(points, 1));
  return cloud;
}

bool on_file(const PointCloud& cloud, const ArrayInfo& info) {
  const Column& column = cloud.column(info.name);
  return std::visit([&](const auto& v) { return lies_on_file(v.data(), column_bytes(column)); }, column);
}

TEST(LargeCloud, LargeColumnsLieOnFileAndKeepTheirValues) {
  PointCloud cloud = make_cloud();
  const PointCloud other = cloud;
  EXPECT_EQ(columns_bytes(cloud), points * 5);
  EXPECT_EQ(lay_columns_on_file(cloud, scratch_folders(), points * 4), 0U);
  EXPECT_TRUE(on_file(cloud, arrays::range));
  EXPECT_FALSE(on_file(cloud, arrays::stem));
  leave_memory(cloud);
  EXPECT_EQ(cloud.values<float>(arrays::range), ranges());
  EXPECT_EQ(&cloud.values<float>(arrays::range), &other.values<float>(arrays::range));
  const auto* const before = &cloud.column("range");
  EXPECT_EQ(lay_columns_on_file(cloud, scratch_folders(), 0), 0U);  // a second time: nothing to do
  EXPECT_EQ(&cloud.column("range"), before);
}

TEST(LargeCloud, CloudsThatShareAColumnMayGoInAnyOrder) {
  auto first = std::make_unique<PointCloud>(make_cloud());
  auto second = std::make_unique<PointCloud>(*first);
  lay_columns_on_file(*second, scratch_folders(), 0);
  auto third = std::make_unique<PointCloud>(*second);
  second.reset();
  leave_memory(*third);
  third.reset();
  leave_memory(*first);
  EXPECT_EQ(first->values<float>(arrays::range), ranges());
}

TEST(LargeCloud, SmallOnesStayInMemory) {
  PointCloud cloud = make_cloud();
  EXPECT_EQ(lay_columns_on_file(cloud, scratch_folders()), 0U);
  EXPECT_FALSE(on_file(cloud, arrays::range));
}

TEST(LargeCloud, WithoutRoomColumnsStayInMemoryAndThatIsTold) {
  PointCloud cloud = make_cloud();
  const std::size_t left = lay_columns_on_file(cloud, {"/nowhere/at/all"}, 0);
  EXPECT_EQ(left, points * 4);
  EXPECT_EQ(cloud.values<float>(arrays::range), ranges());
  EXPECT_NE(no_room_for_scratch(6'200'000'000).find("6.2 GB"), std::string::npos);
}

}  // namespace
}  // namespace bole
