#include "features/clouds/near_on_disk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace bole::desktop {
namespace {

using Query = io::copc::CopcTree::Query;

constexpr double min_searched_m = 0.1;
constexpr double finest_share = 1.0 / 65536;  // of the spacing of the root: no file has so many levels

Eigen::AlignedBox3d box_of(const PointCloud& cloud) {
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud.positions())
    if (p.allFinite()) box.extend(p.cast<double>());
  return box.isEmpty() ? box : box.translated(cloud.origin);
}

// In the coordinates of the file: around the corners of the box, wherever `place` turned it from.
Query about_box(const Eigen::AlignedBox3d& world, double margin_m, const render::CloudPlace& place) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(margin_m);
  const Eigen::AlignedBox3d wide(world.min() - margin, world.max() + margin);
  Eigen::AlignedBox3d own;
  for (int k = 0; k < 8; ++k) own.extend(place.back(wide.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k))));
  return {.box = {own.min(), own.max()}};
}

// Down to a level of which there are few enough.
Query thinned(Query query, const io::copc::CopcTree& tree, std::size_t max_points, const Run& run) {
  const double coarsest = tree.copc().spacing;
  if (tree.max_points_in(query, run) <= max_points) return query;
  query.spacing = coarsest * finest_share;
  while (query.spacing < coarsest && tree.max_points_in(query, run) > max_points) query.spacing *= 2;
  return query;
}

void add_positions(const PointCloud& cloud, const Eigen::Vector3d& origin, PointCloud::Positions& positions) {
  positions.reserve(positions.size() + cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) positions.push_back((cloud.position(i) - origin).cast<float>());
}

}  // namespace

NearOnDisk near_on_disk(const DiskPoints& disk, const render::CloudPlace& place, const PointCloud& about,
                        double margin_m, std::size_t max_points, const Run& run) {
  const auto& tree = disk.tree();
  const auto world = box_of(about);
  if (world.isEmpty()) return {std::make_shared<const PointCloud>()};
  NearOnDisk found;
  std::vector<Query> queries{about_box(world, margin_m, place)};
  if (tree.max_points_in(queries[0], run) > max_points) {
    found.all_within_m = margin_m;
    Query near = queries[0];
    while (found.all_within_m > min_searched_m && tree.max_points_in(near, run) > max_points / 2)
      near = about_box(world, found.all_within_m /= 2, place);
    near = thinned(near, tree, max_points / 2, run);
    if (near.spacing > 0) found.all_within_m = 0;
    queries = {near, thinned(queries[0], tree, max_points / 2, run)};
    found.spacing_m = place.scale * std::max(near.spacing, queries[1].spacing);
  }
  PointCloud::Positions positions;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const auto& query : queries) {
    const auto placed = render::placed_cloud(*disk.points_in(query, run), place);
    if (positions.empty()) origin = placed.origin;
    add_positions(placed, origin, positions);
  }
  found.points = std::make_shared<const PointCloud>(std::move(positions), origin);
  return found;
}

}  // namespace bole::desktop
