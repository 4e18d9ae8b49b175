#include "sim/core/seedling/plant_form.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/transform.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double step = 0.002;         // metres along an axis
constexpr double below_soil = 0.02;    // metres of stem in the soil
constexpr double measured_at = 0.030;  // metres above the soil, where recipes give the stem's diameter

double draw(Random& random, const Span& span) { return random.uniform(span.min, span.max); }

// Index of the sample before `at_arc` and the share of the way to the next.
std::pair<std::size_t, double> place(const std::vector<double>& arc, double at_arc) {
  const auto above = std::ranges::upper_bound(arc, at_arc);
  const auto i = std::clamp<std::ptrdiff_t>(above - arc.begin() - 1, 0, static_cast<std::ptrdiff_t>(arc.size()) - 2);
  const auto k = static_cast<std::size_t>(i);
  return {k, std::clamp((at_arc - arc[k]) / (arc[k + 1] - arc[k]), 0.0, 1.0)};
}

Eigen::Vector3d across_of(const Eigen::Vector3d& direction, double azimuth) {
  const Eigen::Vector3d side(std::cos(azimuth), std::sin(azimuth), 0);
  return (side - side.dot(direction) * direction).normalized();
}

class Grower {
 public:
  Grower(const SeedlingRecipe& recipe, std::uint64_t seed, const Eigen::Vector3d& foot)
      : recipe_(recipe), seed_(seed), random_(seed, Stream::seedling) {
    plant_.foot = foot;
  }

  PlantForm grow() {
    grow_stem();
    grow_branches();
    for (std::size_t a = 0; a < plant_.axes.size(); ++a) grow_leaves(static_cast<int>(a));
    return std::move(plant_);
  }

 private:
  // Directions are integrated along the axis; the zigzag turns at nodes, smoothed over 6 mm.
  static PlantAxis axis_along(const Eigen::Vector3d& base, double length, const auto& direction_at) {
    PlantAxis axis;
    const int steps = std::max(4, static_cast<int>(std::ceil(length / step)));
    const double ds = length / steps;
    Eigen::Vector3d at = base;
    for (int i = 0; i <= steps; ++i) {
      axis.points.push_back(at);
      axis.arc.push_back(i * ds);
      at += ds * direction_at((i + 0.5) / steps);
    }
    return axis;
  }

  void grow_stem() {
    const auto& s = recipe_.stem;
    const double height = draw(random_, s.height_m), diameter = draw(random_, s.diameter_mm) / 1000;
    const double tip = draw(random_, s.tip_share), lean = draw(random_, s.lean_deg) * rad_per_deg;
    const double bow = draw(random_, s.bow_share), zigzag = draw(random_, s.zigzag_deg) * rad_per_deg;
    const double lean_azimuth = random_.angle(), bow_azimuth = random_.angle(), wobble = random_.angle();
    const double length = height + below_soil;
    const double nodes = std::max(2.0, length / 0.02), turn = random_.uniform(2.0, 2.6);
    // A circular arc with this sagitta turns by 8 * bow / 2 to each side of its chord.
    const auto direction = [&](double t) {
      const double bend = 4 * bow * (1 - 2 * t) + 0.6 * bow * std::sin(2 * pi * t + wobble);
      const double kink = zigzag * std::sin(pi * nodes * t) * std::min(1.0, 4 * t);
      const double azimuth = turn * nodes * t;
      Eigen::Vector3d d(std::sin(lean) * std::cos(lean_azimuth), std::sin(lean) * std::sin(lean_azimuth),
                        std::cos(lean));
      d += bend * Eigen::Vector3d(std::cos(bow_azimuth), std::sin(bow_azimuth), 0);
      d += 0.5 * kink * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
      return Eigen::Vector3d(d.normalized());
    };
    PlantAxis stem = axis_along(Eigen::Vector3d::Zero(), length, direction);
    // The stem passes the soil at the foot and ends at the height of the recipe.
    const double scale = length / (stem.points.back().z() - stem.points.front().z());
    for (auto& p : stem.points) p *= scale;
    for (auto& a : stem.arc) a *= scale;
    std::size_t at_soil = 0;
    while (stem.points[at_soil].z() < below_soil) ++at_soil;
    const Eigen::Vector3d shift =
        plant_.foot - Eigen::Vector3d(stem.points[at_soil].x(), stem.points[at_soil].y(), below_soil);
    for (auto& p : stem.points) p += shift;
    const auto profile = [&](double above_soil) {
      const double t = std::clamp(above_soil / height, 0.0, 1.0);
      return 1 - (1 - tip) * std::pow(t, 0.9) + 0.12 * std::exp(-std::max(0.0, above_soil) / 0.006);
    };
    const double radius = 0.5 * diameter / profile(std::min(measured_at, 0.5 * height));
    for (const auto& p : stem.points) stem.radii.push_back(radius * profile(p.z() - plant_.foot.z()));
    stem_height_ = height;
    stem_soil_arc_ = stem.arc[at_soil];
    plant_.axes.push_back(std::move(stem));
  }

