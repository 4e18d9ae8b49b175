#include "rows/core/frame/frame_plants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "base/angles.h"
#include "base/error.h"
#include "base/statistics.h"
#include "rows/core/frame/trunk_face.h"
#include "rows/core/rows/plant_grid.h"

namespace bole::rows {
namespace {

constexpr int max_shifts = 200;
constexpr double still = 1e-4;  // of the bandwidth

}  // namespace

PointCloud mean_shift(const PointCloud& frame, const MeanShiftOptions& o, const Run& run) {
  Points2 plan;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    plan.push_back(frame.position(i).head<2>());
    if (!plan.back().allFinite())
      throw bad_input(fmt::format("point {} is not finite", i), "finite points", "Cut a region first: it drops them");
  }
  const PlantGrid grid(plan);
  Points2 modes;
  std::vector<std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    run.check_cancel();
    Eigen::Vector2d at = plan[i];
    for (int k = 0; k < max_shifts; ++k) {
      Eigen::Vector2d shift = Eigen::Vector2d::Zero();
      const auto near = grid.within(at, o.bandwidth);
      for (const int j : near) shift += (plan[static_cast<std::size_t>(j)] - at) / static_cast<double>(near.size());
      at += shift;
      if (shift.norm() < still * o.bandwidth) break;
    }
    std::size_t m = 0;
    while (m < modes.size() && (modes[m] - at).norm() > o.bandwidth / 2) ++m;
    if (m == modes.size()) {
      modes.push_back(at);
      members.emplace_back();
    }
    members[m].push_back(i);
  }
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (std::ssize(members[m]) >= o.min_points) order.push_back(m);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(modes[a].x(), modes[a].y()) < std::pair(modes[b].x(), modes[b].y());
  });
  std::vector<std::int32_t> plant(plan.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k)
    for (const auto i : members[order[k]]) plant[i] = static_cast<std::int32_t>(k) + 1;
  PointCloud out = frame;
  out.set_column(plant_column, std::move(plant));
  return out;
}

namespace {

struct RoughTrunk {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  std::int64_t layers = 0, points = 0;
};

using Layers = std::map<std::int64_t, std::vector<Eigen::Vector2d>>;

// Mean of the points of layers that are no wider than a trunk (eq. 7).
RoughTrunk rough_trunk(const Layers& by_height, const TrunkOptions& o) {
  RoughTrunk t;
  for (const auto& [height, layer] : by_height) {
    Eigen::Vector2d lo = layer.front(), hi = lo;
    for (const auto& p : layer) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    if (hi.x() - lo.x() > o.max_extent_x || hi.y() - lo.y() > o.max_extent_y) continue;
    ++t.layers;
    for (const auto& p : layer) {
      t.centre += p;
      ++t.points;
    }
  }
  if (t.points > 0) t.centre /= static_cast<double>(t.points);
  return t;
}

struct FoundTrunk {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double diameter_cm = std::numeric_limits<double>::quiet_NaN();
  std::int64_t plant = 0, layers = 0, points = 0;
};

// The trunks behind their faces, from the dense frame.
class FaceFinder {
 public:
  FaceFinder(const PointCloud& dense, const TrunkOptions& o)
      : dense_(dense), o_(o), widest_(std::max(o.max_extent_x, o.max_extent_y)) {}

  // `foot` and `top`: heights between which the trunk is looked for.
  std::optional<FoundTrunk> find(std::int32_t plant, const Eigen::Vector2d& middle, double foot, double top) const {
    const auto strip =
        find_upright(about(middle, o_.reach + widest_ / 2, foot, top), widest_, o_.range_sigma, o_.layer_height / 2);
    if (strip.high_m - strip.low_m < o_.min_height || strip.filled < o_.min_filled) return {};
    const auto near = about(strip.at, widest_ / 2 + 4 * o_.range_sigma, strip.low_m, strip.high_m);
    const auto fit = fit_trunk_face(near, strip.at, widest_, o_.range_sigma);
    // Too few points may remain visible behind a nearer trunk.
    if (!fit) return FoundTrunk{strip.at, 0, plant, strip.layers, std::ssize(near)};
    return FoundTrunk{fit->centre, 200 * fit->radius_m, plant, strip.layers, fit->points};
  }

