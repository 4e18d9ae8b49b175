// Moves of the camera of the 3-D view. Coordinates are relative to the origin of the scene.
#pragma once

#include <vtkCamera.h>

#include <Eigen/Core>

namespace bole::desktop {

inline constexpr double approach_m = 7;  // from which a stem is looked at

double half_height_m(vtkCamera* camera);  // of what is seen at the depth of the focal point

// Where north (unit, x and y) points on the screen, counter-clockwise from up.
double north_on_screen_rad(vtkCamera* camera, const Eigen::Vector2d& north);

// Towards what lies at `off` (-1 to 1 from the centre) on the screen, at the depth of the focal point.
void zoom_towards(vtkCamera* camera, const Eigen::Vector2d& off, double aspect, double factor);

// To a place in the middle of the view; direction and scale stay.
void centre_on(vtkCamera* camera, const Eigen::Vector3d& target);

// To a place that is then seen from the side, from no further off than `distance_m`.
void approach(vtkCamera* camera, const Eigen::Vector3d& target, double distance_m);

// Keeps the direction and moves the camera so far off that a box fills the view but for a margin.
void fit_box(vtkCamera* camera, const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, double aspect);

// Moves the eye by metres to the right, up (along z) and ahead, after it has turned its head to the right and up.
void fly(vtkCamera* camera, const Eigen::Vector3d& right_up_ahead_m, double right_rad, double up_rad);

void set_parallel(vtkCamera* camera, bool on);  // what is at the focal point keeps its size

}  // namespace bole::desktop
