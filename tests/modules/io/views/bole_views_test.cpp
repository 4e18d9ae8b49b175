#include <gmock/gmock.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "camera/camera_json.h"
#include "io/core/views/open_views.h"
#include "view_folder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

namespace fs = std::filesystem;

TEST(BoleViews, AFolderIsReadWithDepthPosesAndTimes) {
  const TempDir dir;
  write_view_folder(dir.path(), 5);
  const auto [views, report] = opened(dir.path());
  ASSERT_EQ(views->size(), 5u);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(views->name(3), "000003");
  EXPECT_DOUBLE_EQ(views->time_s(3), 3 / 30.0);
  EXPECT_TRUE(views->has_depth());
  EXPECT_FALSE(views->board());
  EXPECT_EQ(views->camera(0).color, small_camera().color);
  ASSERT_EQ(views->given_poses().poses.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    const auto pose = pose_of_view(views->given_poses(), views->time_s(static_cast<std::size_t>(i)));
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->isApprox(pose_number(i), 1e-5));
  }
  View view;
  views->read(3, view);
  EXPECT_EQ(view.color.values, picture(3).values);
  EXPECT_NEAR(view.depth.at(10, 10), slope(3).at(10, 10), 6e-4);
  EXPECT_EQ(view.depth.at(0, 0), 0);
  EXPECT_TRUE(view.mask.empty());
  views->read(3, view, {.color = false, .depth = true, .mask = false});
  EXPECT_TRUE(view.color.empty());
  EXPECT_FALSE(view.depth.empty());
  EXPECT_NEAR(report.metrics.at("median_depth").value, 0.72, 0.02);
  EXPECT_THAT(views->description(), HasSubstr("5 views, 64 x 48, depth 64 x 48"));
}