  // A nearer trunk may hide one side of another: where a thin strip begins at the edge of a nearer one, the edge that
  // is seen and the usual radius of the frame tell the axis.
  void uncover(std::vector<FoundTrunk>& trunks) const {
    if (trunks.size() < 3) return;
    std::vector<double> radii;
    for (const auto& t : trunks) radii.push_back(t.diameter_cm / 200);
    const double usual = upper_median(radii);
    const auto seen = trunks;
    for (auto& t : trunks) {
      const double r = t.diameter_cm / 200, range = t.centre.norm(), bearing = std::atan2(t.centre.x(), t.centre.y());
      if (r > hidden_share * usual) continue;
      for (const auto& near : seen) {
        const double near_range = near.centre.norm(), near_half = near.diameter_cm / 200 / near_range;
        if (near_range > range - 2 * usual) continue;
        const double apart =
            std::remainder(bearing - std::atan2(near.centre.x(), near.centre.y()), 2 * std::numbers::pi);
        if (std::abs(std::abs(apart) - near_half - r / range) > 0.3 * usual / range) continue;
        // The hidden part lies towards the nearer trunk.
        const Eigen::Vector2d ahead = t.centre / range, right(ahead.y(), -ahead.x());
        const double aside = usual - r, face = range - std::numbers::pi / 4 * r;
        t.centre = (face + std::sqrt(usual * usual - aside * aside)) * ahead - std::copysign(aside, apart) * right;
        t.diameter_cm = 200 * usual;
        break;
      }
    }
  }

  // Clusters of leaves beside a trunk lead to the same trunk: the one of most layers stays.
  std::vector<FoundTrunk> distinct(std::vector<FoundTrunk> trunks) const {
    std::stable_sort(trunks.begin(), trunks.end(), [](const auto& a, const auto& b) {
      return std::pair(a.layers, a.points) > std::pair(b.layers, b.points);
    });
    std::vector<FoundTrunk> kept;
    for (const auto& t : trunks)
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const auto& k) { return (k.centre - t.centre).norm() < 1.2 * widest_; }))
        kept.push_back(t);
    std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.plant < b.plant; });
    return kept;
  }

 private:
  static constexpr double hidden_share = 0.65;  // of the usual radius: thinner strips may be hidden in part
  std::vector<Eigen::Vector3d> about(const Eigen::Vector2d& at, double reach_m, double low_m, double high_m) const {
    std::vector<Eigen::Vector3d> points;
    const Eigen::Vector3f centre =
        Eigen::Vector3d(at.x() - dense_.origin.x(), at.y() - dense_.origin.y(), 0).cast<float>();
    const auto reach = static_cast<float>(reach_m);
    for (std::size_t i = 0; i < dense_.size(); ++i) {
      const auto& q = dense_.positions()[i];
      if (std::abs(q.x() - centre.x()) > reach || std::abs(q.y() - centre.y()) > reach) continue;
      const Eigen::Vector3d p = dense_.position(i);
      if (p.z() > low_m && p.z() < high_m && (p.head<2>() - at).norm() < reach_m) points.push_back(p);
    }
    return points;
  }

  const PointCloud& dense_;
  const TrunkOptions& o_;
  double widest_;
};

using Plants = std::map<std::int32_t, Layers>;

