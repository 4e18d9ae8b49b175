// What moves during a recording: leaves in a draught, and the light on a plant that turns.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <utility>
#include <vector>

#include "sim/core/seedling/picture_scene.h"
#include "sim/core/seedling/plant_form.h"

namespace bole::sim {

// Leaves swing about where they leave the axis; the stem bends with the square of the height. `sway_rad` is the largest
// swing of a leaf; the tip of the stem moves by 0.1 * sway_rad of the height.
class PlantSway {
 public:
  PlantSway(const std::vector<ScenePart>& at_rest, const PlantForm& plant, double sway_rad, std::uint64_t seed);
  // Moves the parts to where they are in a view.
  void move(std::vector<ScenePart>& parts, double view) const;

 private:
  struct Swing {
    Eigen::Vector3d axis;
    double size = 0, per_view = 0, phase = 0;
    double at(double view) const;
  };
  std::vector<std::vector<Eigen::Vector3f>> rest_;
  std::vector<Swing> leaves_;
  std::vector<Swing> stem_;
  Eigen::Vector3d foot_;
  double height_ = 0.1, sway_;
};

// Light on the turning plant, between that of turns 15 deg apart, which are lighted when they are first needed.
class TurningLight {
 public:
  // The table turns about the upright axis through `middle`.
  TurningLight(PictureScene& scene, const Lighting& lighting, const Eigen::Vector3d& middle, int samples,
               std::uint64_t seed, std::stop_token cancel)
      : scene_(scene),
        lighting_(lighting),
        middle_(middle),
        samples_(samples),
        seed_(seed),
        cancel_(std::move(cancel)) {}
  // For the present turn of the scene.
  void update();

 private:
  struct PartLight {
    std::vector<float> light, through;
  };
  const std::vector<PartLight>& at_step(int step);

  PictureScene& scene_;
  const Lighting& lighting_;
  Eigen::Vector3d middle_;
  int samples_;
  std::uint64_t seed_;
  std::stop_token cancel_;
  std::map<int, std::vector<PartLight>> steps_;
};

}  // namespace bole::sim
