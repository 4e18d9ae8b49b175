#include "rows/core/frame/trunk_centres.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/no_number.h"
#include "base/statistics.h"
#include "rows/core/frame/face_finder.h"
#include "rows/core/frame/mean_shift.h"

namespace bole::rows {
namespace {

struct RoughTrunk {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  std::int64_t layers = 0;
  std::vector<Eigen::Vector3d> points;
};

using Layers = std::map<std::int64_t, std::vector<Eigen::Vector3d>>;

// Mean of the points of layers that are no wider than a trunk (eq. 7).
RoughTrunk rough_trunk(const Layers& by_height, const TrunkOptions& o) {
  RoughTrunk t;
  for (const auto& [height, layer] : by_height) {
    Eigen::Vector2d lo = layer.front().head<2>(), hi = lo;
    for (const auto& p : layer) {
      lo = lo.cwiseMin(p.head<2>());
      hi = hi.cwiseMax(p.head<2>());
    }
    if (hi.x() - lo.x() > o.max_extent_x || hi.y() - lo.y() > o.max_extent_y) continue;
    ++t.layers;
    for (const auto& p : layer) {
      t.centre += p.head<2>();
      t.points.push_back(p);
    }
  }
  if (!t.points.empty()) t.centre /= static_cast<double>(t.points.size());
  return t;
}

using Plants = std::map<std::int32_t, Layers>;

std::vector<FoundTrunk> trunks_by_mean(const Plants& plants, const TrunkOptions& o, std::int64_t& without) {
  std::vector<FoundTrunk> trunks;
  for (const auto& [plant, by_height] : plants)
    if (auto rough = rough_trunk(by_height, o); rough.layers >= o.min_layers)
      trunks.push_back(
          {rough.centre, no_number, plant, rough.layers, std::ssize(rough.points), std::move(rough.points)});
    else
      ++without;
  return trunks;
}

std::vector<FoundTrunk> trunks_by_face(const Plants& plants, const PointCloud& dense, const TrunkOptions& o,
                                       std::int64_t& without) {
  struct Cluster {
    std::int32_t plant;
    Eigen::Vector2d middle;
    double foot, top;
  };
  std::vector<Cluster> clusters;
  for (const auto& [plant, by_height] : plants) {
    std::vector<double> x, y;
    for (const auto& [height, layer] : by_height)
      for (const auto& p : layer) {
        x.push_back(p.x());
        y.push_back(p.y());
      }
    clusters.push_back({plant,
                        {upper_median(x), upper_median(y)},
                        static_cast<double>(by_height.begin()->first) * o.layer_height,
                        static_cast<double>(by_height.rbegin()->first + 1) * o.layer_height});
  }
  const FaceFinder finder(dense, o);
  std::vector<FoundTrunk> trunks;
  for (const auto& c : clusters) {
    // Leaves may split a trunk into several clusters, so it is searched between the lowest and highest of those nearby.
    double foot = c.foot, top = c.top;
    for (const auto& other : clusters)
      if ((other.middle - c.middle).norm() < 2 * o.reach) {
        foot = std::min(foot, other.foot);
        top = std::max(top, other.top);
      }
    if (auto found = finder.find(c.plant, c.middle, foot, top))
      trunks.push_back(std::move(*found));
    else
      ++without;
  }
  trunks = finder.distinct(std::move(trunks));
  FaceFinder::uncover(trunks);
  without += static_cast<std::int64_t>(
      std::erase_if(trunks, [&](const FoundTrunk& t) { return t.diameter_cm < 100 * o.min_diameter; }));
  return trunks;
}

// The points of the trunks with the number of their plant.
PointCloud cloud_of(const std::vector<FoundTrunk>& trunks, const PointCloud& like) {
  PointCloud::Positions positions;
  std::vector<std::int32_t> plant;
  for (const auto& t : trunks)
    for (const auto& p : t.shown) {
      positions.push_back((p - like.origin).cast<float>());
      plant.push_back(static_cast<std::int32_t>(t.plant));
    }
  PointCloud cloud(std::move(positions), like.origin);
  cloud.axes = like.axes;
  cloud.crs_wkt = like.crs_wkt;
  cloud.set_column(plant_column, std::move(plant));
  return cloud;
}

Table table_of(const std::vector<FoundTrunk>& trunks, const PointCloud& like) {
  std::vector<double> x, y, diameter;
  std::vector<std::int64_t> id, layers, points;
  for (const auto& t : trunks) {
    x.push_back(t.centre.x());
    y.push_back(t.centre.y());
    diameter.push_back(t.diameter_cm);
    id.push_back(t.plant);
    layers.push_back(t.layers);
    points.push_back(t.points);
  }
  Table t;
  t.set("tree_id", id);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("layers", layers);
  t.set("points", points);
  t.set("diameter_cm", diameter);
  t.facts["axes"] = std::string(axes_name(like.axes));
  if (!like.crs_wkt.empty()) t.facts["crs"] = like.crs_wkt;
  return t;
}

}  // namespace

FoundTrunks trunk_centres(const PointCloud& plants, const PointCloud* dense, const TrunkOptions& o, Report& report) {
  const bool face = o.centre == TrunkCentre::face;
  if (face && dense == nullptr)
    throw bad_input("centre is face and the input dense is not connected", "the levelled frame before it was thinned",
                    "Connect dense to the output of rows.region, or set centre to mean");
  const auto& label = plants.values<std::int32_t>(plant_column);
  std::map<std::int32_t, Layers> layers;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (const Eigen::Vector3d p = plants.position(i); label[i] > 0 && p.allFinite())
      layers[label[i]][static_cast<std::int64_t>(std::floor(p.z() / o.layer_height))].push_back(p);

  std::int64_t without = 0;
  auto trunks = face ? trunks_by_face(layers, *dense, o, without) : trunks_by_mean(layers, o, without);
  const auto cut = std::erase_if(trunks, [&](const FoundTrunk& t) { return t.centre.y() < o.min_ahead; });
  if (cut > 0) report.counts["too_near"] = static_cast<std::int64_t>(cut);
  if (without > 0)
    report.warn(face ? fmt::format("{} clusters hold no trunk of {:g} m or more", without, o.min_height)
                     : fmt::format("{} clusters have fewer than {} trunk layers and are not plants: raise max_extent_x "
                                   "and max_extent_y where "
                                   "trunks are thicker",
                                   without, o.min_layers));
  report.counts["plants"] = std::ssize(trunks);
  report.message = fmt::format("{} plants", trunks.size());
  return {table_of(trunks, plants), cloud_of(trunks, plants)};
}

}  // namespace bole::rows
