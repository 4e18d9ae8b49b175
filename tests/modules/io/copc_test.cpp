// COPC and the options bounds and resolution. The numbers of the fixture are those that laspy finds in it
// (tests/bench/peers/clouds_against_peers.py compares point by point).
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/verdict.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/formats.h"
#include "io/core/las/las_bytes.h"
#include "io_test_tools.h"
#include "las_file.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

const std::filesystem::path fixture = BOLE_SOURCE_DIR "/tests/data/copc/octree.copc.laz";
constexpr const char* part = "500004.0005,5400004.0005,500012.0005,5400010.0005";

std::vector<std::uint8_t> fixture_bytes() {
  const auto text = file_text(fixture);
  return {text.begin(), text.end()};
}

// Steps of 0.1 mm, in an order of their own: coordinates differ by rounding where clouds have other origins.
std::vector<std::array<std::int64_t, 3>> sorted_points(const PointCloud& cloud, const CloudBounds& bounds = {}) {
  std::vector<std::array<std::int64_t, 3>> out;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = exact_position(cloud, i);
    if (bounds.contains(p))
      out.push_back({std::llround(1e4 * p.x()), std::llround(1e4 * p.y()), std::llround(1e4 * p.z())});
  }
  std::ranges::sort(out);
  return out;
}

CloudReading read_with(const std::filesystem::path& path, const std::string& bounds, double resolution = 0) {
  CloudReadOptions options;
  options.bounds = bounds;
  options.resolution = resolution;
  return read_cloud(path, options);
}

TEST(CloudBounds, TextsAreRectanglesOrBoxes) {
  EXPECT_FALSE(parse_bounds(""));
  EXPECT_FALSE(parse_bounds("  "));
  const auto plan = parse_bounds("-1, 2,3.5 ,4");
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->min.head<2>(), Eigen::Vector2d(-1, 2));
  EXPECT_TRUE(plan->contains({3.5, 4, 1e9}));
  EXPECT_FALSE(plan->contains({3.6, 4, 0}));
  EXPECT_FALSE(plan->contains({0, std::nan(""), 0}));
  const auto box = parse_bounds("[0,0,0,1,1,2]");
  ASSERT_TRUE(box);
  EXPECT_FALSE(box->contains({0.5, 0.5, 2.1}));
  for (const char* text : {"1,2,3", "1,2,3,4,5", "a,b,c,d", "3,0,1,1", "0,0,nan,1", "0,0,inf,1"})
    EXPECT_THAT(error_of([&] { parse_bounds(text); }), HasSubstr("xmin,ymin,xmax,ymax")) << text;
}

TEST(Copc, IsKnownByItsFirstRecord) {
  EXPECT_EQ(find_format(fixture)->name, "COPC");
  const auto cloud = read_cloud(fixture);
  EXPECT_EQ(cloud.report.facts.at("format"), "COPC");
  EXPECT_EQ(cloud.cloud.size(), 700U);
  EXPECT_THAT(cloud.cloud.crs_wkt, HasSubstr("made for a test"));
}

TEST(Copc, BoundsGiveThePointsThatLieInThem) {
  const auto all = read_cloud(fixture).cloud;
  const auto some = read_with(fixture, part);
  EXPECT_EQ(some.cloud.size(), 38U);
  EXPECT_EQ(sorted_points(some.cloud), sorted_points(all, *parse_bounds(part)));
  EXPECT_LT(some.report.counts.at("copc_nodes"), read_with(fixture, "0,0,1e9,1e9").report.counts.at("copc_nodes"));
  // Columns go with their points.
  const auto& red = some.cloud.values<std::uint16_t>(arrays::red);
  const auto& time = some.cloud.values<double>(arrays::time);
  for (std::size_t i = 0; i < red.size(); ++i) EXPECT_NEAR(time[i], 3e8 + 0.01 * red[i], 1e-6);
}

TEST(Copc, ResolutionEndsAtTheFirstLevelThatHasIt) {
  EXPECT_EQ(read_with(fixture, "", 2).cloud.size(), 40U);
  EXPECT_EQ(read_with(fixture, "", 1).cloud.size(), 40U);
  EXPECT_EQ(read_with(fixture, "", 0.5).cloud.size(), 200U);
  EXPECT_EQ(read_with(fixture, "", 0.3).cloud.size(), 700U);
  EXPECT_EQ(read_with(fixture, "", 1e-3).cloud.size(), 700U);
  EXPECT_EQ(read_with(fixture, part, 0.5).cloud.size(), 10U);
}