  void grow_branches() {
    const auto& b = recipe_.branches;
    const int count = static_cast<int>(std::lround(draw(random_, b.count)));
    const double from = draw(random_, b.from_share), to = std::max(from, draw(random_, b.to_share));
    double azimuth = random_.angle();
    for (int i = 0; i < count; ++i) {
      const PlantAxis& stem = plant_.axes.front();
      const double share = count > 1 ? from + (to - from) * (i + random_.uniform(-0.3, 0.3)) / (count - 1) : from;
      const double at = stem_soil_arc_ + std::clamp(share, 0.05, 0.95) * stem_height_;
      azimuth += random_.uniform(110, 160) * rad_per_deg;
      const double angle = draw(random_, b.angle_deg) * rad_per_deg, rise = draw(random_, b.rise_deg) * rad_per_deg;
      const double length = draw(random_, b.length_share) * stem_height_ * (1.15 - 0.5 * share);
      const double radius = draw(random_, b.diameter_share) * stem.radius_at(at), wobble = random_.angle();
      const Eigen::Vector3d up = stem.tangent_at(at), side = across_of(up, azimuth), third = up.cross(side);
      const auto direction = [&](double t) {
        const double a = angle - rise * t;
        const double sway = 0.08 * std::sin(2 * pi * 1.5 * t + wobble);
        return Eigen::Vector3d((std::cos(a) * up + std::sin(a) * side + sway * third).normalized());
      };
      PlantAxis branch = axis_along(stem.point_at(at), length, direction);
      for (const double s : branch.arc) branch.radii.push_back(radius * (1 - 0.5 * s / length));
      branch.parent = 0;
      branch.parent_arc = at;
      plant_.axes.push_back(std::move(branch));
    }
  }

  void grow_leaves(int a) {
    const auto& l = recipe_.leaves;
    Random random(seed_, Stream::seedling_leaves, static_cast<std::uint64_t>(a));
    const PlantAxis& axis = plant_.axes[static_cast<std::size_t>(a)];
    const double start = a == 0 ? stem_soil_arc_ + draw(random, l.first_share) * stem_height_ : 0.2 * axis.length();
    const double divergence = draw(random, l.divergence_deg) * rad_per_deg;
    double azimuth = random.angle();
    for (double at = start; at < axis.length() - 0.0005; at += draw(random, l.spacing_mm) / 1000) {
      azimuth += divergence + random.uniform(-0.15, 0.15);
      add_leaf(a, at, (at - start) / (axis.length() - start), azimuth, random);
    }
  }