TEST(BoleViews, ManyThreadsReadTheSameImages) {
  const TempDir dir;
  write_view_folder(dir.path(), 6);
  const auto views = opened(dir.path()).views;
  std::vector<int> right(60, 0);
  const auto read = [&](std::size_t first) {
    View view;
    for (std::size_t i = first; i < right.size(); i += 4) {
      views->read(i % 6, view);
      right[i] = view.color.values == picture(static_cast<int>(i % 6)).values;
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < 4; ++t) threads.emplace_back(read, t);
  threads.clear();
  EXPECT_EQ(std::count(right.begin(), right.end(), 1), 60);
}

TEST(BoleViews, JpegIsReadToo) {
  const TempDir dir;
  write_color(dir / "color/000000.jpg", picture(0));
  write_camera_file(dir / "camera.json", small_camera());
  const auto [views, report] = opened(dir.path());
  View view;
  views->read(0, view);
  EXPECT_EQ(view.color.width, view_width);
  EXPECT_FALSE(views->has_depth());
  EXPECT_TRUE(view.depth.empty());
  EXPECT_THAT(finding_text(report, "depth_absent"), HasSubstr("does not exist"));
}

TEST(BoleViews, MissingImagesAreToldAndTheOthersKeepTheirTimes) {
  const TempDir dir;
  write_view_folder(dir.path(), 10);
  fs::remove(dir / "color/000004.png");
  fs::remove(dir / "color/000005.png");
  fs::remove(dir / "depth/000007.png");
  const auto [views, report] = opened(dir.path());
  EXPECT_EQ(views->size(), 8u);
  EXPECT_DOUBLE_EQ(views->time_s(4), 6 / 30.0);
  EXPECT_THAT(finding_text(report, "views_missing"), HasSubstr("2 images are missing"));
  EXPECT_THAT(finding_text(report, "depth_missing"), HasSubstr("first: 000007"));
  EXPECT_THAT(finding_text(report, "depth_without_colour"), HasSubstr("2 depth images"));
  View view;
  views->read(5, view);
  EXPECT_EQ(views->name(5), "000007");
  EXPECT_TRUE(view.depth.empty());
  EXPECT_EQ(views->given_poses().poses.size(), 8u);
}

TEST(BoleViews, ASequenceOfEveryFifthImageHasNoGaps) {
  const TempDir dir;
  for (const int i : {0, 5, 10, 15}) write_view(dir.path(), i);
  write_camera_file(dir / "camera.json", small_camera());
  EXPECT_FALSE(has_finding(opened(dir.path()).report, "views_missing"));
  fs::remove(dir / "color/000010.png");
  EXPECT_THAT(finding_text(opened(dir.path()).report, "views_missing"), HasSubstr("1 images are missing"));
}

TEST(BoleViews, DamagedImagesAndOtherSizesAreLeftOut) {
  const TempDir dir;
  write_view_folder(dir.path(), 6);
  write_file(dir / "color/000001.png", "no image");
  write_file(dir / "color/000002.png", "");
  write_color(dir / "color/000003.png", picture(3, 32, 24));
  write_depth(dir / "depth/000004.png", slope(4, 32, 24));
  write_mask(dir / "depth/000005.png", MaskImage(view_width, view_height, 1, 9));
  const auto [views, report] = opened(dir.path());
  EXPECT_EQ(views->size(), 3u);
  EXPECT_EQ(report.counts.at("views"), 3);
  EXPECT_EQ(report.counts.at("views_with_depth"), 1);
  EXPECT_THAT(finding_text(report, "colour_damaged"), HasSubstr("2 colour images"));
  EXPECT_THAT(finding_text(report, "colour_size"), HasSubstr("000003 is 32 x 24, the camera 64 x 48"));
  EXPECT_THAT(finding_text(report, "depth_size"), HasSubstr("000004"));
  EXPECT_THAT(finding_text(report, "depth_bits"), HasSubstr("1 of 8 bits"));
}

TEST(BoleViews, WhereNothingFitsTheErrorSaysWhy) {
  const TempDir dir;
  write_view_folder(dir.path(), 3);
  auto camera = small_camera();
  camera.color.width = 1280;
  camera.color.cx = 640;
  write_camera_file(dir / "camera.json", camera);
  EXPECT_THAT(refusal(dir.path()), HasSubstr("3 colour images are of another size"));
  write_camera_file(dir / "camera.json", small_camera());
  for (int i = 0; i < 3; ++i)
    write_mask(dir / ("depth/" + six_digits(i) + ".png"), MaskImage(view_width, view_height, 1, 9));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("without one channel of 16 bits"));
  for (int i = 0; i < 3; ++i) write_depth(dir / ("depth/" + six_digits(i) + ".png"), slope(i, 32, 24));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("need the entries depth and depth_to_color"));
}

TEST(BoleViews, ADepthCameraOfItsOwn) {
  const TempDir dir;
  auto camera = small_camera();
  camera.depth = CameraModel{.width = 32, .height = 24, .fx = 30, .fy = 30, .cx = 15.5, .cy = 11.5};
  camera.T_color_depth.translation() = Eigen::Vector3d(0.015, 0, 0);
  camera.depth_scale = 5000;
  write_color(dir / "color/000000.png", picture(0));
  write_depth(dir / "depth/000000.png", slope(0, 32, 24), 5000);
  write_camera_file(dir / "camera.json", camera);
  const auto [views, report] = opened(dir.path());
  EXPECT_TRUE(report.findings.empty());
  EXPECT_TRUE(views->camera(0).T_color_depth.isApprox(camera.T_color_depth));
  EXPECT_EQ(views->camera(0).of_depth(), *camera.depth);
  View view;
  views->read(0, view);
  EXPECT_NEAR(view.depth.at(10, 10), 0.5, 2e-4);
}

TEST(BoleViews, ADepthScaleThatCannotBeIsTold) {
  const TempDir dir;
  write_view_folder(dir.path(), 3);
  EXPECT_THAT(finding_text(opened(dir.path(), {.depth_scale = 10}).report, "depth_scale_suspect"),
              HasSubstr("10 units per metre"));
  EXPECT_TRUE(has_finding(opened(dir.path(), {.depth_scale = 100000}).report, "depth_scale_suspect"));
  write_file(dir / "camera.json", R"({"width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5})");
  EXPECT_TRUE(has_finding(opened(dir.path()).report, "depth_scale_assumed"));
  write_file(dir / "camera.json",
             R"({"width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5,"depth_scale":0.001})");
  EXPECT_THAT(refusal(dir.path()), HasSubstr("0.001 is 1000"));
}

