#include "io/core/views/view_layouts.h"

#include <gmock/gmock.h>

#include <numbers>

#include "io/core/views/open_views.h"
#include "io/core/views/pose_list.h"
#include "io/core/views/pose_matrix.h"
#include "view_folder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

namespace fs = std::filesystem;

std::string layout_of(const fs::path& path) {
  const auto* row = find_layout(path);
  return row == nullptr ? "none" : std::string(choice_name(row->layout));
}

std::string matrix_text(const Pose& pose) {
  std::ostringstream out;
  out.precision(17);
  out << pose.matrix() << "\n";
  return out.str();
}

std::string quaternion_text(const Pose& pose) {
  std::ostringstream out;
  out.precision(17);
  const Eigen::Quaterniond q(pose.linear());
  out << pose.translation().transpose() << " " << q.x() << " " << q.y() << " " << q.z() << " " << q.w() << "\n";
  return out.str();
}

void expect_poses(const ViewSource& views, const std::vector<int>& numbers, double tolerance = 1e-6) {
  ASSERT_EQ(views.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto pose = pose_of_view(views.given_poses(), views.time_s(i));
    ASSERT_TRUE(pose) << views.name(i);
    EXPECT_TRUE(pose->isApprox(pose_number(numbers[i]), tolerance)) << views.name(i);
  }
}

TEST(ViewLayouts, RowsStandInTheOrderOfTheirWords) {
  const auto rows = view_layouts();
  ASSERT_EQ(rows.size(), choice_names(ViewLayout{}).size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(rows[i].layout), i);
}

// --- TUM

void write_tum_folder(const fs::path& folder) {
  std::string rgb = "# color images\n", depth = "# depth maps\n", truth = "# time tx ty tz qx qy qz qw\n";
  for (int i = 0; i < 4; ++i) {
    const double time = 1305031453.1 + 0.033 * i;
    const auto name = std::to_string(time) + ".png";
    write_color(folder / "rgb" / name, picture(i));
    write_depth(folder / "depth" / name, slope(i), 5000);
    rgb += std::to_string(time) + " rgb/" + name + "\n";
    depth += std::to_string(time + 0.012) + " depth/" + name + "\n";
    truth += std::to_string(time) + " " + quaternion_text(pose_number(i));
  }
  write_file(folder / "rgb.txt", rgb);
  write_file(folder / "depth.txt", depth);
  write_file(folder / "groundtruth.txt", truth);
}

TEST(TumViews, ColourDepthAndPosesMeetByTime) {
  const TempDir dir;
  write_tum_folder(dir.path());
  EXPECT_EQ(layout_of(dir.path()), "tum");
  EXPECT_THAT(refusal(dir.path()), HasSubstr("tum_freiburg1"));
  const auto [views, report] = opened(dir.path(), {.camera = "60,61,31.5,23.5"});
  expect_poses(*views, {0, 1, 2, 3});
  EXPECT_NEAR(views->time_s(1), 1305031453.133, 1e-6);
  EXPECT_NEAR(report.metrics.at("depth_apart").value, 0.012, 1e-6);
  View view;
  views->read(2, view);
  EXPECT_NEAR(view.depth.at(10, 10), slope(2).at(10, 10), 2e-4);
}

TEST(TumViews, ListedFilesThatAreMissingAreCounted) {
  const TempDir dir;
  write_tum_folder(dir.path());
  auto rgb = file_text(dir / "rgb.txt");
  for (int i = 10; i < 30; ++i) rgb += std::to_string(1305031454 + 0.1 * i) + " rgb/none.png\n";
  write_file(dir / "rgb.txt", rgb);
  const auto [views, report] = opened(dir.path(), {.camera = "60,61,31.5,23.5"});
  EXPECT_EQ(views->size(), 4u);
  EXPECT_THAT(finding_text(report, "colour_missing"), HasSubstr("20 colour images are missing"));
}

