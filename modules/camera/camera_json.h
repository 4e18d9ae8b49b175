// A camera as the text of camera.json.
#pragma once

#include <span>
#include <string>

#include "camera/camera_model.h"

namespace bole {
inline namespace camera {

// {"width", "height", "fx", "fy", "cx", "cy", "distortion", "depth_scale"}; with a depth camera "depth" and
// "depth_to_color" (4 x 4, rows first, metres). `depth_bias` are the coefficients b0, b1, ... of what is added to a
// measured depth z: b0 + b1 z + ..., metres; without any the entry is absent. Numbers read back to the same value.
std::string camera_json(const RgbdCamera& camera, std::span<const double> depth_bias = {});

}  // namespace camera
}  // namespace bole