TEST(BoleViews, PosesOfOtherTimesAreNotUsed) {
  const TempDir dir;
  write_view_folder(dir.path(), 40);
  Trajectory poses;
  for (int i = 0; i < 40; ++i) poses.poses.push_back({static_cast<double>(i), pose_number(i)});  // numbers, not times
  write_tum(dir / "poses.tum", poses);
  const auto [views, report] = opened(dir.path());
  EXPECT_TRUE(views->given_poses().empty());
  EXPECT_THAT(finding_text(report, "poses_other_times"), HasSubstr("2 of its 40 poses"));
  write_file(dir / "poses.tum", "0 0 0 0 0 0 0\n");
  EXPECT_THAT(finding_text(opened(dir.path()).report, "poses_damaged"), HasSubstr("line 1"));
}

TEST(BoleViews, PosesOfSomeViewsAreUsedAndTheOthersTold) {
  const TempDir dir;
  write_view_folder(dir.path(), 6);
  Trajectory poses;
  for (const int i : {1, 2, 4, 9}) poses.poses.push_back({i / 30.0 + 4e-5, pose_number(i)});
  write_tum(dir / "poses.tum", poses);
  const auto [views, report] = opened(dir.path());
  EXPECT_EQ(views->given_poses().poses.size(), 3u);
  EXPECT_TRUE(pose_of_view(views->given_poses(), views->time_s(4)));
  EXPECT_FALSE(pose_of_view(views->given_poses(), views->time_s(3)));
  EXPECT_THAT(finding_text(report, "views_without_pose"), HasSubstr("3 views have no pose"));
  EXPECT_THAT(finding_text(report, "poses_without_view"), HasSubstr("1 poses"));
}

TEST(BoleViews, ViewsAreSelected) {
  const TempDir dir;
  write_view_folder(dir.path(), 10);
  EXPECT_EQ(opened(dir.path(), {.every = 3}).views->size(), 4u);
  const auto views = opened(dir.path(), {.every = 2, .max_views = 2}).views;
  ASSERT_EQ(views->size(), 2u);
  EXPECT_EQ(views->name(1), "000004");
  EXPECT_EQ(views->given_poses().poses.size(), 2u);
}

TEST(BoleViews, TheMatIsReadAndItsLiesRefused) {
  const TempDir dir;
  write_view_folder(dir.path(), 1);
  const auto with = [&](const std::string& text) {
    write_file(dir / "mat.json", text);
    return refusal(dir.path());
  };
  EXPECT_EQ(with(R"({"type": "charuco", "dictionary": "DICT_4X4_50", "squares": [11, 9], "square_mm": 30,
                     "marker_mm": 22, "first_square": "black"})"),
            "no error");
  const auto board = opened(dir.path()).views->board();
  ASSERT_TRUE(board);
  EXPECT_EQ(board->columns, 11);
  EXPECT_EQ(board->rows, 9);
  EXPECT_DOUBLE_EQ(board->square, 0.03);
  EXPECT_DOUBLE_EQ(board->marker, 0.022);
  EXPECT_TRUE(board->first_square_black);
  EXPECT_THAT(with(R"({"squares": [11, 9], "square_mm": 0.03, "marker_mm": 0.022})"), HasSubstr("Metres times 1000"));
  EXPECT_THAT(with(R"({"squares": [11, 9], "square_mm": 30, "marker_mm": 33})"), HasSubstr("smaller than the squares"));
  EXPECT_THAT(with(R"({"squares": [21, 19], "square_mm": 30, "marker_mm": 22})"), HasSubstr("DICT_4X4_50 has 50"));
  EXPECT_THAT(with(R"({"squares": [11], "square_mm": 30, "marker_mm": 22})"), HasSubstr("columns and rows"));
  EXPECT_THAT(with(R"({"dictionary": "DICT_9X9", "squares": [11, 9], "square_mm": 30, "marker_mm": 22})"),
              HasSubstr("a dictionary of OpenCV"));
  EXPECT_THAT(with(R"({"type": "moon", "squares": [11, 9], "square_mm": 30})"), HasSubstr("chessboard"));
  EXPECT_THAT(with(R"({"squares": [11, 9], "square_mm")"), HasSubstr("no JSON object"));
  EXPECT_EQ(with(R"({"type": "chessboard", "squares": [11, 9], "square_mm": 30})"), "no error");
  EXPECT_EQ(opened(dir.path()).views->board()->marker, 0);
}

