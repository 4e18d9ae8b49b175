#include "io/core/scans/frame_folder.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "cloud/known_facts.h"
#include "io/core/scans/frame_estimates.h"
#include "io_test_tools.h"
#include "synthetic/comma_locale.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

constexpr int rings = 16, columns = 360;

// Rings as KITTI stores them: the top one first, each anticlockwise from azimuth 0.
std::vector<Eigen::Vector3f> ring_ordered(std::vector<std::uint16_t>& ring) {
  std::vector<Eigen::Vector3f> points;
  for (int r = rings - 1; r >= 0; --r)
    for (int c = 0; c < columns; ++c) {
      const double azimuth = 2 * std::numbers::pi * (c + 0.5) / columns,
                   elevation = (-15 + 2.0 * r) * std::numbers::pi / 180;
      points.emplace_back(static_cast<float>(10 * std::cos(elevation) * std::cos(azimuth)),
                          static_cast<float>(10 * std::cos(elevation) * std::sin(azimuth)),
                          static_cast<float>(10 * std::sin(elevation)));
      ring.push_back(static_cast<std::uint16_t>(r));
    }
  return points;
}

std::string bin_of(const std::vector<Eigen::Vector3f>& points) {
  std::string out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    put(out, points[i].x());
    put(out, points[i].y());
    put(out, points[i].z());
    put(out, static_cast<float>(i % 256));
  }
  return out;
}

TEST(FrameEstimates, RingsFollowFromTheOrder) {
  std::vector<std::uint16_t> truth;
  const auto points = ring_ordered(truth);
  EXPECT_EQ(rings_from_order(points), truth);
  auto shuffled = points;
  for (std::size_t i = 0; i < shuffled.size(); ++i) std::swap(shuffled[i], shuffled[i * 7919 % shuffled.size()]);
  EXPECT_TRUE(rings_from_order(shuffled).empty());
  EXPECT_TRUE(rings_from_order({}).empty());
}

TEST(FrameEstimates, RingsFollowFromElevations) {
  std::vector<std::uint16_t> truth;
  const auto points = ring_ordered(truth);
  const auto elevations = sensor::load_sensor_model("vlp16").ring_elevations_rad();
  EXPECT_EQ(rings_from_elevations(points, elevations), truth);
  EXPECT_EQ(rings_from_elevations(points, even_elevations_rad(points, rings)), truth);
}

TEST(FrameEstimates, TimesRunClockwiseFromBehind) {
  const std::vector<Eigen::Vector3f> points{{-1, 0.001F, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, -0.001F, 0}};
  const auto t = times_from_azimuths(points, 0.1);
  const std::vector<double> expected{0, 0.025, 0.05, 0.075, 0.1};
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(t[i], expected[i], 1e-4);
}

TEST(FrameFolder, KittiFramesWithNothingBeside) {
  const TempDir dir;
  std::vector<std::uint16_t> ring;
  auto points = ring_ordered(ring);
  write_file(dir / "000000.bin", bin_of(points));
  points[5] = {0, 0, 0};
  points[6].x() = std::nanf("");
  write_file(dir / "000001.bin", bin_of(points));
  const FrameFolderSource source(dir.path(), {}, {});
  ASSERT_EQ(source.size(), 2U);
  EXPECT_EQ(source.rings(), rings);
  EXPECT_EQ(source.sensor_model(), "unknown");
  EXPECT_NEAR(source.ring_elevations_rad().front(), -15 * std::numbers::pi / 180, 1e-4);
  ScanFrame frame;
  source.read(0, frame);
  EXPECT_EQ(frame.ring, ring);
  EXPECT_EQ(frame.intensity[300], 300 % 256);
  EXPECT_NEAR(frame.time_offset_s[0], 0.05, 1e-3);
  source.read(1, frame);
  EXPECT_EQ(frame.size(), ring.size() - 2);
  EXPECT_EQ(frame.intensity[5], 7);
  EXPECT_NEAR(frame.start_time_s, 0.1, 1e-9);
}

