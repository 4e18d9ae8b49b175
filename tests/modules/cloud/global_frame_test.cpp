#include "cloud/core/global_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"

namespace bole {
namespace {

GlobalFrame some_frame(double turn_rad, double tilt_rad) {
  GlobalFrame frame;
  frame.centre_local = {1.5, -2.25, 0.5};
  frame.shift_global = {563210.12345678, 5412345.87654321, 431.125};
  frame.A_global_local =
      (Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  frame.crs_wkt = "PROJCS[\"x\"]";
  frame.heights_known = true;
  return frame;
}

TEST(GlobalFrame, TravelsAsFactsWithoutLoss) {
  const auto frame = some_frame(0.4, 0.002);
  Facts facts;
  EXPECT_FALSE(global_frame_of(facts).has_value());
  set_facts(facts, frame);
  const auto back = global_frame_of(facts).value();
  EXPECT_EQ(back.A_global_local, frame.A_global_local);
  EXPECT_EQ(back.centre_local, frame.centre_local);
  EXPECT_EQ(back.shift_global, frame.shift_global);
  EXPECT_EQ(back.crs_wkt, frame.crs_wkt);
  EXPECT_TRUE(back.heights_known);
  EXPECT_NEAR(back.turn_rad(), 0.4, 1e-12);
  EXPECT_LT((back.to_local(back.to_global({10, 20, 3})) - Eigen::Vector3d(10, 20, 3)).norm(), 1e-8);
  for (const char* damaged : {"", "1 2 3", "a b c d e f g h i j k l m n o", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0",
                              "nan 0 0 0 1 0 0 0 1 0 0 0 0 0 0"}) {
    facts["global_frame"] = damaged;
    EXPECT_THROW(global_frame_of(facts), Error) << damaged;
  }
}

TEST(GlobalFrame, MovesCloudsToAMicrometre) {
  const auto frame = some_frame(1.1, 0.002);
  PointCloud cloud({{0, 0, 0}, {20, -15, 3}, {-31.123456F, 12.5F, 25}}, {2, 1, 0});
  cloud.set_column(arrays::sensor_x, std::vector<float>{0, 1, 2});
  cloud.set_column(arrays::sensor_y, std::vector<float>{0, 1, 2});
  cloud.set_column(arrays::sensor_z, std::vector<float>{0, 1, 2});
  const auto moved = to_global(cloud, frame, {});
  EXPECT_EQ(moved.axes, Axes::global);
  EXPECT_EQ(moved.crs_wkt, frame.crs_wkt);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_LT((moved.position(i) - frame.to_global(cloud.position(i))).norm(), 5e-6);
  const Eigen::Vector3d sensor = frame.to_global(cloud.origin + Eigen::Vector3d(2, 2, 2));
  EXPECT_NEAR(moved.origin.x() + static_cast<double>(moved.values<float>(arrays::sensor_x)[2]), sensor.x(), 5e-6);
}

TEST(GlobalFrame, ACloudKnowsTheAxesThatItWasMovedFrom) {
  const auto frame = some_frame(1.1, 0.002);
  PointCloud cloud({{0, 0, 0}, {20, -15, 3}, {-31.123456F, 12.5F, 25}}, {2, 1, 0});
  for (const auto& array : {arrays::sensor_x, arrays::sensor_y, arrays::sensor_z})
    cloud.set_column(array, std::vector<float>{0, 1, 2});
  EXPECT_FALSE(local_axes_of(cloud).has_value());
  const auto global = to_global(cloud, frame, {});
  const auto known = local_axes_of(global).value();
  EXPECT_EQ(known.A_global_local, frame.A_global_local);
  EXPECT_EQ(known.crs_wkt, frame.crs_wkt);
  const auto back = to_local(global, known, {});
  EXPECT_EQ(back.axes, Axes::plot);
  EXPECT_EQ(back.crs_wkt, "");
  EXPECT_FALSE(local_axes_of(back).has_value());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_LT((back.position(i) - cloud.position(i)).norm(), 1e-5);
    const double x = back.origin.x() + static_cast<double>(back.values<float>(arrays::sensor_x)[i]);
    EXPECT_NEAR(x, cloud.origin.x() + static_cast<double>(i), 1e-5);
  }
  auto damaged = global;
  damaged.facts["local_axes"] = "1 2 3";
  EXPECT_THROW(local_axes_of(damaged), Error);
}

// A slope with a height of 0.3 x - 0.1 y + 2.
Raster slope_of(const std::string& quantity) {
  Raster r;
  r.origin = {-10, -12};
  r.cell_m = 0.5;
  r.nx = 40;
  r.ny = 48;
  r.quantity = quantity;
  for (int iy = 0; iy < r.ny; ++iy)
    for (int ix = 0; ix < r.nx; ++ix)
      r.values.push_back(static_cast<float>(0.3 * (r.origin.x() + (ix + 0.5) * r.cell_m) -
                                            0.1 * (r.origin.y() + (iy + 0.5) * r.cell_m) + 2));
  return r;
}

TEST(GlobalFrame, MovesTerrainModels) {
  const auto local = slope_of("elevation_m");
  for (const double turn : {0.0, 0.3, 2.5})
    for (const double tilt : {0.0, 0.01}) {
      const auto frame = some_frame(turn, tilt);
      const auto moved = to_global(local, frame, nullptr, {});
      EXPECT_EQ(moved.axes, Axes::global);
      for (const auto& [x, y] : {std::pair{0.0, 0.0}, {7.3, -9.1}, {-6.2, 8.8}}) {
        const Eigen::Vector3d on_ground = frame.to_global({x, y, 0.3 * x - 0.1 * y + 2});
        EXPECT_NEAR(moved.sample(on_ground.x(), on_ground.y()), on_ground.z(), 2e-4) << turn << " " << tilt;
      }
    }
}

TEST(GlobalFrame, AShiftKeepsTheCells) {
  auto local = slope_of("canopy_height_m");
  local.values[100] = std::nanf("");
  const auto moved = to_global(local, some_frame(0, 0), nullptr, {});
  EXPECT_EQ(moved.nx, local.nx);
  EXPECT_TRUE(std::isnan(moved.values[100]));
  EXPECT_EQ(moved.values[101], local.values[101]);
  EXPECT_NEAR(moved.origin.x(), 563210.12345678 - 11.5, 1e-8);
}

TEST(GlobalFrame, CanopyHeightsStayThoseOfACell) {
  auto local = slope_of("canopy_height_m");
  const auto terrain = slope_of("elevation_m");
  local.at(20, 20) = 30;
  const auto frame = some_frame(0.5, 0.001);
  const auto moved = to_global(local, frame, &terrain, {});
  float highest = 0;
  for (const float v : moved.values)
    if (v > highest) highest = v;
  EXPECT_EQ(highest, 30);
}

}  // namespace
}  // namespace bole
