#include "render/scene/flight_scene.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "render/beside/ground_picture.h"
#include "render/beside/painted_points.h"
#include "render/beside/terrain_surface.h"
#include "render/draw/color.h"
#include "render/draw/shrink.h"
#include "render/scene/actors.h"
#include "render/scene/eye_dome.h"
#include "render/scene/thin.h"

namespace bole::render {
namespace {

constexpr int samples = 2;  // pixels that one of the picture is the mean of, squared
constexpr double usual_height_px = 1080, shading_px = 1.6, walk_radius_m = 0.04, ring_half_m = 0.04;

}  // namespace

struct FlightScene::Parts {
  FlightLook look;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
};

FlightScene::FlightScene(const MapData& data, const Surroundings& about, const FlightLook& look, const Run& run)
    : parts_(std::make_unique<Parts>()) {
  if (data.points == nullptr || data.points->empty())
    throw bad_input("there are no points to fly through", "a point cloud");
  auto& p = *parts_;
  p.look = look;
  p.origin = data.points->origin;
  const Color ground = look.dark ? hex(0x11181d) : ink::paper;
  p.renderer->SetBackground(ground.r, ground.g, ground.b);
  const auto drawn = thin_for_drawing(*data.points, {}, look.point_budget, run);
  const double scale = samples * look.height_px / usual_height_px;
  p.renderer->AddActor(points_actor(*data.points, drawn, coloring_for(*data.points, drawn, look.color), p.origin,
                                    std::max(1.0, look.point_px * scale)));
  add(about.clouds, scale, run);
  if (about.ground) {
    const auto& [picture, places, opacity] = *about.ground;
    p.renderer->AddActor(ground_actor(ground_texture(picture, true), places, p.origin, opacity));
  }
  if (about.terrain) {
    const auto surface = terrain_surface(*about.terrain->heights, p.origin);
    for (const auto& actor : {about.terrain->lines_only ? nullptr : surface.ground, surface.contours})
      if (actor) p.renderer->AddActor(actor);
  }
  if (look.stems && data.stems != nullptr && data.stems->rows() > 0) {
    const auto shapes = stem_shapes(*data.stems, data.sections);
    p.renderer->AddActor(stems_actor(shapes, p.origin, true));
    p.renderer->AddActor(breast_height_actor(shapes, p.origin, ring_half_m));
  }
  if (look.walk && data.trajectory != nullptr && data.trajectory->poses.size() > 1)
    p.renderer->AddActor(
        path_actor(*data.trajectory, p.origin, walk_radius_m, look.dark ? hex(0x7fd3ff) : ink::primary));
  p.window->SetOffScreenRendering(1);
  p.window->SetMultiSamples(0);
  p.window->SetSize(samples * look.width_px, samples * look.height_px);
  p.window->AddRenderer(p.renderer);
}

FlightScene::~FlightScene() = default;

// A larger cloud has a larger share of the points.
void FlightScene::add(const std::vector<BesideCloud>& beside, double point_scale, const Run& run) {
  auto& p = *parts_;
  double all = 0;
  for (const auto& cloud : beside) all += static_cast<double>(cloud.points->size());
  for (const auto& cloud : beside) {
    const double share = static_cast<double>(cloud.points->size()) / all;
    const auto drawn = thin_for_drawing(
        *cloud.points, {}, static_cast<std::size_t>(std::ceil(share * static_cast<double>(p.look.point_budget))), run);
    if (drawn.empty()) continue;
    const double size_px = point_scale * (cloud.point_px > 0 ? cloud.point_px : p.look.point_px);
    p.renderer->AddActor(
        painted_points_actor(*cloud.points, drawn, cloud.paint, p.origin, std::max(1.0, size_px), cloud.opacity));
  }
}

Image FlightScene::frame(const ViewPoint& view) {
  auto& p = *parts_;
  auto* camera = p.renderer->GetActiveCamera();
  const Eigen::Vector3d eye = view.eye - p.origin, centre = view.centre - p.origin;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(centre.data());
  camera->SetViewUp(view.up.data());
  p.renderer->ResetCameraClippingRange();
  p.window->Render();
  const int width = samples * p.look.width_px, height = samples * p.look.height_px;
  vtkNew<vtkUnsignedCharArray> rgb;
  p.window->GetPixelData(0, 0, width - 1, height - 1, 0, rgb);
  const std::span pixels{rgb->GetPointer(0), static_cast<std::size_t>(rgb->GetNumberOfValues())};
  EyeDomeOptions shading;
  shading.radius_px = shading_px * samples * p.look.height_px / usual_height_px;
  shade_eye_dome(pixels, window_depths_m(p.window, camera), width, height, shading);
  return shrunk(pixels, p.look.width_px, p.look.height_px, samples);
}

}  // namespace bole::render