TEST(Copc, BoundsBesideTheFileAreAnErrorThatGivesItsBounds) {
  EXPECT_THAT(error_of([] { read_with(fixture, "0,0,1,1"); }), HasSubstr("x 500000"));
}

std::uint64_t root_page_of(const std::vector<std::uint8_t>& file) {
  return las::load<std::uint64_t>(&file[375 + 54 + 40]);
}

// Where the entry of the root node lies.
std::uint64_t root_of(const std::vector<std::uint8_t>& file) {
  std::uint64_t at = root_page_of(file);
  while (las::load<std::int32_t>(&file[at]) != 0) at += 32;
  return at;
}

CloudReading read_damaged(const std::vector<std::uint8_t>& file, const char* bounds = part) {
  CloudReadOptions options;
  options.bounds = bounds;
  return read_cloud(Bytes(file), "damaged.copc.laz", options);
}

TEST(Copc, PagesThatNameOneAnotherEnd) {
  auto file = fixture_bytes();
  const auto root = root_of(file);
  las::store(&file[root + 16], root_page_of(file));  // the root node becomes a page: the root page itself
  las::store(&file[root + 28], std::int32_t{-1});
  const auto reading = read_damaged(file, "0,0,1e9,1e9");
  EXPECT_TRUE(has_finding(reading.report, "copc_hierarchy_damaged"));
  EXPECT_EQ(reading.cloud.size(), 660U);  // all but the 40 points of the root
}