TEST(FrameFolder, TimesRingsAndSensorBesideTheFrames) {
  const TempDir dir;
  std::string times, rings_text;
  for (int i = 0; i < 2; ++i) {
    put(times, 0.01F * static_cast<float>(i));
    put(rings_text, static_cast<std::uint16_t>(7 - i));
  }
  for (const char* name : {"000000", "000001"}) {
    write_file(dir / (std::string(name) + ".bin"), bin_of({{3, 0, 0}, {0, 4, 0}}));
    write_file(dir / (std::string(name) + ".time"), times);
    write_file(dir / (std::string(name) + ".ring"), rings_text);
  }
  write_file(dir / "times.txt", "100.5\n100.75\n");
  write_file(dir / "sensor.json", R"({"sensor": "os1_64"})");
  const auto source = open_frame_source(dir.path());
  EXPECT_EQ(source->sensor_model(), "os1_64");
  EXPECT_EQ(source->rings(), 64);
  const auto facts = source->facts();
  EXPECT_EQ(facts.at("sensor"), sensor::load_sensor_model("os1_64").name);
  EXPECT_EQ(facts.at("clock"), "file");
  EXPECT_EQ(fact_number(facts, facts::beam_divergence), 2.27);
  ScanFrame frame;
  source->read(1, frame);
  EXPECT_EQ(frame.start_time_s, 100.75);
  EXPECT_EQ(frame.ring, (std::vector<std::uint16_t>{7, 6}));
  EXPECT_EQ(frame.time_offset_s, (std::vector<float>{0, 0.01F}));
  EXPECT_NEAR(frame.end_time_s, 100.76, 1e-6);

  write_file(dir / "000001.time", "abc");
  EXPECT_THAT(error_of([&] { source->read(1, frame); }), HasSubstr("frame 1"));
  EXPECT_THAT(error_of([&] { source->read(1, frame); }), HasSubstr("3 bytes"));
}

// A sensor of the user's own: its description lies beside the frames.
TEST(FrameFolder, TheDescriptionOfASensorBesideTheFramesIsTaken) {
  const TempDir dir;
  write_file(dir / "000000.bin", bin_of({{3, 0, 0}, {0, 4, 0}}));
  EXPECT_EQ(fact_number(open_frame_source(dir.path())->facts(), facts::range_noise), std::nullopt);
  EXPECT_EQ(open_frame_source(dir.path())->facts().at("clock"), "assumed");
  std::ifstream own(std::filesystem::path(BOLE_SOURCE_DIR) / "tests/bench/stems/dome_64.json");
  write_file(dir / "sensor.json", {std::istreambuf_iterator<char>(own), {}});
  const auto source = open_frame_source(dir.path());
  EXPECT_EQ(source->sensor_model(), "Dome-64");
  EXPECT_EQ(source->rings(), 64);
  EXPECT_EQ(fact_number(source->facts(), facts::beam_divergence), 0.5);
  EXPECT_EQ(fact_number(source->facts(), facts::beam_aperture), 0.005);
  EXPECT_EQ(fact_number(source->facts(), facts::range_noise), 0.005);
}

TEST(FrameFolder, WithoutPointTimesTheFrameTimeIsTheMiddleOfTheTurn) {
  const TempDir dir;
  for (const char* name : {"velodyne_points/data/0.bin", "velodyne_points/data/1.bin", "velodyne_points/data/2.bin"})
    write_file(dir / name, bin_of({{3, 0, 0}, {0, 4, 0}}));
  write_file(dir / "velodyne_points/timestamps.txt",
             "2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n2011-09-26 13:02:26.164389445\n");
  const auto source = open_frame_source(dir.path());
  ScanFrame frame;
  source->read(0, frame);
  EXPECT_NEAR(frame.start_time_s, 1317042145.964389445 - 0.05, 1e-6);
  EXPECT_NEAR(frame.start_time_s + frame.time_offset_s[0], 1317042145.964389445, 1e-6);  // forward
}

TEST(FrameFolder, TimesAreReadWithAPointInEveryLanguage) {
  const CommaLocale comma;
  ASSERT_TRUE(comma) << "localedef of glibc is needed";
  const TempDir dir;
  for (const char* name : {"0.bin", "1.bin"}) write_file(dir / name, bin_of({{3, 0, 0}, {0, 4, 0}}));
  write_file(dir / "times.txt", "2011-09-26 13:02:25.750000000\n2011-09-26 13:02:26.250000000\n");
  const auto source = open_frame_source(dir.path());
  ScanFrame frame;
  source->read(1, frame);
  EXPECT_NEAR(frame.start_time_s, 1317042146.25 - 0.25, 1e-6);
}

