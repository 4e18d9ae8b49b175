#include "render/scene/point_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>

#include "render/scene/pick.h"
#include "render/scene/point_paint.h"

namespace bole::render {
namespace {

// A floor of 20 m with dense posts on it, the densities of which differ by a thousand.
PointCloud floor_with_posts(std::size_t points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  PointCloud::Positions p;
  for (std::size_t i = 0; i < points; ++i) {
    if (i % 2 == 0) {
      p.emplace_back(20 * unit(random), 20 * unit(random), 0.01f * unit(random));
    } else {
      const float angle = 6.2831853f * unit(random), post = std::floor(4 * unit(random));
      p.emplace_back(3 + 5 * post + 0.1f * std::cos(angle), 10 + 0.1f * std::sin(angle), 4 * unit(random));
    }
  }
  return PointCloud(std::move(p), {400000, 5600000, 300});
}

OctreeView from_above(double half_m, double height_px) {
  OctreeView view;
  view.height_px = height_px;
  view.world_to_clip.setZero();
  view.world_to_clip(0, 0) = view.world_to_clip(1, 1) = 1 / half_m;
  view.world_to_clip(2, 2) = -0.01, view.world_to_clip(3, 3) = 1;
  view.world_to_clip(0, 3) = view.world_to_clip(1, 3) = -10 / half_m;
  return view;
}

TEST(PointOctree, HoldsEveryFinitePointOnceWithinItsNode) {
  auto cloud = floor_with_posts(60'000);
  auto positions = cloud.positions();
  positions.push_back({std::nanf(""), 0, 0});
  cloud.set_positions(std::move(positions));
  const PointOctree tree(cloud);
  ASSERT_EQ(tree.size(), 60'000u);
  std::set<std::uint32_t> seen;
  for (const auto& node : tree.nodes())
    for (const auto i : tree.points(node)) {
      EXPECT_TRUE(seen.insert(i).second);
      const Eigen::Vector3f d = (cloud.positions()[i] - node.centre).cwiseAbs();
      ASSERT_LE(d.maxCoeff(), node.half_m * 1.001f + 1e-5f);
    }
  EXPECT_EQ(seen.size(), 60'000u);
}

TEST(PointOctree, ChildrenLieWithinTheirParentsAndAllAreReached) {
  const PointOctree tree(floor_with_posts(200'000));
  std::size_t reached = 1;
  for (const auto& node : tree.nodes())
    for (std::uint32_t c = 0; c < node.children; ++c, ++reached) {
      const auto& child = tree.nodes()[node.first_child + c];
      EXPECT_EQ(child.level, node.level + 1);
      EXPECT_LE((child.centre - node.centre).cwiseAbs().maxCoeff(), node.half_m);
    }
  EXPECT_EQ(reached, tree.nodes().size());
}

TEST(PointOctree, ANodeHoldsAtMostOnePointOfEachCell) {
  const auto cloud = floor_with_posts(200'000);
  const PointOctree tree(cloud);
  const auto& root = tree.nodes().front();
  std::set<std::array<int, 3>> cells;
  for (const auto i : tree.points(root)) {
    const Eigen::Vector3f cell =
        ((cloud.positions()[i] - root.centre).array() + root.half_m) / (2 * root.half_m) * PointOctree::cells_per_side;
    EXPECT_TRUE(cells.insert({int(cell.x()), int(cell.y()), int(cell.z())}).second);
  }
  EXPECT_GT(cells.size(), 3'000u);  // the floor alone has 64 x 64 cells, of which most hold a point
}

TEST(PointOctree, KeepsTheBudgetAndRefinesWhatIsNear) {
  const PointOctree tree(floor_with_posts(400'000));
  const auto count = [&](const std::vector<std::uint32_t>& nodes) {
    std::size_t n = 0;
    for (const auto i : nodes) n += tree.nodes()[i].size();
    return n;
  };
  for (const std::size_t budget : {30'000, 100'000, 300'000})
    EXPECT_LE(count(tree.visible(from_above(11, 1000), budget, 0.1)), budget);
  EXPECT_EQ(count(tree.visible(from_above(11, 1000), 1'000'000, 0)), 400'000u);
  // A window of one metre shows a small part of the cloud in full detail.
  const auto near = tree.visible(from_above(0.5, 1000), 1'000'000, 0);
  EXPECT_LT(count(near), 120'000u);
  EXPECT_TRUE(tree.visible(from_above(0.001, 1000), 0, 0).empty());
}

TEST(PointOctree, FindsThePointsOfABox) {
  const auto cloud = floor_with_posts(50'000);
  const PointOctree tree(cloud);
  const Eigen::Vector3f lo(2, 9, 1), hi(4, 11, 2);
  auto found = tree.in_box(lo, hi);
  std::ranges::sort(found);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (const auto& p = cloud.positions()[i]; (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all())
      expected.push_back(i);
  ASSERT_GT(expected.size(), 1000u);
  EXPECT_EQ(found, expected);
}

TEST(PointOctree, TakesEmptyAndCoincidentPoints) {
  EXPECT_TRUE(PointOctree(PointCloud()).nodes().empty());
  EXPECT_TRUE(PointOctree(PointCloud()).visible(from_above(1, 100), 10, 1).empty());
  const PointOctree same(PointCloud(PointCloud::Positions(1000, Eigen::Vector3f(1, 2, 3))));
  EXPECT_EQ(same.size(), 1000u);
}

TEST(PointOctree, ASampleIsAnEvenShareWithinTheBudget) {
  const auto cloud = floor_with_posts(400'000);
  const auto sample = PointOctree::sample(cloud, 20'000);
  EXPECT_NEAR(static_cast<double>(sample.size()), 20'000, 500);
  std::set<std::uint32_t> seen;
  double posts = 0;
  for (const auto& node : sample.nodes())
    for (const auto i : sample.points(node)) {
      EXPECT_TRUE(seen.insert(i).second);
      posts += i % 2;
    }
  EXPECT_NEAR(posts / static_cast<double>(seen.size()), 0.5, 0.03);  // as in the cloud
  std::size_t drawn = 0;
  for (const auto i : sample.visible(from_above(12, 1000), 5000, 0.7)) drawn += sample.nodes()[i].size();
  EXPECT_GT(drawn, 4000u);
  EXPECT_LE(drawn, 5000u);
  EXPECT_TRUE(PointOctree::sample(PointCloud(), 10).nodes().empty());
  EXPECT_EQ(PointOctree::sample(floor_with_posts(7), 100).size(), 7u);
}

TEST(PointOctree, NothingBeyondAClipBoxIsChosen) {
  const PointOctree tree(floor_with_posts(400'000));
  auto view = from_above(12, 4000);
  const auto all = tree.visible(view, 1'000'000, 0.7).size();
  view.lo = {0, 0, -1}, view.hi = {4, 4, 5};
  const auto chosen = tree.visible(view, 1'000'000, 0.7);
  EXPECT_LT(chosen.size(), all);
  for (const auto i : chosen) {
    const auto& node = tree.nodes()[i];
    EXPECT_TRUE((node.centre.array() - node.half_m <= view.hi.array()).all());
  }
}

TEST(PointOctree, BuildingCanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(PointOctree(floor_with_posts(1000), run), Error);
}

TEST(Pick, TakesTheForemostPoint) {
  PointCloud cloud(PointCloud::Positions{{10, 10, 0}, {10, 10, 5}, {10.5f, 10, 5}}, {1000, 2000, 0});
  const auto view = from_above(10, 200);
  const PickView pick{view.world_to_clip, cloud.origin, 200, 200};
  const std::vector<std::uint32_t> all{0, 1, 2};
  EXPECT_EQ(pick_point(pick, cloud, all, {100, 100}, 4), 1u);  // seen from above: z = 5 hides z = 0
  EXPECT_EQ(pick_point(pick, cloud, all, {105, 100}, 3), 2u);
  EXPECT_FALSE(pick_point(pick, cloud, all, {50, 50}, 4));

  // A box is near wherever one of its points may be.
  Eigen::AlignedBox3d box;
  for (const auto i : all) box.extend(cloud.position(i));
  EXPECT_TRUE(may_be_near(pick, box, {100, 100}, 4));
  EXPECT_TRUE(may_be_near(pick, box, {105, 100}, 3));
  EXPECT_FALSE(may_be_near(pick, box, {2, 2}, 4));
  EXPECT_TRUE(may_be_near(pick, box, {2, 2}, 400));
  const auto foot = on_plane(pick, {105, 100}, 5);
  ASSERT_TRUE(foot);
  EXPECT_NEAR((*foot - cloud.position(2)).norm(), 0, 1e-6);
}

// A pinhole 30 m south of the posts and 2 m above the floor, looking north.
PickView from_the_south(const Eigen::Vector3d& origin) {
  constexpr double near = 0.5, far = 80, tan_half = 0.4;
  Eigen::Matrix4d eye = Eigen::Matrix4d::Identity(), lens = Eigen::Matrix4d::Zero();
  eye.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // right, up, back
  eye.topRightCorner<3, 1>() = -eye.topLeftCorner<3, 3>() * Eigen::Vector3d(10, -20, 2);
  lens(0, 0) = lens(1, 1) = 1 / tan_half;
  lens(2, 2) = -(far + near) / (far - near), lens(2, 3) = -2 * far * near / (far - near);
  lens(3, 2) = -1;
  return {lens * eye, origin, 200, 200};
}

// Looking into the foremost sets only finds what looking into all of them does.
TEST(Pick, OfManySetsIsThatOfAllTheirPoints) {
  const auto cloud = std::make_shared<const PointCloud>(floor_with_posts(40'000));
  std::map<std::pair<int, int>, PointSet> tiles;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < cloud->size(); ++i) {
    const auto& p = cloud->positions()[i];
    auto& tile = tiles[{static_cast<int>(p.x() / 2), static_cast<int>(p.y() / 2)}];
    tile.cloud = cloud;
    tile.indices.push_back(i);
    tile.box.extend(cloud->position(i));
    all.push_back(i);
  }
  std::vector<PointSet> sets;
  for (auto& [place, tile] : tiles) sets.push_back(tile);
  sets[7].box.setEmpty();  // not known
  int found = 0;
  const PickView parallel{from_above(10, 200).world_to_clip, cloud->origin, 200, 200};
  for (const auto& view : {from_the_south(cloud->origin), parallel})
    for (double x = 3; x < 200; x += 7)
      for (double y = 3; y < 200; y += 7) {
        const auto whole = pick_point(view, *cloud, all, {x, y}, 3);
        const auto parts = pick_point(view, sets, {x, y}, 3);
        ASSERT_EQ(whole.has_value(), parts.has_value()) << x << ' ' << y;
        if (!whole) continue;
        EXPECT_EQ(*whole, parts->index) << x << ' ' << y;
        ++found;
      }
  EXPECT_GT(found, 600);
}

TEST(Pick, FindsAStemByItsRadius) {
  StemShape stem;
  stem.tree_id = 7, stem.axis = {{10, 10, 0}, {10, 10, 5}}, stem.radius_m = {0.5, 0.5};
  const PickView pick{from_above(10, 200).world_to_clip, Eigen::Vector3d::Zero(), 200, 200};
  ASSERT_TRUE(pick_stem(pick, {stem}, {104, 100}, 0));
  EXPECT_EQ(pick_stem(pick, {stem}, {104, 100}, 0)->tree_id, 7);
  EXPECT_FALSE(pick_stem(pick, {stem}, {108, 100}, 0));
}

TEST(Pick, TellsWhatIsKnownOfAPoint) {
  PointCloud cloud(PointCloud::Positions{{1, 2, 3}}, {100, 200, 0});
  EXPECT_EQ(describe_point(cloud, 0), std::vector<std::string>{"x 101.000  y 202.000  z 3.000 m"});
  cloud.set_column(arrays::height_above_ground, std::vector<float>{1.234f});
  cloud.set_column(arrays::range, std::vector<float>{7.5f});
  cloud.set_column(arrays::time, std::vector<double>{12.5});
  const auto lines = describe_point(cloud, 0);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1], "above ground 1.23 m");
  EXPECT_EQ(lines[2], "range 7.50 m");
  EXPECT_EQ(lines[3], "time 12.500 s");
}

TEST(PointPaint, OffersWhatTheCloudHas) {
  PointCloud cloud(PointCloud::Positions(100, Eigen::Vector3f::Zero()));
  EXPECT_EQ(paintable_arrays(cloud), std::vector<std::string>{"z"});
  std::vector<float> heights(100);
  std::iota(heights.begin(), heights.end(), 0.0f);
  cloud.set_column(arrays::height_above_ground, heights);
  cloud.set_column(arrays::pass, std::vector<std::int32_t>(100, 1));
  EXPECT_EQ(paintable_arrays(cloud).front(), "height_above_ground");
  const auto paint = paint_by(cloud, "height_above_ground");
  EXPECT_EQ(paint.title, "height above ground (m)");
  EXPECT_EQ(paint.range.lo, 0);
  EXPECT_EQ(paint_by(cloud, "pass").kind, PointPaint::Kind::ids);
  EXPECT_EQ(paint_by(cloud, "no such").array, "z");
  std::vector<std::uint8_t> rgb(300);
  std::vector<std::uint32_t> all(100);
  std::iota(all.begin(), all.end(), 0u);
  paint_points(cloud, all, paint, rgb.data());
  const auto top = ColorMap::viridis().at(1);
  EXPECT_NEAR(rgb[297], 255 * top.r, 1.5);
  EXPECT_NEAR(rgb[298], 255 * top.g, 1.5);
}

}  // namespace
}  // namespace bole::render
