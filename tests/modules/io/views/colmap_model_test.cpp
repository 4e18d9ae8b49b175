#include "io/core/views/colmap_model.h"

#include <gmock/gmock.h>

#include "io/core/views/open_views.h"
#include "view_folder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

namespace fs = std::filesystem;

struct ColmapFiles {
  std::string cameras, images, points;
};

std::vector<double> quaternion_and_shift(int number) {
  const Pose T_camera_world = pose_number(number).inverse();
  const Eigen::Quaterniond q(T_camera_world.linear());
  const Eigen::Vector3d t = T_camera_world.translation();
  return {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()};
}

ColmapFiles colmap_text(int count, const std::string& camera = "1 OPENCV 64 48 60 61 32 24 0.01 0 0 0.001") {
  ColmapFiles files;
  files.cameras = "# Camera list\n" + camera + "\n";
  files.images = "# Image list\n";
  for (int i = count - 1; i >= 0; --i) {
    files.images += std::to_string(i + 1);
    for (const double v : quaternion_and_shift(i)) files.images += " " + std::to_string(v);
    files.images += " 1 view " + std::to_string(i) + ".png\n" + (i == 0 ? "" : "1.5 2.5 7 3 4 -1") + "\n";
  }
  files.points = "# points\n7 0.1 0.2 0.3 255 0 0 0.5 1 0 2 0\n8 0.1 0.2 0.3 255 0 0 1.5 1 0 2 0 3 1 4 1\n";
  return files;
}

ColmapFiles colmap_bytes(int count) {
  ColmapFiles files;
  put(files.cameras, std::uint64_t{1});
  put(files.cameras, std::uint32_t{1});
  put(files.cameras, std::uint32_t{4});  // OPENCV
  put(files.cameras, std::uint64_t{64});
  put(files.cameras, std::uint64_t{48});
  for (const double v : {60.0, 61.0, 32.0, 24.0, 0.01, 0.0, 0.0, 0.001}) put(files.cameras, v);
  put(files.images, static_cast<std::uint64_t>(count));
  for (int i = count - 1; i >= 0; --i) {
    put(files.images, static_cast<std::uint32_t>(i + 1));
    for (const double v : quaternion_and_shift(i)) put(files.images, v);
    put(files.images, std::uint32_t{1});
    files.images += "view " + std::to_string(i) + ".png";
    files.images += '\0';
    put(files.images, std::uint64_t{1});
    put(files.images, 1.5);
    put(files.images, 2.5);
    put(files.images, std::int64_t{7});
  }
  put(files.points, std::uint64_t{1});
  put(files.points, std::uint64_t{7});
  for (const double v : {0.1, 0.2, 0.3}) put(files.points, v);
  files.points += std::string(3, '\x7f');
  put(files.points, 0.5);
  put(files.points, std::uint64_t{2});
  for (const std::uint32_t v : {1, 0, 2, 0}) put(files.points, v);
  return files;
}

void write_model(const fs::path& folder, const ColmapFiles& files, const std::string& ending) {
  write_file(folder / ("cameras" + ending), files.cameras);
  write_file(folder / ("images" + ending), files.images);
  write_file(folder / ("points3D" + ending), files.points);
}

TEST(ColmapModel, TextAndBinaryGiveTheSameViews) {
  for (const bool binary : {false, true}) {
    const TempDir dir;
    for (int i = 0; i < 3; ++i) write_color(dir / ("images/view " + std::to_string(i) + ".png"), picture(i));
    write_model(dir / "sparse/0", binary ? colmap_bytes(3) : colmap_text(3), binary ? ".bin" : ".txt");
    Report report;
    const auto views = open_views(dir.path(), {}, {}, report);
    ASSERT_EQ(views->size(), 3u);
    EXPECT_EQ(views->name(2), "view 2.png");
    auto expected = small_camera().color;
    expected.distortion = {0.01, 0, 0, 0.001, 0};
    EXPECT_EQ(views->camera(0).color, expected);
    for (int i = 0; i < 3; ++i) {
      const auto pose = pose_of_view(views->given_poses(), views->time_s(static_cast<std::size_t>(i)));
      ASSERT_TRUE(pose);
      EXPECT_TRUE(pose->isApprox(pose_number(i), 1e-5));
    }
    EXPECT_EQ(report.counts.at("model_points"), binary ? 1 : 2);
    EXPECT_DOUBLE_EQ(report.metrics.at("model_reprojection_error").value, binary ? 0.5 : 1.0);
    EXPECT_TRUE(has_finding(report, "scale_unknown"));
    EXPECT_EQ(open_views(dir / "sparse/0")->size(), 3u);
    EXPECT_EQ(open_views(dir / ("sparse/0/cameras" + std::string(binary ? ".bin" : ".txt")))->size(), 3u);
  }
}

