#include <gmock/gmock.h>

#include <cmath>

#include "cloud/data.h"

namespace bole {
namespace {

using ::testing::HasSubstr;

PointCloud three_points() {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {500000, 5000000, 100});
  cloud.axes = Axes::global;
  cloud.crs_wkt = "WKT";
  cloud.set_column(arrays::range, std::vector<float>{10, 20, 30});
  cloud.set_column(arrays::tree_id, std::vector<std::int32_t>{1, 0, 2});
  return cloud;
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(PointCloud, PositionsAreOriginPlusOffset) {
  EXPECT_EQ(three_points().position(1), Eigen::Vector3d(500004, 5000005, 106));
}

TEST(PointCloud, CopiesSharePointsAndColumns) {
  const auto cloud = three_points();
  auto copy = cloud;
  copy.set_column(arrays::ring, std::vector<std::uint16_t>{1, 2, 3});
  EXPECT_EQ(cloud.positions().data(), copy.positions().data());
  EXPECT_EQ(&cloud.column("range"), &copy.column("range"));
  EXPECT_FALSE(cloud.has("ring"));
}

TEST(PointCloud, SubsetKeepsOrderColumnsAndFrame) {
  const auto part = three_points().subset({2, 0});
  EXPECT_EQ(part.position(0), Eigen::Vector3d(500007, 5000008, 109));
  EXPECT_THAT(part.values<std::int32_t>(arrays::tree_id), ::testing::ElementsAre(2, 1));
  EXPECT_EQ(part.axes, Axes::global);
  EXPECT_EQ(part.crs_wkt, "WKT");
}

TEST(PointCloud, WrongAccessIsExplained) {
  auto cloud = three_points();
  EXPECT_THAT(error_of([&] { cloud.column("ring"); }), HasSubstr("It has: range, tree_id"));
  EXPECT_THAT(error_of([&] { cloud.values<double>("range"); }), HasSubstr("float32"));
  EXPECT_THAT(error_of([&] { cloud.set_column("ring", std::vector<float>{1}); }), HasSubstr("3, one per point"));
}

TEST(Arrays, NamesAreUniqueAndColumnsFollowTheirTypes) {
  std::set<std::string_view> names;
  for (const auto& a : array_vocabulary()) {
    EXPECT_TRUE(names.insert(a.name).second) << a.name;
    EXPECT_EQ(column_type(make_column(a.type, 2)), a.type);
    EXPECT_EQ(find_array(a.name)->meaning, a.meaning);
  }
  EXPECT_EQ(find_array("no such"), nullptr);
}

TEST(Axes, NamesReadBack) {
  for (const auto axes : {Axes::unknown, Axes::sensor, Axes::map, Axes::plot, Axes::global})
    EXPECT_EQ(axes_from_name(axes_name(axes)), axes);
  EXPECT_THROW(axes_from_name("moon"), Error);
}

TEST(Table, HoldsTypedColumnsOfOneLength) {
  Table table;
  table.set("tree_id", std::vector<std::int64_t>{1, 2});
  table.set("dbh_cm", std::vector<double>{20.25, std::nan("")});
  table.set("state", std::vector<std::string>{"auto", "check"});
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.text("dbh_cm", 0, 1), "20.2");
  EXPECT_EQ(table.text("dbh_cm", 0), "20.25");
  EXPECT_EQ(table.text("dbh_cm", 1), "") << "a missing number is an empty cell";
  EXPECT_THAT(table.numbers("tree_id"), ::testing::ElementsAre(1, 2));
  EXPECT_EQ(table.subset({1}).texts("state")[0], "check");
  EXPECT_THAT(error_of([&] { table.set("x", std::vector<double>{1}); }), HasSubstr("has 1 rows"));
  EXPECT_THAT(error_of([&] { table.numbers("dbh"); }), HasSubstr("tree_id, dbh_cm, state"));
  EXPECT_THAT(error_of([&] { table.numbers("state"); }), HasSubstr("holds text"));
}

TEST(Raster, SamplesBilinearlyBetweenCellCentres) {
  Raster raster;
  raster.origin = {10, 20}, raster.cell_m = 2, raster.nx = 3, raster.ny = 2;
  raster.values = {0, 2, 4, 10, 12, 14};
  EXPECT_DOUBLE_EQ(raster.sample(11, 21), 0);   // centre of the first cell
  EXPECT_DOUBLE_EQ(raster.sample(12, 21), 1);   // between two centres
  EXPECT_DOUBLE_EQ(raster.sample(12, 22), 6);   // between four
  EXPECT_DOUBLE_EQ(raster.sample(10, 20), 0);   // the border value holds
  EXPECT_DOUBLE_EQ(raster.sample(16, 24), 14);  // the far corner
  EXPECT_TRUE(std::isnan(raster.sample(9.99, 21)));
  EXPECT_TRUE(std::isnan(raster.sample(std::nan(""), 21)));
  raster.at(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(raster.sample(12, 22)));
  EXPECT_DOUBLE_EQ(raster.sample(11, 21), 0) << "a hole of weight zero does no harm";
}

TEST(Trajectory, InterpolatesAndRefusesFarTimes) {
  Trajectory path;
  path.poses.push_back({100, Pose::Identity()});
  Pose end = Pose::Identity();
  end.translate(Eigen::Vector3d(2, 0, 0)).rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()));
  path.poses.push_back({101, end});
  EXPECT_NEAR(path.at(100.5).translation().x(), 1, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(path.at(100.5).linear()).angle(), 0.1, 1e-12);
  EXPECT_NEAR(path.at(101.1).translation().x(), 2.2, 1e-12) << "held constant in velocity beyond the end";
  EXPECT_DOUBLE_EQ(path.length_m(), 2);
  EXPECT_THAT(error_of([&] { path.at(102); }), HasSubstr("same clock"));
  EXPECT_THAT(error_of([&] { Trajectory().at(0); }), HasSubstr("0 poses"));
}

TEST(DataSet, GivesTypedDataOrSaysWhatIsMissing) {
  DataSet set;
  set.set("points", three_points());
  EXPECT_EQ(set.cloud("points").size(), 3u);
  EXPECT_TRUE(set.has("points"));
  EXPECT_FALSE(set.has("dem"));
  EXPECT_THAT(error_of([&] { set.raster("points"); }), HasSubstr("'points'"));
}

}  // namespace
}  // namespace bole
