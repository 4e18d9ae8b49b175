#include "sim/core/seedling/plant_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

constexpr int light_steps = 24;  // in a full turn

}  // namespace

double PlantSway::Swing::at(double view) const {
  return size * std::sin(2 * std::numbers::pi * per_view * view + phase);
}

PlantSway::PlantSway(const std::vector<ScenePart>& at_rest, const PlantForm& plant, double sway_rad, std::uint64_t seed)
    : foot_(plant.foot), sway_(sway_rad) {
  Random random(seed, Stream::sway);
  const auto swing = [&](double min_period, double max_period) {
    const double a = random.angle();
    Swing s;
    s.axis = Eigen::Vector3d(std::cos(a), std::sin(a), 0);
    s.size = random.uniform(0.4, 1);
    s.per_view = 1 / random.uniform(min_period, max_period);
    s.phase = random.angle();
    return s;
  };
  for (std::size_t i = 0; i < plant.leaves.size(); ++i) leaves_.push_back(swing(2.5, 9));
  for (int k = 0; k < 2; ++k) stem_.push_back(swing(6, 20));
  for (const auto& part : at_rest) rest_.push_back(part.positions);
  height_ = std::max(0.05, plant.axes.front().points.back().z() - foot_.z());
}

void PlantSway::move(std::vector<ScenePart>& parts, double view) const {
  const auto bent = [&](const Eigen::Vector3d& p) {
    const double above = std::max(0.0, p.z() - foot_.z());
    Eigen::Vector3d moved = p;
    for (const auto& s : stem_) moved += 0.05 * sway_ * s.at(view) * above * above / height_ * s.axis;
    return moved;
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto& part = parts[i];
    if (part.label != PartLabel::plant) continue;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (part.leaf >= 0) {
      const auto& s = leaves_[static_cast<std::size_t>(part.leaf)];
      turn = Eigen::AngleAxisd(sway_ * s.at(view), s.axis).toRotationMatrix();
    }
    const Eigen::Vector3d pivot = part.pivot.cast<double>();
    for (std::size_t k = 0; k < part.positions.size(); ++k) {
      const Eigen::Vector3d p = rest_[i][k].cast<double>();
      part.positions[k] = bent(pivot + turn * (p - pivot)).cast<float>();
    }
  }
}

const std::vector<TurningLight::PartLight>& TurningLight::at_step(int step) {
  const auto found = steps_.find(step);
  if (found != steps_.end()) return found->second;
  const Pose now = scene_.T_room_world;
  const Eigen::Translation3d middle(middle_);
  const Eigen::AngleAxisd turn(2 * std::numbers::pi * step / light_steps, Eigen::Vector3d::UnitZ());
  scene_.T_room_world = Pose(middle * turn * middle.inverse());
  light_scene(scene_, lighting_, samples_, false, seed_, cancel_);
  scene_.T_room_world = now;
  auto& lights = steps_[step];
  for (const auto& part : scene_.world) lights.push_back({part.light, part.through});
  return lights;
}

void TurningLight::update() {
  const Eigen::Matrix3d R = scene_.T_room_world.linear();
  double angle = std::atan2(R(1, 0), R(0, 0));
  if (angle < 0) angle += 2 * std::numbers::pi;
  const double place = angle / (2 * std::numbers::pi) * light_steps;
  const int below = static_cast<int>(place) % light_steps;
  const auto share = static_cast<float>(place - std::floor(place));
  const auto& a = at_step(below);
  const auto& b = at_step((below + 1) % light_steps);
  const auto blend = [share](const std::vector<float>& from, const std::vector<float>& to, std::vector<float>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = (1 - share) * from[i] + share * to[i];
  };
  for (std::size_t p = 0; p < scene_.world.size(); ++p) {
    blend(a[p].light, b[p].light, scene_.world[p].light);
    blend(a[p].through, b[p].through, scene_.world[p].through);
  }
}

}  // namespace bole::sim
