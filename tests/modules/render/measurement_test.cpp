#include "render/scene/measurement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "render/scene/eye_dome.h"
#include "render/scene/view_furniture.h"

namespace bole::render {
namespace {

using Kind = Measurement::Kind;

Measurement measured(Kind kind, std::vector<Eigen::Vector3d> points) {
  Measurement m;
  m.kind = kind, m.points = std::move(points);
  return m;
}

double value(const Measurement& m, const std::string& name) {
  for (const auto& v : values_of(m))
    if (v.name == name) return v.value;
  return std::nan("");
}

const Eigen::Vector3d utm(431000.25, 5412000.5, 311);  // projected coordinates

TEST(Measurement, ADistanceHasItsParts) {
  const auto m = measured(Kind::distance, {utm, utm + Eigen::Vector3d(3, -4, 5)});
  EXPECT_NEAR(value(m, "distance"), std::sqrt(50.0), 1e-9);
  EXPECT_NEAR(value(m, "horizontal"), 5, 1e-9);
  EXPECT_NEAR(value(m, "vertical"), 5, 1e-9);
  EXPECT_NEAR(value(m, "slope"), 45, 1e-9);
}

TEST(Measurement, AnAngleIsThatAtTheMiddlePoint) {
  const auto m = measured(Kind::angle, {utm + Eigen::Vector3d(2, 0, 0), utm, utm + Eigen::Vector3d(0, 1, 1)});
  EXPECT_NEAR(value(m, "angle"), 90, 1e-9);
  EXPECT_NEAR(value(m, "angle in plan"), 90, 1e-9);
  const auto steep = measured(Kind::angle, {utm + Eigen::Vector3d(1, 0, 0), utm, utm + Eigen::Vector3d(1, 0, 1)});
  EXPECT_NEAR(value(steep, "angle"), 45, 1e-9);
  EXPECT_NEAR(value(steep, "angle in plan"), 0, 1e-9);
}

TEST(Measurement, ARingIsTheCircleThroughThreePlaces) {
  std::vector<Eigen::Vector3d> places;
  for (const double a : {0.2, 1.9, 4.0})
    places.push_back(utm + Eigen::Vector3d(0.17 * std::cos(a), 0.17 * std::sin(a), a));
  const auto m = measured(Kind::ring, places);
  EXPECT_NEAR(value(m, "diameter"), 34, 1e-4);
  EXPECT_NEAR(value(m, "centre x"), utm.x(), 1e-6);
  EXPECT_NEAR(value(m, "z"), utm.z() + 6.1 / 3, 1e-9);
  const auto lines = lines_of(m);
  ASSERT_EQ(lines.size(), 1u);
  for (const auto& p : lines[0]) EXPECT_NEAR((p - utm).head<2>().norm(), 0.17, 1e-6);
  const auto flat = measured(Kind::ring, {utm, utm + Eigen::Vector3d(1, 1, 0), utm + Eigen::Vector3d(2, 2, 0)});
  EXPECT_TRUE(values_of(flat).empty());
  EXPECT_NE(label_of(flat).find("one line"), std::string::npos);
}

TEST(Measurement, AFileOfThemComesBackAsItWas) {
  auto point = measured(Kind::point, {utm});
  point.name = "nest, \"old\"", point.height_above_ground_m = 12.5, point.time_s = 1'732'190'123.25;  // since 1970
  const std::vector<Measurement> all{point, measured(Kind::distance, {utm, 2 * utm})};
  const auto back = parse_measurements(measurements_json(all));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, point.name);
  EXPECT_EQ(back[0].points[0], utm);
  EXPECT_EQ(back[0].height_above_ground_m, 12.5);
  EXPECT_EQ(back[0].time_s, point.time_s);
  EXPECT_FALSE(back[1].time_s);
  EXPECT_EQ(back[1].kind, Kind::distance);
  EXPECT_EQ(back[1].points[1], 2 * utm);
  EXPECT_NE(measurements_csv(all).find("\"nest, \"\"old\"\"\",point,height above ground,12.5"), std::string::npos);
}

TEST(Measurement, AFileThatIsNoneIsRefusedByNumber) {
  for (const char* text : {"", "[]", R"({"measurements": 3})"}) EXPECT_THROW(parse_measurements(text), Error) << text;
  for (const char* entry :
       {R"({"kind": "area", "points": []})", R"({"kind": "distance", "points": [[1, 2, 3]]})",
        R"({"kind": "point", "points": [[1, 2]]})", R"({"kind": "point", "points": [[1, 2, 1e300]]})"})
    try {
      parse_measurements(std::string(R"({"measurements": [{"kind": "point", "points": [[1, 2, 3]]}, )") + entry + "]}");
      ADD_FAILURE() << entry;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("measurement 2"), std::string::npos) << e.what();
    }
}