TEST(BoleViews, CameraFilesThatLieAreRefused) {
  const TempDir dir;
  write_view_folder(dir.path(), 1);
  const auto with = [&](const std::string& text) {
    write_file(dir / "camera.json", text);
    return refusal(dir.path());
  };
  EXPECT_THAT(with(""), HasSubstr("the file is empty"));
  EXPECT_THAT(with(R"({"width": 64, )"), HasSubstr("no JSON object"));
  EXPECT_THAT(with(R"([1, 2])"), HasSubstr("no JSON object"));
  EXPECT_THAT(with(std::string(100000, '[')), HasSubstr("no JSON object"));
  EXPECT_THAT(with(R"({"width": 64, "height": 48, "fx": 60, "fy": 61, "cx": 31.5})"), HasSubstr("'cy' is missing"));
  EXPECT_THAT(with(R"({"width": 64.5, "height": 48, "fx": 60, "fy": 61, "cx": 31.5, "cy": 23.5})"),
              HasSubstr("a whole number"));
  EXPECT_THAT(with(R"({"width": 64, "height": 48, "fx": 0, "fy": 61, "cx": 31.5, "cy": 23.5})"), HasSubstr("fx"));
  EXPECT_THAT(with(R"({"width": 64, "height": 48, "fx": "60", "fy": 61, "cx": 31.5, "cy": 23.5})"),
              HasSubstr("a number"));
  EXPECT_THAT(
      with(R"({"width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5,"distortion":[0,0,0,0,0,0.1,0.1,0.2]})"),
      HasSubstr("8 numbers"));
  const std::string color = R"("width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5,"depth_scale":1000)";
  EXPECT_THAT(with("{" + color + R"(,"depth":{"width":64}})"), HasSubstr("depth"));
  EXPECT_THAT(
      with("{" + color + R"(,"depth":{)" + color + R"(},"depth_to_color":[[1,0,0,15],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"),
      HasSubstr("divide them by 1000"));
  EXPECT_THAT(
      with("{" + color + R"(,"depth":{)" + color + R"(},"depth_to_color":[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"),
      HasSubstr("no rotation"));
  write_file(dir / "camera.json", "{" + color + R"(,"depth":{)" + color + "}}");
  EXPECT_TRUE(has_finding(opened(dir.path()).report, "depth_to_color_missing"));
}

TEST(BoleViews, FoldersWithoutViewsAreRefusedInWords) {
  const TempDir dir;
  EXPECT_THAT(refusal(dir.path()), HasSubstr("is empty"));
  EXPECT_THAT(refusal(dir / "nowhere"), HasSubstr("there is no file or folder"));
  EXPECT_THAT(refusal(""), HasSubstr("Set the option folder"));
  write_view(dir.path(), 0);
  EXPECT_THAT(refusal(dir.path()), HasSubstr("color/ and no camera.json"));
  EXPECT_EQ(refusal(dir.path(), {.camera = "60,61,31.5,23.5"}), "no error");
  EXPECT_THAT(refusal(dir.path(), {.camera = "60,61,31.5"}), HasSubstr("four numbers"));
  fs::remove(dir / "color/000000.png");
  write_camera_file(dir / "camera.json", small_camera());
  EXPECT_THAT(refusal(dir.path()), HasSubstr("holds no images"));
  write_color(dir / "color/a.png", picture(0));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("none has a number"));
}

