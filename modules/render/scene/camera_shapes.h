// Cameras in a scene: a pyramid each, from the eye to the corners of the picture.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "render/draw/color.h"
#include "render/scene/pick.h"

namespace bole::render {

struct CameraShape {
  std::size_t view = 0;                    // what it stands for
  Pose T_world_camera = Pose::Identity();  // metres; x right, y down, z ahead
  CameraModel camera;
};

// The corners of the picture at a distance along the camera's z, in world axes: upper left, upper right, lower right,
// lower left. The distortion is undone.
std::vector<Eigen::Vector3d> picture_corners(const CameraShape& shape, double depth_m);

// Edges of the pyramid, and a roof over the upper edge of the picture that tells which way is up.
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> camera_edges(const CameraShape& shape, double depth_m);

// How deep pyramids are drawn so that neighbours hardly overlap and one is still seen among `extent_m` of scene.
double camera_depth_m(const std::vector<CameraShape>& shapes, double extent_m);

// Coordinates relative to `origin`. Null where there is nothing to draw.
vtkSmartPointer<vtkActor> cameras_actor(const std::vector<CameraShape>& shapes, double depth_m,
                                        const Eigen::Vector3d& origin, const Color& color, double width_px);
// The path from eye to eye in the order given.
vtkSmartPointer<vtkActor> eyes_actor(const std::vector<CameraShape>& shapes, const Eigen::Vector3d& origin,
                                     const Color& color, double width_px);
// A picture of the camera within its pyramid. The distortion of the picture is left in it.
vtkSmartPointer<vtkActor> picture_actor(const CameraShape& shape, const ColorImage& picture, double depth_m,
                                        const Eigen::Vector3d& origin);

struct PickedCamera {
  std::size_t view = 0;
  double depth = 0;  // as OnScreen has it
};
// The camera with an edge within `reach_px` of a place: the nearest to it, of several at one distance the foremost.
std::optional<PickedCamera> pick_camera(const PickView& view, const std::vector<CameraShape>& shapes, double depth_m,
                                        const Eigen::Vector2d& at_px, double reach_px);

}  // namespace bole::render
