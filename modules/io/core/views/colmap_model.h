// Models of COLMAP (Schönberger, Frahm 2016) as text and binary files: cameras, images and points3D.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/transform.h"
#include "camera/camera_model.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct ColmapImage {
  std::string name;
  std::uint32_t camera = 0;
  Pose T_world_camera = Pose::Identity();
  std::size_t observations = 0;
};

struct ColmapPoints {
  std::size_t count = 0;
  double mean_error_px = 0;
  double mean_track = 0;
};

using ColmapCameras = std::map<std::uint32_t, CameraModel>;

// SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, and FULL_OPENCV where it needs no more than k1, k2, p1, p2
// and k3. Principal points are shifted by half a pixel, because COLMAP counts from the corner of the first pixel. All
// of them throw Error{bad_input}: for other models with their name, for files that are cut off or whose counts cannot
// be.
ColmapCameras parse_colmap_cameras(Bytes file, bool binary);
// In the order of their names.
std::vector<ColmapImage> parse_colmap_images(Bytes file, bool binary);
ColmapPoints parse_colmap_points(Bytes file, bool binary);

}  // namespace bole::io
