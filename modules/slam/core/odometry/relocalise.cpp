#include "slam/core/odometry/relocalise.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/angles.h"

namespace bole::slam {
namespace {

// How far a walking person may be from the prediction.
constexpr double initial_reach = 0.5, reach_per_s = 1.0, max_reach = 5;
constexpr double initial_turn_rad = radians(10), turn_rad_per_s = radians(120);
constexpr double expected_sigma = 0.3, expected_sigma_per_s = 0.5;
constexpr double step_size = 0.6, step_rad = radians(10);
constexpr int scored_level = 2;
constexpr std::size_t scored_points = 400, tried_points = 1500;
constexpr std::size_t max_tried = 16, max_registered = 4;
constexpr double min_apart = 0.5, min_apart_rad = radians(8);
constexpr double max_prediction_s = 2;

struct Place {
  Pose T_map_sensor = Pose::Identity();  // in the middle of the frame
  double score = 0;
};

bool apart(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() > min_apart ||
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() > min_apart_rad;
}

std::vector<FeaturePoint> every_so_many(const std::vector<FeaturePoint>& points, std::size_t all,
                                        std::size_t max_count) {
  const std::size_t step = std::max<std::size_t>(1, (all + max_count - 1) / max_count);
  std::vector<FeaturePoint> out;
  for (std::size_t i = 0; i < points.size(); i += step) out.push_back(points[i]);
  return out;
}

FeatureSet thinned(const FeatureSet& features, std::size_t max_count) {
  return {every_so_many(features.edges, features.size(), max_count),
          every_so_many(features.planes, features.size(), max_count)};
}

Pose ahead(const LastSeen& last) {
  return last.T_map_sensor * se3_exp(last.velocity * std::min(last.since_s, max_prediction_s));
}

// How much more likely the walk is to have led to one place than to the other.
double preference(const LastSeen& last, const Pose& to, const Pose& other) {
  const Eigen::Vector3d expected = ahead(last).translation();
  const double sigma = expected_sigma + expected_sigma_per_s * last.since_s,
               squared = (to.translation() - expected).squaredNorm() - (other.translation() - expected).squaredNorm();
  return std::clamp(std::exp(-0.5 * squared / (sigma * sigma)), 1e-3, 1e3);
}

std::vector<Place> reachable(const LastSeen& last) {
  const Pose T_ahead = ahead(last);
  const double reach = std::min(initial_reach + reach_per_s * last.since_s, max_reach),
               turn = std::min(initial_turn_rad + turn_rad_per_s * last.since_s, std::numbers::pi);
  const int steps = static_cast<int>(std::ceil(reach / step_size)),
            turns = static_cast<int>(std::ceil(turn / step_rad));
  std::vector<Place> places;
  for (int ix = -steps; ix <= steps; ++ix)
    for (int iy = -steps; iy <= steps; ++iy) {
      const Eigen::Vector3d offset(ix * step_size, iy * step_size, 0);
      if (offset.norm() > reach + 0.5 * step_size) continue;
      for (int it = -turns; it <= turns; ++it) {
        Place place;
        place.T_map_sensor.linear() = rotation_from_rpy(0, 0, it * step_rad) * T_ahead.linear();
        place.T_map_sensor.translation() = T_ahead.translation() + offset;
        places.push_back(place);
      }
    }
  return places;
}

// Likelihood of a point under the map, 0 to 1.
double likeness(const DistributionMap& map, const Eigen::Vector3d& x) {
  const auto surface = map.surface(x, scored_level);
  if (!surface) return 0;
  const double softest = 0.1;
  const Eigen::Vector3d off =
      (surface->axes.transpose() * (x - surface->mean)).array() / surface->deviations.array().max(softest);
  return std::exp(-0.5 * off.squaredNorm());
}

// Sets the scores and returns the best places, all separate from each other.
std::vector<Place> best_of(std::vector<Place> places, const FeatureSet& features, const FeatureMaps& maps,
                           const Vector6d& velocity, double span_s, const Run& run) {
  const FeatureSet few = thinned(features, scored_points);
  const PoseGrid within(motion_about(Pose::Identity(), velocity, span_s));
  std::vector<Eigen::Vector3d> edges, planes;  // sensor axes in the middle of the frame
  for (const auto& p : few.edges) edges.push_back(within.in_map(p.position, p.s));
  for (const auto& p : few.planes) planes.push_back(within.in_map(p.position, p.s));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 16),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i) {
                        Place& place = places[i];
                        for (const auto& p : edges) place.score += likeness(maps.edges, place.T_map_sensor * p);
                        for (const auto& p : planes) place.score += likeness(maps.planes, place.T_map_sensor * p);
                      }
                    });
  run.check_cancel();
  std::ranges::stable_sort(places, std::greater<>(), &Place::score);
  std::vector<Place> best;
  for (const auto& place : places) {
    if (best.size() == max_tried) break;
    if (std::ranges::all_of(best, [&](const Place& b) { return apart(b.T_map_sensor, place.T_map_sensor); }))
      best.push_back(place);
  }
  return best;
}