TEST(TumViews, DepthFarInTimeIsNoDepth) {
  const TempDir dir;
  write_tum_folder(dir.path());
  write_file(dir / "depth.txt", "1305031453.112 depth/1305031453.100000.png\n1305031459.1 depth/none.png\n");
  const auto [views, report] = opened(dir.path(), {.camera = "60,61,31.5,23.5"});
  EXPECT_EQ(report.counts.at("views_with_depth"), 1);
  EXPECT_THAT(finding_text(report, "views_without_depth"), HasSubstr("3 views"));
}

TEST(TumViews, AGapInTheTruthGivesNoPose) {
  const TempDir dir;
  write_tum_folder(dir.path());
  write_file(dir / "groundtruth.txt", "1305031453.0 0 0 0 0 0 0 1\n1305031459.0 1 0 0 0 0 0 1\n");
  const auto [views, report] = opened(dir.path(), {.camera = "60,61,31.5,23.5"});
  EXPECT_TRUE(views->given_poses().empty());
  EXPECT_THAT(finding_text(report, "views_without_pose"), HasSubstr("4 views"));
}

TEST(TumViews, AssociationsMayNameDepthFirst) {
  const TempDir dir;
  write_tum_folder(dir.path());
  const std::string name = "1305031453.100000.png";
  write_file(dir / "associations.txt", "1305031453.112 depth/" + name + " 1305031453.1 rgb/" + name + "\n");
  const auto views = opened(dir.path(), {.camera = "60,61,31.5,23.5"}).views;
  ASSERT_EQ(views->size(), 1u);
  EXPECT_TRUE(views->has_depth());
  write_file(dir / "associations.txt", "1305031453.112 depth/" + name + "\n");
  EXPECT_THAT(refusal(dir.path(), {.camera = "60,61,31.5,23.5"}), HasSubstr("colour and depth in each line"));
  write_file(dir / "associations.txt", "no time\n");
  EXPECT_THAT(refusal(dir.path()), HasSubstr("line 1"));
}

TEST(TumViews, RealFramesOfFreiburg) {
  BOLE_NEEDS_SHARED("rgbd_tum9");
  const auto [views, report] = opened(shared("rgbd_tum9"));
  EXPECT_EQ(views->size(), 9u);
  EXPECT_EQ(views->given_poses().poses.size(), 9u);
  EXPECT_DOUBLE_EQ(views->camera(0).color.fx, 517.3);
  EXPECT_THAT(finding_text(report, "camera_by_name"), HasSubstr("tum_freiburg1"));
  EXPECT_NEAR(report.metrics.at("median_depth").value, 1.3, 0.8);
}

TEST(TumViews, RealListsThatNameAbsentFiles) {
  BOLE_NEEDS_SHARED("rgbd_tum9");
  const TempDir dir;
  fs::create_directory_symlink(shared("rgbd_tum9/rgb"), dir / "rgb");
  fs::create_directory_symlink(shared("rgbd_tum9/depth"), dir / "depth");
  for (const char* name : {"rgb.txt", "depth.txt"})
    fs::copy_file(shared("rgbd_tum9/full_sequence_" + std::string(name)), dir / name);
  const auto [views, report] = opened(dir.path());
  EXPECT_EQ(views->size(), 9u);
  EXPECT_EQ(report.counts.at("views_with_depth"), 9);
  EXPECT_GT(report.counts.at("colour_missing"), 500);
}

// --- ICL and Open3D

