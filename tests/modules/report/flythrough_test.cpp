// Films of a survey: frames, the video, and what is missing for them.
#include <unistd.h>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "render/beside/draped_ground.h"
#include "render/offscreen/offscreen.h"
#include "report/flight/flythrough.h"
#include "report/flight/video.h"

namespace bole::report {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Pixels of a frame where this band stands out: 0 red, 2 blue.
int pixels_like(const fs::path& frame, int band) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> png(GDALDataset::FromHandle(GDALOpen(frame.c_str(), GA_ReadOnly)));
  if (!png || png->GetRasterCount() < 3) return -1;
  const int w = png->GetRasterXSize(), h = png->GetRasterYSize();
  std::array<std::vector<std::uint8_t>, 3> rgb;
  for (int b = 0; b < 3; ++b) {
    rgb[b].resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    if (png->GetRasterBand(b + 1)->RasterIO(GF_Read, 0, 0, w, h, rgb[b].data(), w, h, GDT_Byte, 0, 0) != CE_None)
      return -1;
  }
  int n = 0;
  for (std::size_t i = 0; i < rgb[0].size(); ++i)
    n += rgb[band][i] > rgb[2 - band][i] + 60 && rgb[band][i] > rgb[1][i] + 60;
  return n;
}

class Flythrough : public testing::Test {
 protected:
  Flythrough() : path_(std::getenv("PATH")) {
    render::use_backend(render::Backend::automatic);
    folder_ = fs::path(testing::TempDir()) / ("flythrough_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "bin");
    setenv("PATH", (folder_ / "bin").c_str(), 1);  // no ffmpeg, unless a test puts one there
    PointCloud::Positions places;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j) places.emplace_back(0.25 * i, 0.25 * j, 0.02 * ((3 * i + j) % 5));
    for (int k = 0; k < 400; ++k)
      places.emplace_back(5 + 0.2 * std::cos(0.1 * k), 5 + 0.2 * std::sin(0.1 * k), 0.01 * k);
    cloud_ = PointCloud(std::move(places));
    for (int i = 0; i <= 10; ++i) {
      StampedPose pose;
      pose.time_s = i;
      pose.T_target_sensor.translation() = Eigen::Vector3d(1, 0.8 * i, 1.5);
      walk_.poses.push_back(pose);
    }
    options_.width = 96;
    options_.height = 54;
    options_.seconds = 0.5;
    options_.frame_rate = 8;
  }
  ~Flythrough() override {
    setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  Report make(const fs::path& to, const bole::Run& run = {}) {
    render::MapData data;
    data.points = &cloud_;
    data.trajectory = &walk_;
    return write_flythrough(data, flight_of(options_, &walk_, {}), options_, to, run);
  }
  void install_ffmpeg(const std::string& script) {
    const auto program = folder_ / "bin" / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(program, fs::perms::owner_all);
  }

  std::string path_;
  fs::path folder_;
  PointCloud cloud_;
  Trajectory walk_;
  FlythroughOptions options_;
};

TEST_F(Flythrough, MakesTheSameFramesOfTheSameInputs) {
  const auto report = make(folder_ / "a");
  make(folder_ / "b");
  EXPECT_EQ(report.counts.at("frames"), 4);
  for (const char* name : {"frame_00001.png", "frame_00002.png", "frame_00003.png", "frame_00004.png"}) {
    const auto bytes = bytes_of(folder_ / "a/flythrough" / name);
    EXPECT_GT(bytes.size(), 200U);
    EXPECT_EQ(bytes, bytes_of(folder_ / "b/flythrough" / name)) << name;
  }
  EXPECT_NE(bytes_of(folder_ / "a/flythrough/frame_00001.png"), bytes_of(folder_ / "a/flythrough/frame_00004.png"));
  EXPECT_THAT(report.warnings, testing::ElementsAre(testing::HasSubstr("ffmpeg is not in PATH")));
  EXPECT_FALSE(fs::exists(folder_ / "a/flythrough.mp4"));
}

TEST_F(Flythrough, AMapLiesBelowTheSurvey) {
  auto red = std::make_shared<render::GroundPicture>();
  red->width = red->height = 8;
  for (int i = 0; i < 64; ++i) red->rgba.insert(red->rgba.end(), {255, 0, 0, 255});
  const render::GroundCorners corners{Eigen::Vector2d(-10, 20), {20, 20}, {20, -10}, {-10, -10}};
  render::MapData data;
  data.points = &cloud_, data.trajectory = &walk_;
  Raster hill;
  hill.origin = {0, 0}, hill.nx = hill.ny = 10;
  hill.values.assign(100, 0.0F);
  for (const int iy : {6, 7}) hill.at(1, iy) = 12;  // higher than the eye, which walks there
  std::map<std::string, int> red_pixels;
  for (const auto& [name, places] : {std::pair{"flat", render::flat_ground(corners, 0)},
                                     std::pair{"draped", render::draped_ground(corners, hill, 0)}}) {
    write_flythrough(data, flight_of(options_, &walk_, {}), options_, folder_ / name, {},
                     {{}, render::PlacedPicture{red, places, 1}});
    red_pixels[name] = pixels_like(folder_ / name / "flythrough/frame_00001.png", 0);
  }
  make(folder_ / "none");
  EXPECT_EQ(pixels_like(folder_ / "none/flythrough/frame_00001.png", 0), 0);
  EXPECT_GT(red_pixels["flat"], 500);
  EXPECT_GT(red_pixels["draped"], 500);
  EXPECT_GT(red_pixels["draped"], red_pixels["flat"] + 300);
}

TEST_F(Flythrough, ACloudBesideTheSurveyIsInItsColour) {
  make(folder_ / "a");
  PointCloud::Positions wall;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) wall.emplace_back(0.1 * i, 5, 0.05 * j);
  const PointCloud other(std::move(wall));
  render::MapData data;
  data.points = &cloud_, data.trajectory = &walk_;
  std::vector<std::string> films;
  for (const char* color : {"#ff0000", "#0000ff", "z"}) {
    options_.beside_color = color;
    write_flythrough(data, flight_of(options_, &walk_, {}), options_, folder_ / color, {},
                     {{beside_cloud(other, options_)}, {}});
    films.push_back(bytes_of(folder_ / color / "flythrough/frame_00001.png"));
    EXPECT_NE(films.back(), bytes_of(folder_ / "a/flythrough/frame_00001.png")) << color;
  }
  EXPECT_NE(films[1], films[2]);
  EXPECT_GT(pixels_like(folder_ / "#ff0000/flythrough/frame_00001.png", 0), 50);
  EXPECT_EQ(pixels_like(folder_ / "#ff0000/flythrough/frame_00001.png", 2), 0);
  EXPECT_GT(pixels_like(folder_ / "#0000ff/flythrough/frame_00001.png", 2), 50);
  options_.beside_color = "#ff00";
  EXPECT_THROW(
      try { beside_cloud(other, options_); } catch (const Error& e) {
        EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("'#ff00'"), testing::HasSubstr("z or a colour")));
        throw;
      },
      Error);
}