TEST(ColmapModel, ModelsOfCameras) {
  const auto camera = [](const std::string& line) { return parse_colmap_cameras(bytes_of("1 " + line), false).at(1); };
  EXPECT_EQ(camera("SIMPLE_PINHOLE 64 48 60 32 24").fy, 60);
  EXPECT_EQ(camera("PINHOLE 64 48 60 61 32 24"), small_camera().color);
  EXPECT_EQ(camera("SIMPLE_RADIAL 64 48 60 32 24 0.02").distortion[0], 0.02);
  EXPECT_EQ(camera("RADIAL 64 48 60 32 24 0.02 0.01").distortion[1], 0.01);
  EXPECT_EQ(camera("RADIAL 64 48 60 32 24 0.02 0.01").cy, 23.5);
  EXPECT_EQ(camera("FULL_OPENCV 64 48 60 61 32 24 0.01 0 0 0 0.003 0 0 0").distortion[4], 0.003);
  const auto refused = [&](const std::string& line) { return error_of([&] { camera(line); }); };
  EXPECT_THAT(refused("FULL_OPENCV 64 48 60 61 32 24 0.01 0 0 0 0.003 0.1 0 0"), HasSubstr("FULL_OPENCV"));
  EXPECT_THAT(refused("OPENCV_FISHEYE 64 48 60 61 32 24 0 0 0 0"), HasSubstr("image_undistorter"));
  EXPECT_THAT(refused("FOV 64 48 60 61 32 24 0.1"), HasSubstr("FOV"));
  EXPECT_THAT(refused("MOON 64 48 60 61 32 24"), HasSubstr("MOON"));
  EXPECT_THAT(refused("PINHOLE 64 48 60 61 32"), HasSubstr("3 parameters"));
  EXPECT_THAT(refused("PINHOLE 64 48 60 61 32 nan"), HasSubstr("no number"));
  EXPECT_THAT(refused("PINHOLE 64000000 48 60 61 32 24"), HasSubstr("64000000 x 48"));
  EXPECT_THAT(error_of([] {
                parse_colmap_cameras(bytes_of("1 PINHOLE 64 48 60 61 32 24\n1 PINHOLE 64 48 60 61 32 24"), false);
              }),
              HasSubstr("two cameras"));
}

TEST(ColmapModel, FilesThatAreCutOffOrLieAreRefused) {
  const auto whole = colmap_bytes(2);
  for (std::size_t kept = 0; kept < whole.cameras.size(); ++kept)
    EXPECT_NE(error_of([&] { parse_colmap_cameras(bytes_of(whole.cameras.substr(0, kept)), true); }), "no error");
  for (std::size_t kept = 0; kept < whole.images.size(); ++kept)
    EXPECT_NE(error_of([&] { parse_colmap_images(bytes_of(whole.images.substr(0, kept)), true); }), "no error");
  for (std::size_t kept = 1; kept < whole.points.size(); ++kept)
    EXPECT_NE(error_of([&] { parse_colmap_points(bytes_of(whole.points.substr(0, kept)), true); }), "no error");
  auto lying = whole.images;
  lying.replace(0, 8, std::string(7, '\xff') + '\x0f');
  EXPECT_THAT(error_of([&] { parse_colmap_images(bytes_of(lying), true); }), HasSubstr("claims"));
  auto model = whole.cameras;
  model[12] = 99;
  EXPECT_THAT(error_of([&] { parse_colmap_cameras(bytes_of(model), true); }), HasSubstr("number 99"));
  EXPECT_THAT(error_of([] { parse_colmap_images(bytes_of("1 1 0 0 0 0 0 0\n"), false); }), HasSubstr("8 words"));
  EXPECT_THAT(error_of([] { parse_colmap_images(bytes_of("1 3 0 0 0 0 0 0 1 a.png\n"), false); }),
              HasSubstr("length 3"));
}

TEST(ColmapModel, ImagesWithoutTheirCameraOrFilesAreTold) {
  const TempDir dir;
  write_model(dir.path(), colmap_text(2, "2 PINHOLE 64 48 60 61 32 24"), ".txt");
  EXPECT_THAT(error_of([&] { open_views(dir.path()); }), HasSubstr("are not found"));
  write_color(dir / "images/view 1.png", picture(1));
  EXPECT_THAT(error_of([&] { open_views(dir.path()); }), HasSubstr("has camera 1"));
  write_model(dir.path(), colmap_text(2), ".txt");
  Report report;
  EXPECT_EQ(open_views(dir.path(), {}, {}, report)->size(), 1u);
  EXPECT_THAT(finding_text(report, "colour_missing"), HasSubstr("view 0.png"));
}

}  // namespace
}  // namespace bole::io
