// COPC files that are looked at in parts, and those that are built of more points than fit into memory.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "base/random.h"
#include "base/verdict.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/copc/copc_index.h"
#include "io/core/copc/copc_tree.h"
#include "io/core/las/las_writer.h"
#include "modules/io/io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using copc::CopcTree;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t octree_points = 300'000;

// A ground with a few dense posts, so that the tree is deep in places.
PointCloud ground_with_posts() {
  PointCloud::Positions p(octree_points);
  std::vector<float> intensity(octree_points);
  std::vector<double> time(octree_points);
  std::vector<std::uint8_t> classification(octree_points), one(octree_points, 1);
  for (std::size_t i = 0; i < octree_points; ++i) {
    Random random(7, 0, i);
    const bool post = i % 3 == 0;
    const auto u = [&] { return static_cast<float>(random.uniform()); };
    p[i] =
        post ? Eigen::Vector3f(20 + u() * 0.4F, 30 + u() * 0.4F, 10 * u()) : Eigen::Vector3f(100 * u(), 80 * u(), u());
    intensity[i] = static_cast<float>(i % 4000);
    time[i] = 1e-3 * static_cast<double>(i);
    classification[i] = post ? 5 : 2;
  }
  PointCloud cloud(std::move(p), {500'000, 5'400'000, 300});
  cloud.scale = Eigen::Vector3d::Constant(1e-3);
  cloud.set_column(arrays::intensity, std::move(intensity));
  cloud.set_column(arrays::time, std::move(time));
  cloud.set_column(arrays::classification, std::move(classification));
  cloud.set_column(arrays::return_number, one);
  cloud.set_column(arrays::number_of_returns, one);
  cloud.facts["las_gps_time"] = "standard";
  cloud.facts["sensor"] = "VLP-32C";
  return cloud;
}

using NumberedPlace = std::array<std::int64_t, 5>;
std::vector<NumberedPlace> numbered_places(const PointCloud& cloud, const CloudBounds& box = {}) {
  std::vector<NumberedPlace> out;
  const auto& intensity = cloud.values<float>(arrays::intensity);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d at = exact_position(cloud, i);
    if (box.contains(at))
      out.push_back({std::llround(1e3 * at.x()), std::llround(1e3 * at.y()), std::llround(1e3 * at.z()),
                     std::llround(intensity[i]),
                     std::llround(column_value(cloud.column(arrays::classification.name), i))});
  }
  std::ranges::sort(out);
  return out;
}

class CopcOctree : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    dir_ = new TempDir;
    cloud_ = new PointCloud(ground_with_posts());
    write_cloud(*dir_ / "a.copc.laz", *cloud_);
    write_cloud(*dir_ / "a.laz", *cloud_);
    // About a tenth of the points fit into memory.
    small_.memory_bytes = 2 << 20;
    small_.octree.node_points = 4000;
    copc::index_cloud(*dir_ / "a.laz", *dir_ / "b.copc.laz", *dir_ / "", small_);
  }
  static void TearDownTestSuite() {
    delete cloud_;
    delete dir_;
  }
  static TempDir* dir_;
  static PointCloud* cloud_;
  static copc::BuildOptions small_;
};
TempDir* CopcOctree::dir_ = nullptr;
PointCloud* CopcOctree::cloud_ = nullptr;
copc::BuildOptions CopcOctree::small_;

TEST_F(CopcOctree, BuiltOutOfMemoryItHoldsEveryPointOnce) {
  const auto all = read_cloud(*dir_ / "b.copc.laz");
  EXPECT_EQ(all.report.facts.at("format"), "COPC");
  EXPECT_EQ(numbered_places(all.cloud), numbered_places(*cloud_));
  EXPECT_EQ(all.cloud.facts.at("sensor"), "VLP-32C");
  EXPECT_EQ(all.cloud.facts.at("las_gps_time"), "standard");
  // Nothing stays of the work.
  for (const auto& entry : std::filesystem::directory_iterator(*dir_ / ""))
    EXPECT_TRUE(entry.is_regular_file()) << entry.path();
}

TEST_F(CopcOctree, ItsNodesLieInTheirCubesAndUpperLevelsAreEven) {
  const CopcTree tree(*dir_ / "b.copc.laz");
  std::uint64_t sum = 0;
  tree.look([&](const auto& nodes) {
    for (const auto& node : nodes) sum += node.points;
  });
  EXPECT_EQ(sum, octree_points);
  const Eigen::Vector3d step = Eigen::Vector3d::Constant(1e-3);
  int deepest = 0;
  for (std::uint32_t i = 0; i < tree.look([](const auto& nodes) { return nodes.size(); }); ++i) {
    const auto node = tree.node(i);
    deepest = std::max(deepest, node.level);
    if (node.points == 0) continue;
    std::vector<std::string> warnings;
    const auto cloud = tree.points(i, warnings);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(cloud.size(), node.points);
    const Eigen::Vector3d low = tree.low(node) - step, high = low.array() + tree.side(node) + 2 * step.x();
    std::map<std::array<int, 3>, int> cells;
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      const Eigen::Vector3d p = exact_position(cloud, k);
      EXPECT_TRUE((p.array() >= low.array()).all() && (p.array() <= high.array()).all());
      const Eigen::Array3d at = (p - tree.low(node)).array() / tree.spacing(node);
      ++cells[{static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())}];
    }
    // The upper nodes hold about one point of each cell.
    if (node.level < 2) {
      EXPECT_GT(cells.size(), 0.8 * static_cast<double>(cloud.size())) << node.level;
    }
  }
  EXPECT_GT(deepest, 4);
}

