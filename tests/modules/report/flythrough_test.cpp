// Films of a survey: frames, the video, and what is missing for them.
#include <unistd.h>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "cloud/core/global_frame.h"
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

// Red, green and blue of all pixels, one band after the other; empty where it cannot be read.
std::vector<std::uint8_t> bands_of(const fs::path& frame) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> png(GDALDataset::FromHandle(GDALOpen(frame.c_str(), GA_ReadOnly)));
  if (!png || png->GetRasterCount() < 3) return {};
  const int w = png->GetRasterXSize(), h = png->GetRasterYSize();
  std::vector<std::uint8_t> bands(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  int order[] = {1, 2, 3};
  if (png->RasterIO(GF_Read, 0, 0, w, h, bands.data(), w, h, GDT_Byte, 3, order, 0, 0, 0, nullptr) != CE_None)
    return {};
  return bands;
}

// Pixels of a frame where this band stands out: 0 red, 2 blue.
int pixels_like(const fs::path& frame, std::size_t band) {
  const auto bands = bands_of(frame);
  if (bands.empty()) return -1;
  const std::size_t size = bands.size() / 3;
  int n = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const int value = bands[band * size + i];
    n += value > bands[(2 - band) * size + i] + 60 && value > bands[size + i] + 60;
  }
  return n;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "not refused";
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
  // Of one or two small frames.
  static Report run_stage(const DataSet& inputs, const std::map<std::string, std::string>& wanted, const fs::path& to) {
    const auto stage = flythrough_stage();
    bole::Run run;
    run.output_dir = to;
    OptionSet options(*stage.options);
    for (const auto& [name, value] : {std::pair("width", "96"), {"height", "54"}, {"seconds", "0.1"}})
      options.set_text(name, value);
    for (const auto& [name, value] : wanted) options.set_text(name, value);
    fs::create_directories(to);
    return stage.run(inputs, options, run).report;
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
  PointCloud other({{2, 5, 0}, {3, 5, 1}, {4, 5, 2}});
  const auto film = [&](const fs::path& to) {
    DataSet inputs;
    inputs.set("points", cloud_), inputs.set("trajectory", walk_), inputs.set("beside", other);
    run_stage(inputs, {{"point_size", "20"}, {"beside_color", "#ff0000"}}, to);
  };
  film(folder_ / "near");
  EXPECT_GT(pixels_like(folder_ / "near/flythrough/frame_00001.png", 0), 0);
  other.origin = {500000, 5400000, 0};
  EXPECT_THAT(refusal([&] { film(folder_ / "far"); }), testing::HasSubstr("km away"));
}

// The files of a survey with a place: the cloud is in its coordinate system, stems and walk are in the axes of the
// plot.
class FilmOfAPlace : public Flythrough {
 protected:
  FilmOfAPlace() {
    frame_.shift_global = {563210, 5412345, 431};
    frame_.A_global_local = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    frame_.crs_wkt = gdal_wkt(25832);
    frame_.heights_known = true;
    std::vector<float> heights;
    for (const auto& p : cloud_.positions()) heights.push_back(std::max(0.0F, p.z() - 0.1F));
    cloud_.set_column(arrays::height_above_ground, std::move(heights));
  }
  static std::string gdal_wkt(int epsg) {
    OGRSpatialReference crs;
    crs.importFromEPSG(epsg);
    char* text = nullptr;
    crs.exportToWkt(&text);
    std::string wkt(text);
    CPLFree(text);
    return wkt;
  }
  DataSet inputs(const PointCloud& points) const {
    DataSet inputs;
    inputs.set("points", points), inputs.set("trajectory", walk_);
    return inputs;
  }
  // Red, 60 m wide, about the plot.
  fs::path red_map() const {
    GDALAllRegister();
    const auto path = folder_ / "red.tif";
    const std::unique_ptr<GDALDataset> set(
        GDALDataset::FromHandle(GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), 60, 60, 3, GDT_Byte, nullptr)));
    double transform[6] = {563180, 1, 0, 5412375, 0, -1};
    set->SetGeoTransform(transform);
    OGRSpatialReference crs;
    crs.importFromEPSG(25832);
    set->SetSpatialRef(&crs);
    set->GetRasterBand(1)->Fill(255);
    return path;
  }
  std::string first(const char* name) const { return bytes_of(folder_ / name / "flythrough/frame_00001.png"); }

  GlobalFrame frame_;
};