  // Young leaves near the tip are smaller and steeper.
  void add_leaf(int a, double at, double share, double azimuth, Random& random) {
    const auto& l = recipe_.leaves;
    const PlantAxis& axis = plant_.axes[static_cast<std::size_t>(a)];
    const double size = (share < 0.65 ? 1 : 1 - 1.5 * (share - 0.65)) * (a == 0 ? 1 : 0.9);
    PlantLeaf leaf;
    leaf.axis = a;
    leaf.axis_arc = at;
    const double angle = draw(random, l.angle_deg) * rad_per_deg * (1.15 - 0.5 * share);
    const Eigen::Vector3d up = axis.tangent_at(at), out = across_of(up, azimuth);
    const Eigen::Vector3d along = (std::cos(angle) * up + std::sin(angle) * out).normalized();
    const double roll = random.normal(0, 12 * rad_per_deg);
    Eigen::Vector3d face = (up - up.dot(along) * along).normalized();
    face = Eigen::AngleAxisd(roll, along) * face;
    leaf.frame << along, face.cross(along), face;
    leaf.base = axis.point_at(at) + 0.8 * axis.radius_at(at) * out;
    leaf.length = draw(random, l.length_mm) / 1000 * size;
    leaf.width = leaf.length * draw(random, l.width_share);
    leaf.petiole = draw(random, l.petiole_mm) / 1000 * std::max(0.5, size);
    leaf.petiole_radius = std::min(0.0009, 0.6 * axis.radius_at(at)) * std::max(0.6, size);
    leaf.wing = draw(random, l.wing_mm) / 1000 * size;
    leaf.thickness = draw(random, l.thickness_mm) / 1000;
    leaf.droop = draw(random, l.droop_deg) * rad_per_deg;
    leaf.fold = draw(random, l.fold_deg) * rad_per_deg;
    leaf.cup = draw(random, l.cup);
    leaf.wave = draw(random, l.wave_share);
    leaf.phase = random.angle();
    leaf.yellow = std::clamp(draw(random, l.yellow) * (1.3 - share), 0.0, 1.0);
    leaf.hue = random.uniform(-1, 1);
    leaf.brightness = random.uniform(0.85, 1.15) * (1 + 0.2 * share);
    plant_.leaves.push_back(leaf);
  }

  const SeedlingRecipe& recipe_;
  std::uint64_t seed_;
  Random random_;
  PlantForm plant_;
  double stem_height_ = 0, stem_soil_arc_ = 0;
};

double raw_outline(double t) {
  return t <= 0 || t >= 1 ? 0 : std::pow(std::sin(pi * std::pow(t, 0.9)), 0.75) * (1 - 0.2 * t);
}

}  // namespace

Eigen::Vector3d PlantAxis::point_at(double at_arc) const {
  const auto [i, s] = place(arc, at_arc);
  return (1 - s) * points[i] + s * points[i + 1];
}

Eigen::Vector3d PlantAxis::tangent_at(double at_arc) const {
  // Over 8 mm, so that a zigzag does not turn what grows from the axis.
  const double from = std::max(0.0, at_arc - 0.004), to = std::min(length(), at_arc + 0.004);
  return (point_at(to) - point_at(from)).normalized();
}

double PlantAxis::radius_at(double at_arc) const {
  const auto [i, s] = place(arc, at_arc);
  return (1 - s) * radii[i] + s * radii[i + 1];
}

PlantForm grow_seedling(const SeedlingRecipe& recipe, std::uint64_t seed, const Eigen::Vector3d& foot) {
  return Grower(recipe, seed, foot).grow();
}

double blade_outline(double along) {
  static const double widest = [] {
    double most = 0;
    for (int i = 1; i < 400; ++i) most = std::max(most, raw_outline(i / 400.0));
    return most;
  }();
  return raw_outline(along) / widest;
}

Eigen::Vector3d blade_point(const PlantLeaf& leaf, double along, double across) {
  // The midrib is a circular arc that bends by `droop` over the length.
  const double turn = leaf.droop * along;
  const bool straight = std::abs(leaf.droop) < 1e-6;
  const double ahead = straight ? along : std::sin(turn) / leaf.droop;
  const double down = straight ? 0 : (1 - std::cos(turn)) / leaf.droop;
  const double half = 0.5 * leaf.width * blade_outline(along);
  const double rounded = std::sqrt(across * across + 0.0064) - 0.08;  // no sharp fold at the midrib
  const double margin = across * across;
  double rise = half * (std::sin(leaf.fold) * rounded - leaf.cup * margin);
  rise += 0.5 * leaf.width * leaf.wave * margin * std::sin(pi * along) * std::sin(5 * pi * along + leaf.phase);
  const double side = half * std::cos(leaf.fold) * across;
  const double front = leaf.petiole + leaf.length * ahead + rise * std::sin(turn);
  const double height = -leaf.length * down + rise * std::cos(turn);
  return leaf.base + leaf.frame * Eigen::Vector3d(front, side, height);
}

Eigen::Vector3d wing_point(const PlantLeaf& leaf, double along, double across) {
  const double half = 0.5 * leaf.wing * std::pow(std::sin(pi * std::clamp(std::pow(along, 1.5), 0.0, 1.0)), 0.7);
  return leaf.base +
         leaf.frame * Eigen::Vector3d(leaf.petiole * (0.1 + 0.9 * along), half * across, 0.1 * half * std::abs(across));
}

}  // namespace bole::sim