TEST(Copc, LyingEntriesAreLeftOutAndTold) {
  for (const std::uint64_t offset : {std::uint64_t{0}, ~std::uint64_t{0}, std::uint64_t{1} << 40}) {
    auto file = fixture_bytes();
    las::store(&file[root_of(file) + 16], offset);
    const auto reading = read_damaged(file);
    EXPECT_TRUE(has_finding(reading.report, "copc_hierarchy_damaged")) << offset;
    EXPECT_GT(reading.cloud.size(), 0U);
  }
  auto file = fixture_bytes();
  las::store(&file[root_of(file) + 28], std::int32_t{2'000'000'000});  // points of the root
  EXPECT_TRUE(has_finding(read_damaged(file).report, finding_code::input_incomplete));
}

TEST(Copc, PointsOfRefusedEntriesAreMissing) {
  auto file = fixture_bytes();
  las::store(&file[root_of(file) + 16], ~std::uint64_t{0});
  EXPECT_TRUE(has_finding(read_damaged(file, "0,0,1e9,1e9").report, finding_code::input_incomplete));
  file = fixture_bytes();
  const auto root = root_of(file);  // becomes a page that lies outside
  las::store(&file[root + 16], ~std::uint64_t{0});
  las::store(&file[root + 28], std::int32_t{-1});
  EXPECT_TRUE(has_finding(read_damaged(file, "0,0,1e9,1e9").report, finding_code::input_incomplete));
}

TEST(Copc, AnEntryOnTopOfOthersCostsItsOwnPoints) {
  auto file = fixture_bytes();
  const auto root = root_of(file);
  const std::uint64_t first = las::load<std::uint64_t>(&file[96]) + 8;  // behind the place of the chunk table
  const auto last = las::load<std::uint64_t>(&file[root + 16]) + las::load<std::uint32_t>(&file[root + 24]);
  las::store(&file[root + 16], first);
  las::store(&file[root + 24], static_cast<std::int32_t>(std::max(last, root_page_of(file)) - first) - 2000);
  const auto reading = read_damaged(file, "0,0,1e9,1e9");
  EXPECT_EQ(reading.cloud.size(), 660U);  // all but the 40 points of the root
  EXPECT_TRUE(has_finding(reading.report, finding_code::input_incomplete));
}

TEST(Copc, NothingWithinSaysWhy) {
  // A corner in which the coarse level has no point.
  const auto all = read_cloud(fixture).cloud;
  const auto coarse = read_with(fixture, "", 2).cloud;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Eigen::Vector3d p = exact_position(all, i);
    const auto text = fmt::format("{},{},{},{}", p.x() - 0.01, p.y() - 0.01, p.x() + 0.01, p.y() + 0.01);
    if (!sorted_points(coarse, *parse_bounds(text)).empty()) continue;
    EXPECT_THAT(error_of([&] { read_with(fixture, text, 2); }), HasSubstr("smaller resolution"));
    break;
  }
  auto file = fixture_bytes();
  las::store(&file[375 + 54 + 40], std::uint64_t{10});  // the first page lies in the header
  EXPECT_THAT(error_of([&] { read_damaged(file); }), HasSubstr("octree of the file are damaged"));
}

TEST(Copc, ADamagedRecordLeavesALazFile) {
  auto file = fixture_bytes();
  las::store(&file[375 + 54 + 40], ~std::uint64_t{0});
  const auto reading = read_damaged(file);
  EXPECT_EQ(reading.cloud.size(), 38U);
  EXPECT_THAT(reading.report.warnings.front(), HasSubstr("COPC"));
  CloudReadOptions options;
  options.resolution = 2;
  EXPECT_TRUE(has_finding(read_cloud(Bytes(file), "a.copc.laz", options).report, "resolution_ignored"));
}

TEST(Copc, ACutFileIsTold) {
  auto file = fixture_bytes();
  file.resize(file.size() / 2);
  EXPECT_TRUE(has_finding(read_damaged(file).report, finding_code::input_incomplete));
  file.resize(600);
  EXPECT_NE(error_of([&] { read_damaged(file); }), "no error");
}

TEST(Bounds, OfLasFiles) {
  test::LasFile las;
  for (int i = 0; i < 100'000; ++i) las.add(i % 1000, i / 1000, i % 7);
  const auto file = las.bytes();
  CloudReadOptions options;
  options.bounds = "1000.005,2000.005,1001.005,2000.105";  // x from 0.01 to 1.00, y from 0.01 to 0.10
  const auto reading = read_cloud(Bytes(file), "a.las", options);
  EXPECT_EQ(reading.cloud.size(), 1000U);
  for (std::size_t i = 0; i < reading.cloud.size(); ++i)
    EXPECT_TRUE(parse_bounds(options.bounds)->contains(exact_position(reading.cloud, i)));
  options.bounds = "0,0,1,1";
  EXPECT_THAT(error_of([&] { read_cloud(Bytes(file), "a.las", options); }), HasSubstr("bounds"));
}

TEST(Bounds, PointsOnTheEdgeAreInside) {
  test::LasFile las;
  for (int i = 0; i < 1000; ++i) las.add(i, 0, 0);
  const auto file = las.bytes();
  for (int i = 0; i < 1000; i += 7) {
    CloudReadOptions options;
    options.bounds = fmt::format("0,0,{}.{:02},3000", 1000 + i / 100, i % 100);
    const auto reading = read_cloud(Bytes(file), "a.las", options);
    EXPECT_EQ(reading.cloud.size(), static_cast<std::size_t>(i + 1)) << options.bounds;
    EXPECT_EQ(reading.report.counts.at("points_outside_bounds"), 999 - i);
  }
}

TEST(Bounds, OfCompressedFilesAreThoseOfAllTheirPoints) {
  for (const char* name :
       {"format1.laz", "format1_old.laz", "format6.laz", "format6_variable.laz", "format7_extra.laz"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path path = std::string(BOLE_SOURCE_DIR "/tests/data/laz/") + name;
    const auto all = read_cloud(path).cloud;
    const std::string text = "0,-1e9," + std::to_string(exact_position(all, all.size() / 2).x() + 5e-5) + ",1e9";
    const auto wanted = sorted_points(all, *parse_bounds(text));
    EXPECT_GT(wanted.size(), 0U);
    EXPECT_LT(wanted.size(), all.size());
    EXPECT_EQ(sorted_points(read_with(path, text).cloud), wanted);
  }
}

TEST(Bounds, OfTextAreInTheCoordinatesOfTheFile) {
  CloudReadOptions options;
  options.bounds = "0,0,2000,2000";
  options.unit = LengthUnit::millimetre;
  const auto reading = read_cloud(bytes_of("x y z\n1000 1000 0\n3000 1000 0\n500 100 9000\n"), "a.xyz", options);
  EXPECT_EQ(reading.cloud.size(), 2U);
  EXPECT_EQ(reading.report.counts.at("points_outside_bounds"), 1);
  options.bounds = "5000,0,6000,1";
  EXPECT_THAT(error_of([&] { read_cloud(bytes_of("x y z\n1000 1000 0\n"), "a.xyz", options); }), HasSubstr("1000"));
}

TEST(Bounds, ResolutionOfOtherFormatsIsToldToDoNothing) {
  CloudReadOptions options;
  options.resolution = 0.1;
  EXPECT_TRUE(has_finding(read_cloud(bytes_of("1 2 3\n4 5 6\n"), "a.xyz", options).report, "resolution_ignored"));
  EXPECT_FALSE(has_finding(read_with(fixture, "", 0.5).report, "resolution_ignored"));
}

}  // namespace
}  // namespace bole::io