TEST(FrameFolder, FramesComeInTheOrderOfTheirNumbers) {
  const TempDir dir;
  for (const int i : {0, 1, 2, 9, 10, 11, 100})
    write_file(dir / ("frame" + std::to_string(i) + ".bin"), bin_of({{static_cast<float>(1 + i), 0, 0}}));
  const auto source = open_frame_source(dir.path());
  ScanFrame frame;
  std::vector<float> first;
  for (std::size_t i = 0; i < source->size(); ++i) {
    source->read(i, frame);
    first.push_back(frame.positions.at(0).x());
  }
  EXPECT_EQ(first, (std::vector<float>{1, 2, 3, 10, 11, 12, 101}));
}

TEST(FrameFolder, RingsThatTheFirstFrameDoesNotShowAreKnown) {
  const TempDir dir;
  for (const auto& [name, ring] : {std::pair("0", 5), std::pair("1", 63), std::pair("2", 20)}) {
    write_file(dir / (std::string(name) + ".bin"), bin_of({{3, 0, 0}}));
    std::string rings_text;
    put(rings_text, static_cast<std::uint16_t>(ring));
    write_file(dir / (std::string(name) + ".ring"), rings_text);
  }
  EXPECT_EQ(open_frame_source(dir.path())->rings(), 64);
}

TEST(FrameFolder, IntensitiesFromZeroToOneBecomeBytes) {
  const TempDir dir;
  std::string bin;
  for (const float v : {3.F, 0.F, 0.F, 0.5F, 0.F, 3.F, 0.F, 1.F}) put(bin, v);
  write_file(dir / "0.bin", bin);
  ScanFrame frame;
  open_frame_source(dir.path())->read(0, frame);
  EXPECT_EQ(frame.intensity, (std::vector<float>{127.5F, 255}));
}

TEST(FrameFolder, TimesThatDoNotFitAreLeftOutWithAWarning) {
  const TempDir dir;
  write_file(dir / "0.bin", bin_of({{3, 0, 0}}));
  write_file(dir / "times.txt", "1\n2\n");
  Report report;
  open_frame_source(dir.path(), {}, {}, report);
  EXPECT_THAT(report.warnings.at(0), HasSubstr("2 times for 1 frames"));
  write_file(dir / "times.txt", "monday\n");
  EXPECT_THAT(error_of([&] { open_frame_source(dir.path()); }), HasSubstr("line 1 is 'monday'"));
}

TEST(FrameFolder, ErrorsNameTheFile) {
  const TempDir dir;
  write_file(dir / "0.bin", "12345");
  EXPECT_THAT(error_of([&] { open_frame_source(dir.path()); }), HasSubstr("0.bin: 5 bytes"));
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "0.bin"); }), HasSubstr("single frame"));
  write_file(dir / "0.bin", bin_of({{3, 0, 0}}));
  FrameSourceOptions options;
  options.sensor = "vlp1";
  EXPECT_THAT(error_of([&] { open_frame_source(dir.path(), options); }), HasSubstr("no sensor 'vlp1'"));
}

TEST(FrameFolder, RealHdl64Sweeps) {
  BOLE_NEEDS_SHARED("KITTI_raw_HDL64");
  const auto source = open_frame_source(shared("KITTI_raw_HDL64"));
  ASSERT_EQ(source->size(), 50U);
  EXPECT_GE(source->rings(), 63);
  EXPECT_LE(source->rings(), 65);
  const auto elevations = source->ring_elevations_rad();
  EXPECT_NEAR(elevations.front() * 180 / std::numbers::pi, -24.3, 1.5);
  EXPECT_NEAR(elevations.back() * 180 / std::numbers::pi, 2, 1.5);
  ScanFrame frame;
  for (const std::size_t i : {0U, 25U, 49U}) {
    source->read(i, frame);
    EXPECT_GT(frame.size(), 100000U);
    EXPECT_NEAR(*std::ranges::max_element(frame.ring), 63, 1);
    EXPECT_LE(*std::ranges::max_element(frame.time_offset_s), 0.1F);
  }
}

}  // namespace
}  // namespace bole::io