TEST_F(CopcOctree, EveryPointOfABoxIsGotOnce) {
  for (const char* name : {"a.copc.laz", "b.copc.laz"}) {
    const CopcTree tree(*dir_ / name);
    for (const char* text : {"500019.9,5400029.9,500020.3,5400030.2", "500000,5400000,300,500100,5400080,300.2",
                             "499000,5399000,501000,5401000"}) {
      CopcTree::Query query;
      query.box = *parse_bounds(text);
      Report report;
      EXPECT_EQ(numbered_places(tree.points_in(query, {}, &report)), numbered_places(*cloud_, query.box)) << text;
      EXPECT_THAT(report.findings, IsEmpty());
    }
    CopcTree::Query nowhere;
    nowhere.box = *parse_bounds("0,0,1,1");
    EXPECT_TRUE(tree.points_in(nowhere).empty());
  }
}

TEST_F(CopcOctree, ASpacingLeavesOutTheLevelsBelow) {
  const CopcTree tree(*dir_ / "b.copc.laz");
  std::size_t before = octree_points + 1;
  for (const double levels : {20.0, 3.0, 1.0, 0.0}) {
    CopcTree::Query query;
    query.spacing = tree.copc().spacing / std::pow(2, levels) * 1.001;
    const auto some = tree.points_in(query);
    EXPECT_LE(some.size(), before);
    EXPECT_GT(some.size(), 0U);
    before = some.size();
  }
  CopcTree::Query west;
  west.meets = [&](const Eigen::Vector3d& low, const Eigen::Vector3d&) { return low.x() < 500'010; };
  const auto in_west = tree.points_in(west);
  EXPECT_LT(in_west.size(), octree_points);
  west.box = *parse_bounds("499000,5399000,500009,5401000");
  EXPECT_EQ(numbered_places(tree.points_in(west)), numbered_places(*cloud_, west.box));
}

// Handfuls of points that lie close together: each has nodes of its own in every level, more than one page holds.
PointCloud handfuls() {
  PointCloud::Positions p(octree_points);
  for (std::size_t i = 0; i < octree_points; ++i) {
    Random place(5, 1, i / 30), random(5, 2, i);
    const auto near = [&] { return static_cast<float>(100 * place.uniform() + 0.02 * random.uniform()); };
    p[i] = {near(), near(), 0.02F * static_cast<float>(random.uniform())};
  }
  PointCloud cloud(std::move(p), {500'000, 5'400'000, 300});
  cloud.scale = Eigen::Vector3d::Constant(1e-3);
  return cloud;
}

TEST_F(CopcOctree, PagesAreReadWhenTheyAreNeeded) {
  auto fine = small_;
  fine.octree.node_points = 10;
  fine.octree.min_points = 2;
  write_cloud(*dir_ / "handfuls.laz", handfuls());
  const auto built = copc::index_cloud(*dir_ / "handfuls.laz", *dir_ / "fine.copc.laz", *dir_ / "", fine);
  ASSERT_GT(built.nodes, 4000U);
  const CopcTree tree(*dir_ / "fine.copc.laz");
  EXPECT_EQ(tree.pages_read(), 1U);
  const auto known = [&] { return tree.look([](const auto& nodes) { return nodes.size(); }); };
  EXPECT_LT(known(), built.nodes);
  CopcTree::Query corner;
  corner.box = *parse_bounds("500000,5400000,500010,5400010");
  EXPECT_GT(tree.points_in(corner).size(), 0U);
  const auto some = tree.pages_read();
  EXPECT_GT(some, 1U);
  EXPECT_LT(known(), built.nodes);
  EXPECT_EQ(tree.points_in({}).size(), octree_points);
  EXPECT_GT(tree.pages_read(), some);
  EXPECT_GE(known(), built.nodes);
  EXPECT_THAT(tree.damage(), IsEmpty());
}

TEST_F(CopcOctree, TheIndexIsTheSameAtAnyMemory) {
  auto large = small_;
  large.memory_bytes = 512 << 20;
  const auto built = copc::index_cloud(*dir_ / "a.laz", *dir_ / "large.copc.laz", *dir_ / "", large);
  EXPECT_EQ(built.points, octree_points);
  EXPECT_EQ(numbered_places(read_cloud(*dir_ / "large.copc.laz").cloud), numbered_places(*cloud_));
}

// The records of a LAS file, found by place.
TEST_F(CopcOctree, ASourceThatFindsRecordsByPlaceNeedsNoRoomOnDisk) {
  write_cloud(*dir_ / "a.las", *cloud_);
  const MappedFile file(*dir_ / "a.las");
  const auto info = las::parse_info(file.bytes());
  const auto stride = static_cast<std::size_t>(info.record_length);
  copc::RecordStream stream;
  stream.form = {info.point_format, stride, {info.scale, info.offset}, true};
  stream.points = info.points;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    stream.low[k] = static_cast<std::int32_t>(std::lround((info.min[axis] - info.offset[axis]) / info.scale[axis]));
    stream.high[k] = static_cast<std::int32_t>(std::lround((info.max[axis] - info.offset[axis]) / info.scale[axis]));
  }
  stream.within = [&](const std::array<std::int32_t, 3>& low, const std::array<std::int32_t, 3>& high) {
    std::vector<std::uint8_t> records;
    for (std::uint64_t i = 0; i < info.points; ++i) {
      const auto* record = file.bytes().data() + info.data_offset + i * stride;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = las::load<std::int32_t>(record + 4 * k);
        inside = inside && at >= low[k] && at <= high[k];
      }
      if (inside) records.insert(records.end(), record, record + stride);
    }
    return records;
  };
  copc::build_copc(*dir_ / "by_place.copc.laz", stream, *dir_ / "", small_);
  EXPECT_EQ(numbered_places(read_cloud(*dir_ / "by_place.copc.laz").cloud), numbered_places(*cloud_));
}

TEST_F(CopcOctree, RecordsOfOldFormatsAreTurned) {
  LasWriteOptions old;
  old.version = "1.2";
  old.packing = LasPacking::laz;
  write_las(*dir_ / "old.laz", *cloud_, old);
  copc::index_cloud(*dir_ / "old.laz", *dir_ / "turned.copc.laz", *dir_ / "", small_);
  const auto turned = read_cloud(*dir_ / "turned.copc.laz").cloud;
  EXPECT_EQ(numbered_places(turned), numbered_places(*cloud_));
  EXPECT_TRUE(turned.has(arrays::time) && turned.has(arrays::return_number));
}

TEST_F(CopcOctree, AHeaderWithTooSmallABoxCostsASecondLook) {
  const auto text = file_text(*dir_ / "a.laz");
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  las::store(&bytes[179], las::load<double>(&bytes[187]) + 1.0);  // the greatest x: a metre above the least
  std::ofstream(*dir_ / "lies.laz", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  copc::index_cloud(*dir_ / "lies.laz", *dir_ / "mended.copc.laz", *dir_ / "", small_);
  EXPECT_EQ(numbered_places(read_cloud(*dir_ / "mended.copc.laz").cloud), numbered_places(*cloud_));
}

TEST_F(CopcOctree, DamageIsToldAndTheRestIsThere) {
  const auto text = file_text(*dir_ / "b.copc.laz");
  const auto write = [&](const std::vector<std::uint8_t>& bytes) {
    std::ofstream(*dir_ / "damaged.copc.laz", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  const CopcTree whole(*dir_ / "b.copc.laz");
  const auto child = whole.node(1);
  ASSERT_GT(child.points, 0U);
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(child.begin) + 30,
            bytes.begin() + static_cast<std::ptrdiff_t>(child.end), std::uint8_t{0xff});
  write(bytes);
  {
    const CopcTree tree(*dir_ / "damaged.copc.laz");
    Report report;
    const auto rest = tree.points_in({}, {}, &report);
    EXPECT_GE(rest.size(), octree_points - child.points);
    EXPECT_TRUE(has_finding(report, finding_code::input_incomplete));
    std::vector<std::string> warnings;
    std::string said;
    try {
      tree.points(1, warnings);
    } catch (const Error& e) {
      said = e.what();
    }
    EXPECT_THAT(said + (warnings.empty() ? "" : warnings[0]), HasSubstr("can"));
    EXPECT_EQ(tree.points(2, warnings).size(), whole.node(2).points);
  }
  // Cut off: the hierarchy, which lies at the end, is gone.
  bytes.assign(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.size() / 2));
  write(bytes);
  EXPECT_THAT(error_of([&] { CopcTree tree(*dir_ / "damaged.copc.laz"); }), HasSubstr("damaged.copc.laz"));
  EXPECT_THAT(error_of([&] { CopcTree tree(*dir_ / "a.laz"); }), HasSubstr("is no COPC file"));
  EXPECT_THAT(error_of([&] { copc::index_cloud(*dir_ / "no.laz", *dir_ / "x.copc.laz", *dir_ / ""); }),
              HasSubstr("no.laz"));
}

}  // namespace
}  // namespace bole::io