TEST(ViewFurniture, WhatDidNotChangeKeepsItsState) {
  ViewFurniture f;
  f.width_mm = 200, f.height_mm = 120, f.mm_per_metre = 3;
  f.labels.push_back({{30, 30}, "0.20 m", false});
  const auto before = furniture_patches(f);
  f.labels[0].at_mm = {50, 60};
  auto after = furniture_patches(f);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].state, after[i].state);
  EXPECT_NE(before.back().box.x0, after.back().box.x0);
  f.mm_per_metre = 4, f.north_rad = 1;
  after = furniture_patches(f);
  EXPECT_NE(before[0].state, after[0].state);
  EXPECT_NE(before[1].state, after[1].state);
}

TEST(TreeMarks, NumbersKeepApartAndTheFirstGoesBefore) {
  const auto mark = [](double x, double y, const char* number) {
    TreeMark m;
    m.at_mm = {x, y};
    m.number = number;
    return m;
  };
  const Box view{0, 0, 100, 100};
  const auto kept =
      kept_apart({mark(50, 50, "7"), mark(51, 50.5, "8"), mark(50, 58, "9"), mark(99.9, 50, "10")}, view, 9);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].number, "7");
  EXPECT_EQ(kept[1].number, "9");
  EXPECT_FALSE(mark_box(kept[0]).overlaps(mark_box(kept[1])));
  EXPECT_EQ(kept_apart({mark(20, 20, "1"), mark(50, 50, "2"), mark(80, 80, "3")}, view, 2).size(), 2u);
}

TEST(TreeMarks, TheLegendNamesWhatIsSeen) {
  TreeMark good, struck;
  good.quality = "good";
  struck.quality = "poor", struck.state = "rejected";
  EXPECT_EQ(tree_legend_height_mm({}), 0);
  EXPECT_LT(tree_legend_height_mm({good}), tree_legend_height_mm({good, struck}));
  EXPECT_NE(tree_legend_state({good}), tree_legend_state({good, struck}));
  EXPECT_EQ(tree_legend_state({good, struck}), tree_legend_state({struck, good, good}));
  ViewFurniture f;
  f.width_mm = 200, f.height_mm = 120, f.north = false;
  f.trees = {good, struck};
  EXPECT_EQ(furniture_patches(f).size(), 2u);
  f.tree_legend = true;
  EXPECT_EQ(furniture_patches(f).size(), 3u);
}

TEST(EyeDome, TheShadowIsTheShading) {
  const int width = 40, height = 30;
  std::vector<float> depth(width * height, 5);
  for (int y = 10; y < 20; ++y)
    for (int x = 10; x < 30; ++x) depth[static_cast<std::size_t>(y * width + x)] = 5.4F;  // a hollow
  std::vector<std::uint8_t> rgb(3 * depth.size(), 200);
  const auto shadow = eye_dome_shadow(depth, width, height, {});
  shade_eye_dome(rgb, depth, width, height, {});
  int dark = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    EXPECT_NEAR(200 * (255 - shadow[i]) / 255.0, rgb[3 * i], 1.01);
    dark += rgb[3 * i] < 190 ? 1 : 0;
  }
  EXPECT_GT(dark, 20);
}

}  // namespace
}  // namespace bole::render
