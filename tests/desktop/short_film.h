// A film that a test makes in a second.
#pragma once

#include <vector>

#include "report/flight/flythrough.h"
#include "views/scene_view.h"

namespace bole::desktop {

// Three frames of 320 x 180 pixels.
inline report::FlythroughOptions short_film() {
  report::FlythroughOptions options;
  options.seconds = 0.6;
  options.frame_rate = 5;
  options.width = 320;
  options.height = 180;
  options.video = false;
  return options;
}

// What is seen now, and nearly the same.
inline std::vector<render::ViewPoint> short_course(const SceneView& scene, const Eigen::Vector3d& step) {
  auto second = scene.view_point();
  second.eye += step;
  return {scene.view_point(), second};
}

}  // namespace bole::desktop
