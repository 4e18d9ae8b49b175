// The stem as depth shows it, beside its edges in the colour picture.
#include "render/charts/stem_in_depth.h"

#include <gmock/gmock.h>

#include "camera/registered_depth.h"
#include "render/draw/canvas.h"

namespace bole::render {
namespace {

constexpr double stem_distance_m = 0.5, wall_m = 0.7;

CameraModel color_camera() { return {160, 120, 800, 800, 79.5, 59.5, {}}; }

// View 0: a stem of 8 pixels. View 1: wider, but edges of a leaf that the fit does not trust. View 2: wide, few rows.
Table contours() {
  std::vector<std::int64_t> view;
  std::vector<std::string> name;
  std::vector<double> lx, ly, rx, ry, weight;
  const auto add = [&](int v, double half_px, int rows, double w) {
    for (int i = 0; i < rows; ++i) {
      view.push_back(v), name.push_back("view_" + std::to_string(v)), weight.push_back(w);
      lx.push_back(80 - half_px), rx.push_back(80 + half_px), ly.push_back(30 + 2 * i), ry.push_back(30 + 2 * i);
    }
  };
  add(0, 4, 12, 1), add(1, 7, 12, 0.1), add(2, 6, 3, 1);
  Table t;
  t.set("view", view), t.set("name", name), t.set("left_x_px", lx), t.set("left_y_px", ly);
  t.set("right_x_px", rx), t.set("right_y_px", ry), t.set("weight", weight);
  return t;
}

// A wall, and a stem as wide as `half_px` on both sides of x = 80 before it.
DepthImage stem_before_wall(double half_px) {
  DepthImage depth(160, 120, 1, static_cast<float>(wall_m));
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      if (std::abs(x - 80) <= half_px) depth.at(x, y) = static_cast<float>(stem_distance_m);
  return depth;
}

// Of 8 pixels at that distance.
double diameter_m() { return 8 * stem_distance_m / color_camera().fx; }

TEST(StemInDepth, TheLargestTrustedViewIsTaken) {
  const auto edges = largest_stem(contours());
  ASSERT_TRUE(edges);
  EXPECT_EQ(edges->view, 0);
  EXPECT_DOUBLE_EQ(edges->width_px, 8);
  EXPECT_EQ(edges->left.size(), 12U);
  EXPECT_FALSE(largest_stem(Table{}));
}

TEST(StemInDepth, AFatStemIsMeasuredAndNoneIsSaid) {
  const auto edges = *largest_stem(contours());
  const auto fat = stem_in_depth(edges, stem_before_wall(7), color_camera(), diameter_m());
  EXPECT_EQ(fat.seen, 12U);
  EXPECT_NEAR(fat.width_mm, 15 * 1000 * stem_distance_m / 800, 0.35);  // 15 pixels, to half a pixel
  const auto none = stem_in_depth(edges, stem_before_wall(-1), color_camera(), diameter_m());
  EXPECT_EQ(none.seen, 0U);
  EXPECT_TRUE(std::isnan(none.width_mm));
}

TEST(StemInDepth, DepthOfACameraOfItsOwnIsSeenFromTheColourCamera) {
  RgbdCamera camera{color_camera(), CameraModel{80, 60, 400, 400, 39.5, 29.5, {}}, Pose::Identity(), 1000};
  camera.T_color_depth.translation() = Eigen::Vector3d(0.01, 0, 0);  // the depth camera stands 1 cm to the right
  DepthImage depth(80, 60, 1, 0);
  depth.at(40, 30) = 0.5F;
  const auto seen = registered_depth(depth, {}, camera.of_depth(), camera.T_color_depth, camera.color);
  // (40 - 39.5) / 400 * 0.5 m + 1 cm, at 800 pixels: 17 pixels right of 79.5; a coarse pixel covers several fine ones.
  EXPECT_FLOAT_EQ(seen.at(97, 61), 0.5F);
  EXPECT_FLOAT_EQ(seen.at(90, 61), 0);
}

TEST(StemInDepth, TheFigureShowsBothPicturesAndSaysTheWidths) {
  const auto edges = *largest_stem(contours());
  const ColorImage color(160, 120, 3, 200);
  const RgbdCamera camera{color_camera(), std::nullopt, Pose::Identity(), 1000};
  const auto figure = stem_in_depth_figure(edges, color, stem_before_wall(7), camera, diameter_m(), 180);
  EXPECT_THAT(figure.caption, testing::HasSubstr("by its edges 5.0 mm"));
  EXPECT_THAT(figure.caption, testing::HasSubstr("12 of 12 show it"));
  const auto drawn = figure_image(figure, 100);
  const double px_per_mm = drawn.width / 180.0;
  const auto at = [&](double x_mm) {
    return drawn.pixel(static_cast<int>(x_mm * px_per_mm), static_cast<int>(figure.height_mm / 2 * px_per_mm));
  };
  EXPECT_NEAR(at(5).r, 200 / 255.0, 0.02);  // the grey picture
  EXPECT_GT(at(90).r, at(90).b + 0.3);      // the wall, beyond the range: yellow
}

}  // namespace
}  // namespace bole::render
