// A survey that is seen from many places: prepared once, drawn for each frame of a film.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/run.h"
#include "render/beside/surroundings.h"
#include "render/draw/canvas.h"
#include "render/scene/map_figure.h"
#include "render/scene/view_point.h"

namespace bole::render {

struct FlightLook {
  int width_px = 1920, height_px = 1080;
  PointColor color = PointColor::height;
  bool dark = false;  // light points on a dark ground
  bool stems = true;  // fitted stems as solids
  bool walk = false;  // the path of the sensor
  double point_px = 2;
  std::size_t point_budget = 4'000'000;  // of the survey, and of all clouds beside it together
};

class FlightScene {
 public:
  // Of `data`: points, stems, sections, trajectory; and what is about them. Draws with the backend in use
  // (offscreen.h), in the thread that made it. Throws Error{bad_input} without points, Error{cancelled}.
  FlightScene(const MapData& data, const Surroundings& about, const FlightLook& look, const Run& run);
  ~FlightScene();
  FlightScene(const FlightScene&) = delete;
  FlightScene& operator=(const FlightScene&) = delete;

  // The same view gives the same picture.
  Image frame(const ViewPoint& view);

 private:
  void add(const std::vector<BesideCloud>& beside, double point_scale, const Run& run);
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bole::render