// The points of these films stand on level ground, whose tint is that of a map of the terrain.
TEST_F(FilmOfAPlace, HasTheGroundBelowWhereItIsWished) {
  run_stage(inputs(cloud_), {}, folder_ / "without");
  run_stage(inputs(cloud_), {{"terrain", "true"}}, folder_ / "with");
  const auto plain = bands_of(folder_ / "without/flythrough/frame_00001.png"),
             ground = bands_of(folder_ / "with/flythrough/frame_00001.png");
  ASSERT_EQ(plain.size(), ground.size());
  std::size_t other = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) other += std::abs(plain[i] - ground[i]) > 16;
  EXPECT_GT(other, plain.size() / 20);
  auto bare = cloud_;
  bare.remove_column(arrays::height_above_ground.name);
  const auto report = run_stage(inputs(bare), {{"terrain", "true"}}, folder_ / "bare");
  EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("the terrain is not drawn")));
  run_stage(inputs(bare), {}, folder_ / "bare_without");
  EXPECT_EQ(first("bare"), first("bare_without"));
}

TEST_F(FilmOfAPlace, IsThatOfThePlotItself) {
  run_stage(inputs(cloud_), {}, folder_ / "plot");
  const auto global = to_global(cloud_, frame_, {});
  run_stage(inputs(global), {}, folder_ / "global");
  // Moved there and back the points lie within some micrometres of where they were.
  const auto here = bands_of(folder_ / "plot/flythrough/frame_00001.png"),
             back = bands_of(folder_ / "global/flythrough/frame_00001.png");
  ASSERT_FALSE(here.empty());
  std::size_t drawn = 0, other = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    drawn += here[i] < 240;
    other += std::abs(here[i] - back[i]) > 16;
  }
  EXPECT_GT(drawn, 200U);
  EXPECT_LT(other, drawn / 20);
  auto foreign = global;
  foreign.facts.erase("local_axes");
  EXPECT_THAT(refusal([&] { run_stage(inputs(foreign), {}, folder_ / "foreign"); }),
              testing::AllOf(testing::HasSubstr("the points lie 5442 km from the walk"),
                             testing::HasSubstr("the cloud that was written with them")));
}

TEST_F(FilmOfAPlace, HasAMapOfIt) {
  const auto map = red_map().string();
  const auto global = to_global(cloud_, frame_, {});
  run_stage(inputs(global), {}, folder_ / "none");
  EXPECT_EQ(pixels_like(folder_ / "none/flythrough/frame_00001.png", 0), 0);
  for (const char* on_terrain : {"false", "true"}) {
    const auto report = run_stage(inputs(global), {{"map", map}, {"map_on_terrain", on_terrain}}, folder_ / on_terrain);
    EXPECT_GT(pixels_like(folder_ / on_terrain / "flythrough/frame_00001.png", 0), 300) << on_terrain;
    EXPECT_THAT(report.warnings, testing::ElementsAre(testing::HasSubstr("ffmpeg"))) << on_terrain;
  }
  EXPECT_NE(first("false"), first("true"));
  auto bare = global;
  bare.remove_column(arrays::height_above_ground.name);
  const auto report = run_stage(inputs(bare), {{"map", map}, {"map_on_terrain", "true"}}, folder_ / "bare");
  EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("the map is flat")));
  EXPECT_THAT(refusal([&] {
                run_stage(inputs(cloud_), {{"map", map}}, folder_ / "nowhere");
              }),
              testing::HasSubstr("no place on the earth"));
  frame_.shift_global.x() += 5000;
  EXPECT_THAT(refusal([&] {
                run_stage(inputs(to_global(cloud_, frame_, {})), {{"map", map}}, folder_ / "far");
              }),
              testing::HasSubstr("km"));
}

TEST_F(FilmOfAPlace, TakesACloudBesideItInEitherAxes) {
  const auto global = to_global(cloud_, frame_, {});
  PointCloud other({{2, 5, 0}, {3, 5, 1}, {4, 5, 2}});
  for (const auto& beside : {other, to_global(other, frame_, {})}) {
    auto both = inputs(global);
    both.set("beside", beside);
    run_stage(both, {{"point_size", "20"}, {"beside_color", "#ff0000"}}, folder_ / "both");
    EXPECT_GT(pixels_like(folder_ / "both/flythrough/frame_00001.png", 0), 0) << axes_name(beside.axes);
  }
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