TEST_F(Flythrough, TheStageTakesACloudBesideTheSurveyThatIsNear) {
  const auto stage = flythrough_stage();
  PointCloud other({{2, 5, 0}, {3, 5, 1}, {4, 5, 2}});
  const auto film = [&](const fs::path& to) {
    DataSet inputs;
    inputs.set("points", cloud_), inputs.set("trajectory", walk_), inputs.set("beside", other);
    bole::Run run;
    run.output_dir = to;
    OptionSet options(*stage.options);
    for (const auto& [name, value] : {std::pair("width", "96"),
                                      {"height", "54"},
                                      {"seconds", "0.1"},
                                      {"point_size", "20"},
                                      {"beside_color", "#ff0000"}})
      options.set_text(name, value);
    fs::create_directories(to);
    stage.run(inputs, options, run);
  };
  film(folder_ / "near");
  EXPECT_GT(pixels_like(folder_ / "near/flythrough/frame_00001.png", 0), 0);
  other.origin = {500000, 5400000, 0};
  EXPECT_THROW(
      try { film(folder_ / "far"); } catch (const Error& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("km away"));
        throw;
      },
      Error);
}

TEST_F(Flythrough, AShorterFilmLeavesNoFramesOfALongerOne) {
  make(folder_ / "a");
  options_.seconds = 0.25;
  make(folder_ / "a");
  EXPECT_TRUE(fs::exists(folder_ / "a/flythrough/frame_00002.png"));
  EXPECT_FALSE(fs::exists(folder_ / "a/flythrough/frame_00003.png"));
}

TEST_F(Flythrough, MakesAVideoWhereFfmpegIs) {
  install_ffmpeg("for last; do :; done\necho \"$@\" > \"$last\"");
  const auto report = make(folder_ / "a");
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_THAT(bytes_of(folder_ / "a/flythrough.mp4"),
              testing::AllOf(testing::HasSubstr("-framerate 8"), testing::HasSubstr("flythrough/frame_%05d.png")));
  install_ffmpeg("echo no such codec >&2\nexit 1");
  EXPECT_THROW(
      try { make(folder_ / "b"); } catch (const Error& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("no such codec"));
        throw;
      },
      Error);
  EXPECT_FALSE(fs::exists(folder_ / "b/flythrough.mp4"));
  EXPECT_TRUE(fs::exists(folder_ / "b/flythrough/frame_00004.png"));
}

TEST_F(Flythrough, IsCancelledBetweenFramesAndWhileTheVideoIsMade) {
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  run.progress = [&](double, std::string_view what) {
    if (what == "frame 2 of 4") stop.request_stop();
  };
  EXPECT_THROW(make(folder_ / "a", run), Error);
  EXPECT_TRUE(fs::exists(folder_ / "a/flythrough/frame_00001.png"));
  EXPECT_FALSE(fs::exists(folder_ / "a/flythrough/frame_00004.png"));
  install_ffmpeg("while :; do :; done");
  std::stop_source later;
  run.cancel = later.get_token();
  run.progress = [&](double, std::string_view what) {
    if (what == "video") later.request_stop();
  };
  EXPECT_THROW(make(folder_ / "b", run), Error);
}

TEST_F(Flythrough, SaysWhatItLacks) {
  EXPECT_THROW(flight_of(options_, nullptr, {}), Error);
  options_.course = FlightCourse::views;
  EXPECT_THROW(flight_of(options_, &walk_, {}), Error);
  options_.course = FlightCourse::walk;
  cloud_ = {};
  EXPECT_THROW(make(folder_ / "a"), Error);
}

}  // namespace
}  // namespace bole::report
