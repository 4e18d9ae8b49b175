// LAZ files hold what LAS files hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "io/core/clouds/cloud_writer.h"
#include "io/core/formats.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_reader.h"
#include "io/core/las/las_writer.h"
#include "modules/io/io_test_tools.h"
#include "modules/io/laz/made_cloud.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

TEST(LazWriter, HoldsWhatLasHolds) {
  const TempDir dir;
  for (const bool colour : {false, true})
    for (const char* version : {"1.4", "1.2"}) {
      const auto cloud = made_cloud(2345, colour);
      LasWriteOptions options;
      options.version = version;
      write_las(dir / "plain.las", cloud, options);
      options.packing = LasPacking::laz;
      write_las(dir / "packed.laz", cloud, options);
      const auto info = las_info(dir / "packed.laz"), plain = las_info(dir / "plain.las");
      EXPECT_TRUE(info.compressed);
      EXPECT_TRUE(info.warnings.empty());
      EXPECT_EQ(info.point_format, plain.point_format);
      EXPECT_EQ(info.min, plain.min);
      EXPECT_EQ(info.max, plain.max);
      EXPECT_EQ(info.points_by_return, plain.points_by_return);
      EXPECT_EQ(info.global_encoding, plain.global_encoding);
      EXPECT_EQ(info.crs_wkt, plain.crs_wkt);
      EXPECT_EQ(info.extra_columns, plain.extra_columns);
      Report report;
      expect_same(read_las(dir / "packed.laz", {}, {}, &report), read_las(dir / "plain.las"));
      EXPECT_THAT(report.warnings, testing::IsEmpty());
      EXPECT_LT(std::filesystem::file_size(dir / "packed.laz"), std::filesystem::file_size(dir / "plain.las"));
    }
}

// Chunks have 50 000 points.
TEST(LazWriter, NoPointIsLostAtTheBordersOfChunks) {
  const TempDir dir;
  for (const std::size_t count : {0U, 1U, 2U, 49'999U, 50'000U, 50'001U, 150'000U}) {
    const auto cloud = made_cloud(count, false);
    write_cloud(dir / "a.laz", cloud);
    write_cloud(dir / "a.las", cloud);
    Report report;
    const auto back = read_las(dir / "a.laz", {}, {}, &report);
    EXPECT_THAT(report.warnings, testing::IsEmpty()) << count;
    ASSERT_EQ(back.size(), count);
    expect_same(back, read_las(dir / "a.las"));
  }
}

TEST(LazWriter, TheSameBytesAtAnyNumberOfThreads) {
  const TempDir dir;
  const auto cloud = made_cloud(230'000, false);
  for (const char* name : {"a.laz", "a.copc.laz"}) {
    write_cloud(dir / name, cloud);
    const auto parallel = file_text(dir / name);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    write_cloud(dir / name, cloud);
    EXPECT_TRUE(file_text(dir / name) == parallel) << name;
  }
}

TEST(LazWriter, TheKindOfTimeIsKept) {
  const TempDir dir;
  for (const char* name : {"a.laz", "a.copc.laz"})
    for (const auto& [kind, bit] : {std::pair{las::gps_week, 0U}, {las::gps_standard, 1U}}) {
      auto cloud = made_cloud(100, false);
      cloud.facts[std::string(las::gps_time_fact)] = kind;
      write_cloud(dir / name, cloud);
      const auto info = las_info(dir / name);
      EXPECT_EQ(info.global_encoding, 16U | bit);
      EXPECT_THAT(info.extra_columns, testing::Not(testing::Contains("time")));
      EXPECT_EQ(read_las(dir / name).facts.at(std::string(las::gps_time_fact)), kind);
      // Times of another clock are no GPS time.
      cloud.facts.erase(std::string(las::gps_time_fact));
      write_cloud(dir / name, cloud);
      EXPECT_THAT(las_info(dir / name).extra_columns, testing::Contains("time"));
    }
}

TEST(LazWriter, WarningsAndErrorsAreThoseOfLas) {
  const TempDir dir;
  for (const char* name : {"a.laz", "a.copc.laz"}) {
    auto cloud = made_cloud(120'000, false);
    auto intensity = cloud.values<float>(arrays::intensity);
    intensity[7] = 70000;
    intensity[110'000] = -3;
    cloud.set_column(arrays::intensity, intensity);
    Report report;
    write_cloud(dir / name, cloud, {}, &report);
    EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("2 values of intensity"))) << name;
    auto positions = cloud.positions();
    positions[100'000].x() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(error_of([&] { write_cloud(dir / ("bad_" + std::string(name)), PointCloud(std::move(positions))); }),
                HasSubstr("point 100000 has the coordinate"));
    EXPECT_FALSE(std::filesystem::exists(dir / ("bad_" + std::string(name))));
  }
  EXPECT_THAT(error_of([&] {
                LasWriteOptions options;
                options.version = "1.2";
                options.packing = LasPacking::copc;
                write_las(dir / "a.copc.laz", PointCloud(), options);
              }),
              HasSubstr("LAS 1.4"));
}

TEST(LazWriter, EndingsChooseTheFormat) {
  const TempDir dir;
  const auto cloud = made_cloud(100, false);
  for (const auto& [name, format] : {std::pair{"a.las", "LAS"},
                                     {"a.laz", "LAZ"},
                                     {"a.LAZ", "LAZ"},
                                     {"a.copc.laz", "COPC"},
                                     {"b.CoPC.laz", "COPC"}}) {
    EXPECT_EQ(written_format(FileContent::cloud, dir / name).name, format);
    EXPECT_EQ(find_format(dir / name)->name, format) << "before there is a file";
    write_cloud(dir / name, cloud);
    EXPECT_EQ(find_format(dir / name)->name, format) << name;
  }
}

TEST(LazWriter, CanBeCancelled) {
  const TempDir dir;
  const auto cloud = made_cloud(400'000, false);
  for (const char* name : {"a.laz", "a.copc.laz"}) {
    std::stop_source stop;
    stop.request_stop();
    bole::Run run;
    run.cancel = stop.get_token();
    EXPECT_THROW(write_cloud(dir / name, cloud, run), Error);
    EXPECT_FALSE(std::filesystem::exists(dir / name));
  }
}

}  // namespace
}  // namespace bole::io