TEST(IclViews, OpenThreeDsTrajectoryAndIntrinsics) {
  const TempDir dir;
  std::string log;
  for (int i = 0; i < 3; ++i) {
    write_color(dir / ("color/" + six_digits(i + 1) + ".png"), picture(i));
    write_depth(dir / ("depth/" + six_digits(i + 1) + ".png"), slope(i));
    log +=
        std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i + 1) + "\n" + matrix_text(pose_number(i));
  }
  write_file(dir / "trajectory.log", log);
  write_file(dir / "camera_primesense.json",
             R"({"width": 64, "height": 48, "intrinsic_matrix": [60, 0, 0, 0, 61, 0, 31.5, 23.5, 1]})");
  EXPECT_EQ(layout_of(dir.path()), "icl");
  const auto [views, report] = opened(dir.path());
  expect_poses(*views, {0, 1, 2});
  EXPECT_EQ(views->camera(0).color, small_camera().color);
  write_file(dir / "camera_primesense.json",
             R"({"width": 64, "height": 48, "intrinsic_matrix": [60, 0, 31.5, 0, 61, 23.5, 0, 0, 1]})");
  EXPECT_EQ(opened(dir.path()).views->camera(0).color, small_camera().color);
  write_file(dir / "trajectory.log", log.substr(0, log.size() - 40));
  EXPECT_TRUE(has_finding(opened(dir.path()).report, "poses_damaged"));
  write_file(dir / "trajectory.log", log.substr(0, log.find("\n1 1 2") + 1));
  EXPECT_THAT(finding_text(opened(dir.path()).report, "poses_other_count"), HasSubstr("1 poses for 3 images"));
}

TEST(IclViews, RealFramesOfSlambookNeedACamera) {
  BOLE_NEEDS_SHARED("rgbd_slambook5");
  const auto folder = shared("rgbd_slambook5");
  EXPECT_EQ(layout_of(folder), "icl");
  EXPECT_THAT(refusal(folder), HasSubstr("icl_nuim"));
  const auto [views, report] = opened(folder, {.camera = "icl_nuim"});
  EXPECT_EQ(views->size(), 5u);
  EXPECT_EQ(views->given_poses().poses.size(), 5u);
  EXPECT_DOUBLE_EQ(views->camera(0).color.fy, -480);
  EXPECT_DOUBLE_EQ(views->camera(0).depth_scale, 5000);
  EXPECT_TRUE(has_finding(report, "axes_left_handed"));
  EXPECT_TRUE(has_finding(opened(folder, {.camera = "481.2,-480,319.5,239.5"}).report, "depth_scale_assumed"));
}

// --- 7-Scenes and ScanNet

