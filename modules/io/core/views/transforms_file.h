// transforms.json of NeRF: Mildenhall et al. 2020, instant-ngp, nerfstudio.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "camera/camera_model.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct TransformsView {
  std::string file, depth_file, mask_file;  // as written, relative to the folder of transforms.json
  std::optional<Pose> T_world_camera;       // nothing where the matrix is no rigid motion
  CameraModel camera;                       // width 0: complete_camera() finishes it
  double angle_x_rad = 0;                   // the field of view, where fx is to follow from it
  std::string split;
};

struct TransformsFile {
  std::vector<TransformsView> views;
  double depth_scale = 1000;  // units per metre
};

// Cameras and poses are turned from the axes of OpenGL to x right, y down, z ahead; the world's stay. Principal points
// are shifted by half a pixel, because these files count from the corner of the first pixel. Throws Error{bad_input}
// that names the view, for models other than a pinhole with k1, k2, p1, p2 and k3 too.
TransformsFile parse_transforms(Bytes text);

// Fills in what follows from the size of the image. Throws Error{bad_input} where the result is no camera.
void complete_camera(TransformsView& view, int width, int height);

}  // namespace bole::io
