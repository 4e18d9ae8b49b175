// The depth image as the colour camera would see it.
#pragma once

#include "camera/camera_model.h"
#include "camera/image.h"

namespace bole {
inline namespace camera {

// In an image of `color_camera`, metres along its z; 0: none. Near surfaces hide those behind. Depths at pixels of
// `left_out` (may be empty) become negative.
DepthImage registered_depth(const DepthImage& depth, const MaskImage& left_out, const CameraModel& depth_camera,
                            const Pose& T_color_depth, const CameraModel& color_camera);

}  // namespace camera
}  // namespace bole