TEST(BoleViews, TheBiasOfTheDepthIsTakenOff) {
  const TempDir dir;
  write_view_folder(dir.path(), 1);
  write_file(dir / "camera.json", camera_json(small_camera(), std::vector<double>{0.002, -0.01}));
  const auto views = opened(dir.path()).views;
  View view;
  views->read(0, view);
  EXPECT_NEAR(view.depth.at(10, 10), 0.5 + 0.002 - 0.005, 6e-4);
  write_file(dir / "camera.json", camera_json(small_camera(), std::vector<double>{0.002, -0.5}));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("depth_bias"));
}

TEST(BoleViews, PicturesOfABoardNeedNoCamera) {
  const TempDir dir;
  write_color(dir / "b.png", picture(1));
  write_color(dir / "a.jpg", picture(0));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("camera.json"));
  const auto [views, report] = opened(dir.path(), {.camera = "unknown"});
  ASSERT_EQ(views->size(), 2u);
  EXPECT_EQ(views->name(0), "a");
  EXPECT_DOUBLE_EQ(views->camera(0).color.fx, 1.2 * view_width);
  EXPECT_TRUE(has_finding(report, "camera_unknown"));
}

TEST(BoleViews, TheFolderIsNamedByItsFilesToo) {
  const TempDir dir;
  write_view_folder(dir / "plant", 2);
  EXPECT_EQ(opened(dir / "plant/camera.json").views->size(), 2u);
  EXPECT_EQ(opened(dir / "plant/color/000001.png").views->size(), 2u);
  EXPECT_THAT(refusal(dir.path()), HasSubstr("its folder 'plant' does"));
}

TEST(BoleViews, AnImageThatChangesAfterwardsIsNamed) {
  const TempDir dir;
  write_view_folder(dir.path(), 4);
  const auto views = opened(dir.path()).views;
  const auto whole = file_text(dir / "color/000002.png");
  write_file(dir / "color/000002.png", whole.substr(0, whole.size() / 2));
  View view;
  EXPECT_THAT(error_of([&] { views->read(2, view); }), HasSubstr("000002.png"));
  EXPECT_THAT(error_of([&] { views->read(4, view); }), HasSubstr("0 to 3"));
}

TEST(BoleViews, DepthThatIsCutOffIsTold) {
  const TempDir dir;
  write_view_folder(dir.path(), 1);
  const auto whole = file_text(dir / "depth/000000.png");
  write_file(dir / "depth/000000.png", whole.substr(0, whole.size() - 30));
  EXPECT_THAT(finding_text(opened(dir.path()).report, "input_damaged"), HasSubstr("depth/000000.png"));
  write_depth(dir / "depth/000000.png", DepthImage(view_width, view_height));
  EXPECT_TRUE(has_finding(opened(dir.path()).report, "depth_empty"));
}

TEST(BoleViews, WritingACameraGivesItBack) {
  auto camera = small_camera();
  camera.color.distortion = {0.01, -0.02, 1e-4, 2e-4, 0.003};
  camera.depth = camera.color;
  camera.T_color_depth = Pose(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()));
  camera.T_color_depth.translation() = Eigen::Vector3d(0.05, 0, -0.001);
  Report report;
  const auto text = camera_text(camera);
  const auto again = parse_camera(bytes_of(text), true, report);
  EXPECT_EQ(again.color, camera.color);
  EXPECT_EQ(*again.depth, *camera.depth);
  EXPECT_TRUE(again.T_color_depth.isApprox(camera.T_color_depth, 1e-12));
  EXPECT_EQ(again.depth_scale, camera.depth_scale);
  const BoardFacts board{.columns = 11, .rows = 9, .square = 0.03, .marker = 0.022, .first_square_black = false};
  const auto board_again = parse_board(bytes_of(board_text(board)));
  EXPECT_EQ(board_again.columns, 11);
  EXPECT_EQ(board_again.marker, 0.022);
  EXPECT_FALSE(board_again.first_square_black);
}

}  // namespace
}  // namespace bole::io
