// Clouds in pieces: together they are the whole, and all have its place.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/see_cloud.h"
#include "modules/io/io_test_tools.h"

namespace bole::io {
namespace {

using testing::Each;
using testing::Gt;

const std::filesystem::path octree = BOLE_SOURCE_DIR "/tests/data/copc/octree.copc.laz";

struct DealtPoint {
  std::array<std::int64_t, 3> steps;
  float intensity;
  auto operator<=>(const DealtPoint&) const = default;
};

void add_points(std::vector<DealtPoint>& points, const PointCloud& cloud) {
  const auto* intensity = cloud.has(arrays::intensity) ? &cloud.values<float>(arrays::intensity) : nullptr;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = exact_position(cloud, i);
    points.push_back({{std::llround(1e4 * p.x()), std::llround(1e4 * p.y()), std::llround(1e4 * p.z())},
                      intensity ? (*intensity)[i] : 0});
  }
}

SeeCloudOptions decided() {
  SeeCloudOptions options;
  options.unit = LengthUnit::metre;
  options.up = UpAxis::z;
  return options;
}

struct Dealt {
  std::vector<DealtPoint> points;
  std::vector<std::size_t> sizes;
  bool one_origin = true;
};

Dealt deal_out(const std::filesystem::path& path, int pieces, const SeeCloudOptions& options) {
  Dealt dealt;
  std::optional<Eigen::Vector3d> origin;
  for (int i = 0; i < pieces; ++i) {
    const auto cloud = read_piece(path, {i, pieces}, options).cloud;
    add_points(dealt.points, cloud);
    dealt.sizes.push_back(cloud.size());
    if (cloud.empty()) continue;
    if (origin) dealt.one_origin = dealt.one_origin && (cloud.origin - *origin).norm() < 1e-6;
    origin = cloud.origin;
  }
  std::ranges::sort(dealt.points);
  return dealt;
}

void expect_whole(const std::filesystem::path& path, const SeeCloudOptions& options, bool spread) {
  SCOPED_TRACE(path);
  std::vector<DealtPoint> all;
  add_points(all, see_cloud(path, options).reading.cloud);
  std::ranges::sort(all);
  ASSERT_FALSE(all.empty());
  for (const int pieces : {1, 2, 3, 7}) {
    const auto dealt = deal_out(path, pieces, options);
    EXPECT_EQ(dealt.points, all) << pieces << " pieces";
    EXPECT_TRUE(dealt.one_origin);
    if (spread) {
      EXPECT_THAT(dealt.sizes, Each(Gt(0U))) << pieces << " pieces";
    }
  }
}

class Pieces : public testing::Test {
 protected:
  std::filesystem::path copy(const std::string& name) {
    const auto path = folder_ / name;
    write_cloud(path, read_cloud(octree).cloud);
    return path;
  }

 private:
  testing_io::TempDir folder_;
};

TEST_F(Pieces, OfCopcAreChunksOfTheOctree) {
  expect_whole(octree, decided(), true);
  auto part = decided();
  part.reading.bounds = "500000,5400000,500016,5400032";
  expect_whole(octree, part, false);
  auto coarse = decided();
  coarse.reading.resolution = 0.6;
  expect_whole(octree, coarse, false);
}

TEST_F(Pieces, OfLasAreRunsOfRecords) {
  const auto path = copy("plain.las");
  expect_whole(path, decided(), true);
  auto part = decided();
  part.reading.bounds = "500000,5400000,500004,5400004";  // some pieces have no point in it
  expect_whole(path, part, false);
}

TEST_F(Pieces, OfLazAreChunks) {
  for (const char* name :
       {"format0.laz", "format3_extra.laz", "format6_variable.laz", "format7.laz", "format1_old.laz"})
    expect_whole(std::filesystem::path(BOLE_SOURCE_DIR "/tests/data/laz") / name, decided(), false);
}

TEST_F(Pieces, ThatTheCloudDecidesAreSharesOfTheWhole) { expect_whole(octree, {}, true); }

TEST_F(Pieces, OfOtherFormatsAreTheWholeAndNothing) {
  const auto path = copy("points.ply");
  expect_whole(path, decided(), false);
  EXPECT_TRUE(read_piece(path, {1, 2}, decided()).cloud.empty());
}

}  // namespace
}  // namespace bole::io
