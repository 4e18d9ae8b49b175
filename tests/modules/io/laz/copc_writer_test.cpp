// COPC files hold all points once, in an octree that keeps what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/copc/copc_hierarchy.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/las/las_reader.h"
#include "modules/io/io_test_tools.h"
#include "modules/io/laz/made_cloud.h"

namespace bole::io {
namespace {

using namespace testing_io;

// Places in the steps of the file with the tree and the time, which tell points apart.
using Point = std::array<double, 5>;
std::vector<Point> sorted_points(const PointCloud& cloud, const CloudBounds& bounds = {}) {
  std::vector<Point> out;
  const auto& tree = cloud.values<std::int32_t>(arrays::tree_id);
  const auto& time = cloud.values<double>(arrays::time);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = exact_position(cloud, i);
    if (bounds.contains(p))
      out.push_back({std::round(1e4 * p.x()), std::round(1e4 * p.y()), std::round(1e4 * p.z()),
                     static_cast<double>(tree[i]), time[i]});
  }
  std::ranges::sort(out);
  return out;
}

struct CopcFile {
  explicit CopcFile(const std::filesystem::path& path) : file(path), info(las::parse_info(file.bytes())) {
    std::vector<std::string> warnings;
    copc = copc::copc_info(file.bytes(), info, warnings);
    EXPECT_THAT(warnings, testing::IsEmpty());
  }
  MappedFile file;
  LasInfo info;
  std::optional<copc::CopcInfo> copc;
};

class CopcWriter : public testing::Test {
 protected:
  static constexpr std::size_t points = 400'000;
  static void SetUpTestSuite() {
    dir_ = new TempDir;
    cloud_ = new PointCloud(made_cloud(points, true));
    // Most points lie close together, so that the tree is deep there.
    auto positions = cloud_->positions();
    for (std::size_t i = 0; i < points; ++i)
      if (i % 4 != 0) positions[i] *= 0.1F;
    PointCloud dense(std::move(positions), cloud_->origin);
    for (const auto& [name, column] : cloud_->columns()) dense.set_column(name, *column);
    dense.facts = cloud_->facts;
    dense.crs_wkt = cloud_->crs_wkt;
    *cloud_ = dense;
    write_cloud(*dir_ / "a.copc.laz", *cloud_);
    write_cloud(*dir_ / "a.las", *cloud_);
  }
  static void TearDownTestSuite() {
    delete cloud_;
    delete dir_;
  }
  static TempDir* dir_;
  static PointCloud* cloud_;
};
TempDir* CopcWriter::dir_ = nullptr;
PointCloud* CopcWriter::cloud_ = nullptr;

TEST_F(CopcWriter, EveryPointIsThereOnce) {
  const auto plain = read_las(*dir_ / "a.las");
  Report report;
  const auto all = read_las(*dir_ / "a.copc.laz", {}, {}, &report);
  EXPECT_THAT(report.warnings, testing::IsEmpty());
  EXPECT_EQ(all.facts, plain.facts);
  EXPECT_EQ(all.crs_wkt, plain.crs_wkt);
  EXPECT_TRUE(sorted_points(all) == sorted_points(plain)) << "by the chunk table";
  CloudReadOptions options;
  options.bounds = "0,0,1e9,1e9";
  const auto by_nodes = read_cloud(*dir_ / "a.copc.laz", options);
  EXPECT_TRUE(sorted_points(by_nodes.cloud) == sorted_points(plain)) << "by the octree";
  EXPECT_GT(by_nodes.report.counts.at("copc_levels"), 2);
  EXPECT_THAT(by_nodes.report.findings, testing::IsEmpty());
}

TEST_F(CopcWriter, BoundsGiveThePointsThatLieInThem) {
  const auto plain = read_las(*dir_ / "a.las");
  for (const char* text : {"691234,5334567,691240,5334570", "691220,5334550,520,691235,5334568,523"}) {
    CloudReadOptions options;
    options.bounds = text;
    const auto part = read_cloud(*dir_ / "a.copc.laz", options);
    EXPECT_TRUE(sorted_points(part.cloud) == sorted_points(plain, *parse_bounds(text))) << text;
    EXPECT_GT(part.cloud.size(), 1000U);
  }
}

TEST_F(CopcWriter, HeaderAndInfoSayWhatTheFileHolds) {
  const CopcFile made(*dir_ / "a.copc.laz");
  ASSERT_TRUE(made.copc);
  EXPECT_EQ(made.info.points, points);
  EXPECT_EQ(made.info.point_format, 7);
  EXPECT_EQ(made.info.version_minor, 4);
  EXPECT_EQ(made.info.global_encoding & 16U, 16U);
  EXPECT_EQ(made.info.vlrs.front().user_id, "copc");
  EXPECT_EQ(made.info.vlrs.front().offset, 375U + 54U);
  EXPECT_THAT(made.info.warnings, testing::IsEmpty());
  const Eigen::Vector3d low = made.copc->centre.array() - made.copc->half_size,
                        high = made.copc->centre.array() + made.copc->half_size;
  EXPECT_TRUE((low.array() <= made.info.min.array()).all());
  EXPECT_TRUE((high.array() >= made.info.max.array()).all());
  EXPECT_DOUBLE_EQ(made.copc->spacing, made.copc->half_size / 64);
  const auto& time = cloud_->values<double>(arrays::time);
  const std::uint8_t* info = made.file.bytes().data() + made.info.vlrs.front().offset;
  EXPECT_EQ(las::load<double>(info + 56), *std::ranges::min_element(time));
  EXPECT_EQ(las::load<double>(info + 64), *std::ranges::max_element(time));
  for (std::size_t i = 72; i < 160; ++i) EXPECT_EQ(info[i], 0) << "reserved";
}

// A node of the hierarchy as it lies in the file, pages followed.
struct Node {
  std::int32_t level;
  Eigen::Vector3i key;
  std::uint64_t offset;
  std::int32_t bytes, points;
};
std::vector<Node> nodes_of(Bytes file, std::uint64_t at, std::uint64_t size, std::size_t& pages) {
  std::vector<Node> out;
  ++pages;
  for (const std::uint64_t end = at + size; at < end; at += 32) {
    const std::uint8_t* e = file.data() + at;
    const Node node{las::load<std::int32_t>(e),
                    {las::load<std::int32_t>(e + 4), las::load<std::int32_t>(e + 8), las::load<std::int32_t>(e + 12)},
                    las::load<std::uint64_t>(e + 16),
                    las::load<std::int32_t>(e + 24),
                    las::load<std::int32_t>(e + 28)};
    if (node.points == -1) {
      const auto below = nodes_of(file, node.offset, static_cast<std::uint64_t>(node.bytes), pages);
      EXPECT_EQ(below.front().level, node.level);
      EXPECT_EQ(below.front().key, node.key);
      out.insert(out.end(), below.begin(), below.end());
    } else {
      out.push_back(node);
    }
  }
  return out;
}

TEST_F(CopcWriter, PointsLieInTheirNodesAndAreThinned) {
  const CopcFile made(*dir_ / "a.copc.laz");
  std::size_t pages = 0;
  const auto nodes = nodes_of(made.file.bytes(), made.copc->root_offset, made.copc->root_size, pages);
  const auto packing = laz::parse_packing(
      las::vlr_data(made.file.bytes(), *las::find_vlr(made.info, "laszip encoded", 22204)), made.info.record_length);
  const auto length = static_cast<std::size_t>(made.info.record_length);
  std::uint64_t sum = 0;
  for (const auto& node : nodes) {
    std::vector<std::uint8_t> records(static_cast<std::size_t>(node.points) * length);
    laz::ChunkDecoder decoder(packing, made.info.record_length);
    decoder.start(made.file.bytes().subspan(node.offset, static_cast<std::size_t>(node.bytes)),
                  static_cast<std::uint64_t>(node.points));
    ASSERT_EQ(decoder.decode(records.data(), static_cast<std::size_t>(node.points)),
              static_cast<std::size_t>(node.points));
    sum += static_cast<std::uint64_t>(node.points);
    const double size = std::ldexp(2 * made.copc->half_size, -node.level);
    const Eigen::Vector3d low =
        made.copc->centre.array() - made.copc->half_size + size * node.key.cast<double>().array();
    std::set<std::array<int, 3>> cells;
    for (std::int32_t i = 0; i < node.points; ++i) {
      std::array<int, 3> cell;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double p =
            las::load<std::int32_t>(&records[static_cast<std::size_t>(i) * length + 4 * k]) * made.info.scale[axis] +
            made.info.offset[axis];
        ASSERT_GE(p, low[axis] - 1e-7);
        ASSERT_LT(p, low[axis] + size + 1e-7);
        cell[k] = static_cast<int>((p - low[axis]) / size * 128);
      }
      cells.insert(cell);
    }
    const bool has_children = std::ranges::any_of(
        nodes, [&](const Node& n) { return n.level == node.level + 1 && (n.key / 2 - node.key).isZero(); });
    // Children that would be small are kept as well.
    EXPECT_LE(static_cast<std::size_t>(node.points), (has_children ? cells.size() : 65'536U) + 8 * 512U);
  }
  EXPECT_EQ(sum, points);
}

TEST_F(CopcWriter, CoarserReadingsHaveAHandfulOfPoints) {
  std::size_t last = points;
  for (const double resolution : {0.05, 0.1, 0.2, 0.4}) {
    CloudReadOptions options;
    options.resolution = resolution;
    const auto size = read_cloud(*dir_ / "a.copc.laz", options).cloud.size();
    EXPECT_LE(size, last);
    last = size;
  }
  EXPECT_LT(last, points / 2);
}

TEST(CopcWriterEdges, FewAndEqualPoints) {
  const TempDir dir;
  for (const std::size_t count : {0U, 1U, 2U, 511U}) {
    const auto cloud = made_cloud(count, false);
    write_cloud(dir / "few.copc.laz", cloud);
    const CopcFile made(dir / "few.copc.laz");
    ASSERT_TRUE(made.copc) << count;
    EXPECT_EQ(read_las(dir / "few.copc.laz").size(), count);
  }
  // The tree ends where the steps of the file do.
  PointCloud same(PointCloud::Positions(200'000, Eigen::Vector3f(1, 2, 3)));
  write_cloud(dir / "same.copc.laz", same);
  EXPECT_EQ(read_las(dir / "same.copc.laz").size(), same.size());
  auto positions = same.positions();
  positions.emplace_back(5000, 5000, 5000);
  write_cloud(dir / "far.copc.laz", PointCloud(std::move(positions)));
  CloudReadOptions options;
  options.bounds = "0,0,2,3";
  EXPECT_EQ(read_cloud(dir / "far.copc.laz", options).cloud.size(), same.size());
}

// A flat and wide octree: 21845 nodes.
TEST(CopcWriterEdges, LargeHierarchiesHavePages) {
  copc::Octree octree;
  std::vector<laz::Chunk> chunks;
  for (int level = 0; level <= 7; ++level)
    for (int x = 0; x < 1 << level; ++x)
      for (int y = 0; y < 1 << level; ++y) {
        const auto at = static_cast<std::uint64_t>(100 + 10 * chunks.size());
        octree.nodes.push_back({level, {x, y, 0}, {}});
        chunks.push_back({at, at + 10, 2});
      }
  constexpr std::uint64_t offset = 4096;
  const auto made = copc::make_hierarchy(octree, chunks, offset);
  std::vector<std::uint8_t> file(offset);
  file.insert(file.end(), made.bytes.begin(), made.bytes.end());
  std::size_t pages = 0;
  const auto nodes = nodes_of(file, offset, made.root_size, pages);
  EXPECT_EQ(nodes.size(), octree.nodes.size());
  std::set<std::uint64_t> places;
  for (const auto& node : nodes) places.insert(node.offset);
  EXPECT_EQ(places.size(), nodes.size()) << "each node once";
  EXPECT_EQ(pages, 1U + 256U) << "the root with four levels, and one for each node below";
  EXPECT_LT(made.root_size, 32U * 512U);
}

}  // namespace
}  // namespace bole::io