TEST(SceneViews, SevenScenesWithLostViews) {
  const TempDir dir;
  for (int i = 0; i < 4; ++i) {
    const auto stem = "frame-" + six_digits(i);
    write_color(dir / (stem + ".color.png"), picture(i));
    write_depth(dir / (stem + ".depth.png"), slope(i));
    write_file(dir / (stem + ".pose.txt"), matrix_text(pose_number(i)));
  }
  write_file(dir / "camera-intrinsics.txt", "60 0 31.5\n0 61 23.5\n0 0 1\n");
  EXPECT_EQ(layout_of(dir.path()), "7scenes");
  const auto [views, report] = opened(dir.path());
  EXPECT_TRUE(report.findings.empty()) << report.findings.front().text;
  expect_poses(*views, {0, 1, 2, 3});
  EXPECT_EQ(views->name(2), "frame-000002");
  EXPECT_EQ(views->camera(0).color, small_camera().color);
  write_file(dir / "frame-000001.pose.txt", "-inf nan nan 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  write_file(dir / "frame-000002.pose.txt", "1 0 0");
  fs::remove(dir / "frame-000003.pose.txt");
  const auto damaged = opened(dir.path()).report;
  EXPECT_THAT(finding_text(damaged, "views_lost"), HasSubstr("frame-000001"));
  EXPECT_THAT(finding_text(damaged, "poses_damaged"), HasSubstr("frame-000002"));
  EXPECT_THAT(finding_text(damaged, "views_without_pose"), HasSubstr("frame-000003"));
}

TEST(SceneViews, RealFramesOfSevenScenes) {
  BOLE_NEEDS_SHARED("rgbd_7scenes300");
  const auto [views, report] = opened(shared("rgbd_7scenes300"), {.every = 30});
  EXPECT_EQ(views->size(), 10u);
  EXPECT_EQ(views->given_poses().poses.size(), 10u);
  EXPECT_DOUBLE_EQ(views->camera(0).color.fx, 585);
  View view;
  views->read(0, view);
  std::size_t seen = 0;
  for (const float z : view.depth.values) {
    ASSERT_LT(z, 60);  // 65535 is no depth
    seen += z > 0;
  }
  EXPECT_GT(seen, view.depth.values.size() / 2);
}

TEST(SceneViews, ScanNetHasTwoCameras) {
  const TempDir dir;
  for (int i = 0; i < 3; ++i) {
    write_color(dir / ("color/" + std::to_string(i) + ".jpg"), picture(i));
    write_depth(dir / ("depth/" + std::to_string(i) + ".png"), slope(i, 32, 24));
    write_file(dir / ("pose/" + std::to_string(i) + ".txt"), matrix_text(pose_number(i)));
  }
  write_file(dir / "intrinsic/intrinsic_color.txt", "60 0 31.5 0\n0 61 23.5 0\n0 0 1 0\n0 0 0 1\n");
  write_file(dir / "intrinsic/intrinsic_depth.txt", "30 0 15.5 0\n0 30 11.5 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_EQ(layout_of(dir.path()), "scannet");
  const auto [views, report] = opened(dir.path());
  expect_poses(*views, {0, 1, 2});
  EXPECT_EQ(views->camera(0).color.width, view_width);
  EXPECT_EQ(views->camera(0).of_depth().width, 32);
  EXPECT_EQ(report.counts.at("views_with_depth"), 3);
}

// --- RealSense

TEST(RealSenseViews, ExportsWithTheirMetadata) {
  const TempDir dir;
  for (int i = 0; i < 3; ++i) {
    const auto time = std::to_string(1551257880762 + 33 * i) + ".5";
    write_color(dir / ("walk_Color_" + time + ".png"), picture(i));
    const auto depth_time = std::to_string(1551257880765 + 33 * i) + ".25";
    write_depth(dir / ("walk_Depth_" + depth_time + ".png"), slope(i, 32, 24));
    write_file(dir / ("walk_Color_metadata_" + time + ".txt"),
               "Stream,Color\nResolution x,64\nResolution y,48\nFx,60\nFy,61\nPPx,31.5\nPPy,23.5\n");
    write_file(dir / ("walk_Depth_metadata_" + depth_time + ".txt"),
               "Stream,Depth\nResolution_x,32\nResolution_y,24\nFx,30\nFy,30\nPPx,15.5\nPPy,11.5\n");
  }
  EXPECT_EQ(layout_of(dir.path()), "realsense");
  const auto [views, report] = opened(dir.path());
  EXPECT_EQ(views->size(), 3u);
  EXPECT_NEAR(views->time_s(1) - views->time_s(0), 0.033, 1e-6);
  EXPECT_EQ(views->camera(0).color, small_camera().color);
  EXPECT_EQ(views->camera(0).of_depth().fx, 30);
  EXPECT_EQ(report.counts.at("views_with_depth"), 3);
  EXPECT_TRUE(has_finding(report, "depth_to_color_missing"));
}

TEST(RealSenseViews, DepthInColoursIsRefused) {
  const TempDir dir;
  write_color(dir / "walk_Color_1.png", picture(0));
  write_color(dir / "walk_Depth_1.png", picture(1));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("camera.json"));
  EXPECT_THAT(refusal(dir.path(), {.camera = "60,61,31.5,23.5"}), HasSubstr("one channel of 16 bits"));
}

// --- NeRF

std::string transforms_text(const std::string& head, const std::vector<int>& numbers, const std::string& folder) {
  std::string text = "{" + head + R"(, "frames": [)";
  for (const int i : numbers) {
    const auto opengl = from_opengl(pose_number(i)).matrix().eval();  // turning twice gives the pose back
    std::ostringstream out;
    out.precision(17);
    out << R"({"file_path": ")" << folder << "r_" << i << R"(", "transform_matrix": [)";
    for (int row = 0; row < 4; ++row) {
      out << (row == 0 ? "[" : ", [");
      for (int column = 0; column < 4; ++column) out << (column == 0 ? "" : ", ") << opengl(row, column);
      out << "]";
    }
    out << "]}";
    text += (i == numbers.front() ? "" : ", ") + out.str();
  }
  return text + "]}";
}

TEST(NerfViews, PosesAreTurnedAndSplitsKept) {
  const TempDir dir;
  for (const int i : {0, 1, 2}) write_color(dir / ("train/r_" + std::to_string(i) + ".png"), picture(i));
  for (const int i : {3, 4}) write_color(dir / ("test/r_" + std::to_string(i) + ".png"), picture(i));
  const std::string angle = R"("camera_angle_x": 0.8)";
  write_file(dir / "transforms_test.json", transforms_text(angle, {3, 4}, "./test/"));
  write_file(dir / "transforms_train.json", transforms_text(angle, {0, 1, 2, 9}, "./train/"));
  EXPECT_EQ(layout_of(dir.path()), "nerf");
  const auto [views, report] = opened(dir.path());
  expect_poses(*views, {0, 1, 2, 3, 4});
  EXPECT_EQ(views->split(0), "train");
  EXPECT_EQ(views->split(4), "test");
  EXPECT_NEAR(views->camera(0).color.fx, view_width / 2.0 / std::tan(0.4), 1e-9);
  EXPECT_DOUBLE_EQ(views->camera(0).color.cx, 31.5);
  EXPECT_THAT(finding_text(report, "colour_missing"), HasSubstr("train/r_9"));
  EXPECT_TRUE(has_finding(report, "scale_unknown"));
  EXPECT_EQ(opened(dir / "transforms_test.json").views->size(), 2u);
}

TEST(NerfViews, DistortionAndFocalLengthsAreRead) {
  const TempDir dir;
  write_color(dir / "r_0.png", picture(0));
  const std::string head =
      R"("camera_model": "OPENCV", "w": 64, "h": 48, "fl_x": 60, "fl_y": 61, "cx": 32, "cy": 24, "k1": 0.01, "p2": 0.001)";
  write_file(dir / "transforms.json", transforms_text(head, {0}, ""));
  const auto views = opened(dir.path()).views;
  auto expected = small_camera().color;
  expected.distortion = {0.01, 0, 0, 0.001, 0};
  EXPECT_EQ(views->camera(0).color, expected);
}

TEST(NerfViews, FilesThatLieAreRefused) {
  const TempDir dir;
  write_color(dir / "r_0.png", picture(0));
  const auto with = [&](const std::string& text) {
    write_file(dir / "transforms.json", text);
    return refusal(dir.path());
  };
  EXPECT_THAT(with(""), HasSubstr("the file is empty"));
  EXPECT_THAT(with(R"({"camera_angle_x": 0.8, "frames": [{"file_path")"), HasSubstr("no JSON object"));
  EXPECT_THAT(with(R"({"camera_angle_x": 0.8, "frames": []})"), HasSubstr("no views"));
  EXPECT_THAT(with(transforms_text(R"("camera_angle_x": 4)", {0}, "")), HasSubstr("below pi"));
  EXPECT_THAT(with(transforms_text(R"("camera_model": "OPENCV_FISHEYE", "fl_x": 60)", {0}, "")),
              HasSubstr("Undistort the images first"));
  EXPECT_THAT(with(R"({"fl_x": 60, "frames": [{"file_path": "r_0"}]})"), HasSubstr("transform_matrix"));
  EXPECT_THAT(with(transforms_text(R"("fl_x": 1e300, "w": 1e300, "h": 4)", {0}, "")), HasSubstr("pixels"));
  write_file(
      dir / "transforms.json",
      R"({"fl_x": 60, "frames": [{"file_path": "r_0", "transform_matrix": [[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})");
  EXPECT_TRUE(has_finding(opened(dir.path()).report, "poses_damaged"));
}

TEST(NerfViews, RealLegoHasMasksOfItsAlpha) {
  BOLE_NEEDS_SHARED("nerf_lego400");
  const auto [views, report] = opened(shared("nerf_lego400"));
  ASSERT_EQ(views->size(), 110u);
  EXPECT_EQ(report.facts.at("splits"), "train 100, test 10");
  View view;
  views->read(0, view);
  ASSERT_FALSE(view.mask.empty());
  EXPECT_EQ(view.mask.at(0, 0), 0);
  EXPECT_EQ(view.color.at(0, 0, 1), 255);  // on white
  // The cameras stand about the model and look at it: Blender's z is up.
  for (std::size_t i = 0; i < views->size(); ++i) {
    const auto pose = pose_of_view(views->given_poses(), views->time_s(i));
    ASSERT_TRUE(pose);
    const Eigen::Vector3d ahead = pose->linear().col(2);
    EXPECT_LT((pose->translation() + 4.03 * ahead).norm(), 0.2);
  }
}

// --- ROMI

TEST(RomiViews, RealPlantsHaveExactOrApproximatePoses) {
  BOLE_NEEDS_SHARED("plants_romi");
  const auto exact = opened(shared("plants_romi/virtual_plant"));
  ASSERT_EQ(exact.views->size(), 18u);
  EXPECT_EQ(exact.views->given_poses().poses.size(), 18u);
  EXPECT_NEAR(exact.views->camera(0).color.cx, 447.5, 1e-9);
  EXPECT_NEAR(exact.views->given_poses().poses[0].T_target_sensor.translation().x(), -0.077, 1e-6);
  EXPECT_THAT(refusal(shared("plants_romi/real_plant")), HasSubstr("the camera of the views"));
  const auto rough = opened(shared("plants_romi/real_plant"), {.camera = "1100,1100,719.5,539.5"});
  EXPECT_EQ(rough.views->size(), 60u);
  EXPECT_TRUE(has_finding(rough.report, "poses_approximate"));
  // All of them look at the middle of the circle of 300 mm.
  for (const auto& pose : rough.views->given_poses().poses) {
    const Eigen::Vector3d aim = pose.T_target_sensor.translation() + 0.3 * pose.T_target_sensor.linear().col(2);
    EXPECT_LT((aim - Eigen::Vector3d(0.375, 0.375, 0.08)).norm(), 0.02);
  }
}

// --- Lists of poses

TEST(PoseLists, ShapesAreToldApart) {
  const auto list = [](const std::string& text) { return parse_pose_list(bytes_of(text), "poses.txt"); };
  EXPECT_EQ(list(quaternion_text(pose_number(1)) + quaternion_text(pose_number(2))).size(), 2u);
  const auto timed = list("12.5 " + quaternion_text(pose_number(1)));
  EXPECT_EQ(timed.front().key, 12.5);
  EXPECT_TRUE(timed.front().pose.isApprox(pose_number(1)));
  EXPECT_TRUE(list(matrix_text(pose_number(3)) + matrix_text(pose_number(4)))[1].pose.isApprox(pose_number(4)));
  EXPECT_THAT(error_of([&] { list(""); }), HasSubstr("holds no poses"));
  EXPECT_THAT(error_of([&] { list("1 2 3 4 5\n"); }), HasSubstr("lines of 5 numbers"));
  EXPECT_THAT(error_of([&] { list("0 0 0 1 1 1 1\n"); }), HasSubstr("length 2"));
  EXPECT_THAT(error_of([&] { list("1 0 0 0\n0 1 0 0\n"); }), HasSubstr("cut off"));
  EXPECT_THAT(error_of([&] { list("moon\n"); }), HasSubstr("'moon'"));
}

}  // namespace
}  // namespace bole::io