std::vector<FoundTrunk> trunks_by_mean(const Plants& plants, const TrunkOptions& o, std::int64_t& without) {
  std::vector<FoundTrunk> trunks;
  for (const auto& [plant, by_height] : plants)
    if (const auto rough = rough_trunk(by_height, o); rough.layers >= o.min_layers)
      trunks.push_back({rough.centre, std::numeric_limits<double>::quiet_NaN(), plant, rough.layers, rough.points});
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
    if (const auto found = finder.find(c.plant, c.middle, foot, top))
      trunks.push_back(*found);
    else
      ++without;
  }
  trunks = finder.distinct(std::move(trunks));
  finder.uncover(trunks);
  without += static_cast<std::int64_t>(
      std::erase_if(trunks, [&](const FoundTrunk& t) { return t.diameter_cm < 100 * o.min_diameter; }));
  return trunks;
}

}  // namespace

Table trunk_centres(const PointCloud& plants, const PointCloud* dense, const TrunkOptions& o, Report& report) {
  const bool face = o.centre == TrunkCentre::face;
  if (face && dense == nullptr)
    throw bad_input("centre is face and the input dense is not connected", "the levelled frame before it was thinned",
                    "Connect dense to the output of rows.region, or set centre to mean");
  const auto& label = plants.values<std::int32_t>(plant_column);
  std::map<std::int32_t, Layers> layers;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (const Eigen::Vector3d p = plants.position(i); label[i] > 0 && p.allFinite())
      layers[label[i]][static_cast<std::int64_t>(std::floor(p.z() / o.layer_height))].push_back(p.head<2>());

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
  std::vector<double> x, y, diameter;
  std::vector<std::int64_t> id, trunk_layers, points;
  for (const auto& t : trunks) {
    x.push_back(t.centre.x());
    y.push_back(t.centre.y());
    diameter.push_back(t.diameter_cm);
    id.push_back(t.plant);
    trunk_layers.push_back(t.layers);
    points.push_back(t.points);
  }
  report.counts["plants"] = std::ssize(x);
  report.message = fmt::format("{} plants", x.size());
  Table t;
  t.set("tree_id", id);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("layers", trunk_layers);
  t.set("points", points);
  t.set("diameter_cm", diameter);
  t.facts["axes"] = std::string(axes_name(plants.axes));
  if (!plants.crs_wkt.empty()) t.facts["crs"] = plants.crs_wkt;
  return t;
}

Table place_stems(const Table& stems, const PlaceOptions& options, const Table* pose) {
  const bool by_hand = options.x != 0 || options.y != 0 || options.yaw_deg != 0;
  PlaceOptions o = options;
  if (pose != nullptr) {
    if (by_hand)
      throw bad_input("the place of the sensor is given twice, by the options and by its marks", "one of the two",
                      "Leave out x, y and yaw");
    if (pose->rows() != 1) throw bad_input(fmt::format("{} poses of the sensor", pose->rows()), "one");
    o = {pose->numbers("x_m")[0], pose->numbers("y_m")[0], pose->numbers("yaw_deg")[0]};
    if (!std::isfinite(o.x + o.y + o.yaw_deg)) throw bad_input("the pose of the sensor is not finite", "numbers");
  }
  const double c = std::cos(o.yaw_deg * rad_per_deg), s = std::sin(o.yaw_deg * rad_per_deg);
  auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double px = x[i], py = y[i];
    x[i] = o.x + c * px - s * py;
    y[i] = o.y + s * px + c * py;
  }
  Table placed = stems;
  placed.set("x_m", std::move(x));
  placed.set("y_m", std::move(y));
  // Without a place the axes stay those of the frame, whose y need not point north.
  if (by_hand || pose != nullptr) placed.facts["axes"] = "global";
  if (pose == nullptr) return placed;
  if (const auto crs = pose->facts.find("crs"); crs != pose->facts.end()) placed.facts["crs"] = crs->second;
  if (pose->has("yaw_se_deg")) placed.facts["yaw_se_deg"] = number_text(pose->numbers("yaw_se_deg")[0]);
  return placed;
}

}  // namespace bole::rows
