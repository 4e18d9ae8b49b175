#include "sim/core/scene/wind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/scene/noise.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

using std::numbers::pi;

// Deflection of the top by a steady wind, as a share of the height per (m/s)^2: 1 % of the height at 5 m/s for a tree
// whose height is 80 times its diameter. An assumption: published deflections spread over an order of magnitude.
constexpr double deflection_share = 0.0004;
constexpr double usual_slenderness = 80;
constexpr double stem_zone_m = 0.3;  // beside the axis: what lies within moves with the stem

// Wind near the ground of a stand, by that at the height of the crowns: an assumption, as are the plants' figures.
constexpr double below_crowns_share = 0.3;
constexpr std::uint64_t first_low_stream = 1'000'000;  // beyond the ids of trees

struct Pliancy {
  double deflection_share = 0;  // of the height per (m/s)^2
  double frequency_hz = 0;
};

const Pliancy& pliancy_of(LowPlantKind kind) {
  static constexpr Pliancy sapling{0.008, 0.8}, shrub{0.008, 1.2}, grass{0.035, 2.5};
  switch (kind) {
    case LowPlantKind::sapling:
      return sapling;
    case LowPlantKind::shrub:
      return shrub;
    case LowPlantKind::grass:
      break;
  }
  return grass;
}

double top_deflection_m(const Tree& tree, double speed_m_s) {
  const double height = tree.stem.end_m, slenderness = height / std::max(0.01, tree.taped.diameter_m);
  const double sail = tree.alive ? 1 : 0.3;
  const double share =
      deflection_share * speed_m_s * speed_m_s * sail * std::clamp(slenderness / usual_slenderness, 0.5, 2.0);
  return height * std::min(0.08, share);
}

Eigen::Vector2d top_at(const Wind::Swaying& tree, double time_s) {
  const double u = std::clamp(time_s / Wind::step_s, 0.0, static_cast<double>(tree.top_m.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(u), tree.top_m.size() - 2);
  const double t = u - static_cast<double>(i);
  return (1 - t) * tree.top_m[i].cast<double>() + t * tree.top_m[i + 1].cast<double>();
}

}  // namespace

double Wind::natural_frequency_hz(double dbh_cm, double height_m) {
  return 0.0766 + 3.1219 * dbh_cm / (height_m * height_m);
}

double Wind::bending(double height_m, double tree_height_m) {
  const double x = std::clamp(height_m / tree_height_m, 0.0, 1.0);
  return 0.5 * x * x * (3 - x);
}

Eigen::Vector2d Wind::displacement(const Swaying& tree, double height_m, double off_axis_m, double time_s) {
  const Eigen::Vector2d top = top_at(tree, time_s);
  Eigen::Vector2d moved = bending(height_m, tree.height_m) * top;
  const double beside = off_axis_m - stem_zone_m;
  if (beside <= 0) return moved;
  const double up = std::clamp(height_m / tree.height_m, 0.0, 1.0), loose = up * std::min(1.0, beside / 1.5);
  moved += 0.5 * loose * (top_at(tree, time_s - 0.3 * beside) - top);
  const double beat = 2 * pi * 1.3 * time_s + 4 * beside + tree.flutter_phase;
  moved += loose * tree.flutter_m * Eigen::Vector2d(std::sin(beat), std::cos(0.83 * beat));
  return moved;
}

double Wind::reach_m(const Swaying& tree, double height_m) {
  // Branches differ from the stem by what the top differs from itself a while before, at most twice its reach, halved.
  const double up = std::clamp(height_m / tree.height_m, 0.0, 1.0);
  return (bending(height_m, tree.height_m) + up) * tree.top_reach_m + 1.5 * up * tree.flutter_m;
}

// What the motion of a tree or a plant follows from.
struct Wind::Body {
  int id = 0;
  std::uint64_t stream = 0;  // of its random numbers
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();
  double height_m = 0;
  double deflection_m = 0;  // of its top by the steady wind
  double frequency_hz = 0;
  double flutter_m = 0;
};

void Wind::add(const Body& body, const WindParameters& parameters, double duration_s, std::uint64_t seed) {
  const Eigen::Vector2d downwind(-std::sin(parameters.from_rad), -std::cos(parameters.from_rad)),
      across(-downwind.y(), downwind.x());
  const double speed = parameters.speed_m_s, gust_length_m = std::max(8.0, 4 * speed);
  const auto steps = static_cast<std::size_t>(std::ceil(duration_s / step_s)) + 2;
  const std::uint64_t gusts = Random(seed, Stream::wind).next();
  Random random(seed, Stream::wind, body.stream);
  const double deflection = body.deflection_m * random.uniform(0.8, 1.2),
               frequency = body.frequency_hz * random.uniform(0.9, 1.1);
  const double along_phase = random.angle(), across_phase = random.angle();
  Swaying swaying{body.id, body.foot, body.lean, body.height_m, body.flutter_m, random.angle(), {}, 0};
  const Eigen::Vector2d at = body.foot.head<2>();
  double reach = 0;
  swaying.top_m.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const double t = step_s * static_cast<double>(i), beat = 2 * pi * frequency * t;
    // Frozen turbulence: the gusts are carried along by the wind.
    const double gust =
        gradient_noise((at.dot(downwind) - speed * t) / gust_length_m, at.dot(across) / gust_length_m, gusts);
    // The oscillation grows and fades over some ten of its periods.
    const double swing = 0.6 + 0.5 * gradient_noise(0.1 * frequency * t, 0.37 * body.id, gusts + 1);
    const double along = 0.6 + 0.8 * gust + 0.5 * swing * std::sin(beat + along_phase),
                 sideways = 0.3 * swing * std::sin(0.97 * beat + across_phase);
    const Eigen::Vector2d top = deflection * (along * downwind + sideways * across);
    reach = std::max(reach, top.norm());
    swaying.top_m.push_back(top.cast<float>());
  }
  swaying.top_reach_m = reach;
  trees_.push_back(std::move(swaying));
}

Wind::Wind(const std::vector<Tree>& trees, const std::vector<LowPlant>& low_plants, const WindParameters& parameters,
           double duration_s, std::uint64_t seed) {
  const double speed = parameters.speed_m_s;
  for (const auto& tree : trees)
    add({tree.id, static_cast<std::uint64_t>(tree.id), tree.stem.foot, tree.stem.lean, tree.stem.end_m,
         top_deflection_m(tree, speed), natural_frequency_hz(100 * tree.taped.diameter_m, tree.stem.end_m),
         0.006 * speed},
        parameters, duration_s, seed);
  for (const auto& plant : low_plants) {
    const auto& pliancy = pliancy_of(plant.kind);
    const double near_ground = below_crowns_share * speed,
                 share = std::min(0.3, pliancy.deflection_share * near_ground * near_ground);
    add({plant.id, first_low_stream + static_cast<std::uint64_t>(-plant.id), plant.foot, plant.lean, plant.height_m,
         share * plant.height_m, pliancy.frequency_hz, 0.006 * near_ground},
        parameters, duration_s, seed);
  }
}

}  // namespace bole::sim