// 1 for each point that agrees with the map.
std::vector<std::uint8_t> agreeing(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& motion,
                                   const RegistrationSettings& settings, const Run& run) {
  const PoseGrid poses(motion);
  const std::size_t edges = features.edges.size();
  std::vector<std::uint8_t> out(features.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i) {
                        const bool line = i < edges;
                        const FeaturePoint& p = line ? features.edges[i] : features.planes[i - edges];
                        const Eigen::Vector3d x = poses.in_map(p.position, p.s);
                        const auto target = find_target(line ? maps.edges : maps.planes, x, line, 0, settings.sigma);
                        out[i] = target.kind != Target::Kind::none &&
                                 pose_equations(target, x, Eigen::Vector3d::Zero(), settings.kernel_sigmas).inlier;
                      }
                    });
  run.check_cancel();
  return out;
}

}  // namespace

Relocalisation relocalise(const FeatureSet& features, const FeatureMaps& maps, const LastSeen& last, double span_s,
                          const RegistrationSettings& given_settings, const Run& run) {
  auto settings = given_settings;
  settings.model = MotionModel::rigid;
  settings.coarse_iterations = 6;
  settings.iterations = 14;
  // A person who turns on the spot does not go on turning: the frame is de-skewed with the last motion, or not at all,
  // whichever fits.
  const FeatureSet some = thinned(features, tried_points);
  std::vector<std::pair<Registration, Vector6d>> tried;
  for (const Vector6d& velocity : {last.velocity, Vector6d(Vector6d::Zero())})
    for (const auto& place : best_of(reachable(last), features, maps, velocity, span_s, run)) {
      auto r = register_frame(some, maps, motion_about(place.T_map_sensor, velocity, span_s), settings, run);
      tried.emplace_back(std::move(r), velocity);
    }
  std::ranges::stable_sort(tried, std::greater<>(), [](const auto& t) { return t.first.overlap; });

  settings.coarse_iterations = 2;
  settings.iterations = 12;
  std::vector<Registration> registered;
  for (const auto& attempt : tried) {
    const Registration& rough = attempt.first;
    if (registered.size() == max_registered) break;
    const auto is_new = [&](const Registration& r) { return apart(r.motion.at(0.5), rough.motion.at(0.5)); };
    if (!std::ranges::all_of(registered, is_new)) continue;
    registered.push_back(register_frame(features, maps, rough.motion, settings, run));
  }
  Relocalisation out;
  if (registered.empty()) return out;
  const auto best = std::ranges::max_element(registered, {}, &Registration::overlap);
  out.found = *best;
  const auto here = agreeing(features, maps, best->motion, settings, run);
  for (const auto& r : registered) {
    if (!apart(r.motion.at(0.5), best->motion.at(0.5))) continue;
    const auto there = agreeing(features, maps, r.motion, settings, run);
    double only_here = 0, only_there = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      only_here += here[i] > there[i];
      only_there += there[i] > here[i];
    }
    out.doubt = std::max(
        out.doubt, preference(last, r.motion.at(0.5), best->motion.at(0.5)) * only_there / std::max(only_here, 1.0));
  }
  return out;
}

}  // namespace bole::slam
