#include "io/core/views/transforms_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/core/views/json_fields.h"
#include "io/core/views/pose_matrix.h"

namespace bole::io {
namespace {

constexpr const char* needed = "an object with frames (file_path, transform_matrix) and camera_angle_x or fl_x";
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double half_pixel = 0.5;  // from the corner of the first pixel to its centre

// An entry of a view, or of the whole file.
const Json* entry(const Json& view, const Json& file, const char* name) {
  if (holds(view, name)) return &view;
  return holds(file, name) ? &file : nullptr;
}

double value_or(const Json& view, const Json& file, const char* name, double otherwise) {
  const auto* at = entry(view, file, name);
  return at == nullptr ? otherwise : number_at(*at, name);
}

void refuse_other_models(const Json& view, const Json& file) {
  constexpr std::array known{"PINHOLE", "SIMPLE_PINHOLE", "OPENCV", "SIMPLE_RADIAL", "RADIAL"};
  const auto* at = entry(view, file, "camera_model");
  const auto model = at == nullptr ? std::string("PINHOLE") : text_at(*at, "camera_model");
  const bool named = std::find(known.begin(), known.end(), model) != known.end();
  const auto* fisheye = entry(view, file, "is_fisheye");
  if (!named || (fisheye != nullptr && (*fisheye)["is_fisheye"] == true))
    throw bad_input("the camera model is " + (named ? std::string("a fisheye") : "'" + model + "'"),
                    "PINHOLE, OPENCV, SIMPLE_RADIAL or RADIAL", "Undistort the images first");
  if (value_or(view, file, "k4", 0) != 0)
    throw bad_input("the camera has a coefficient k4", "k1, k2, p1, p2 and k3", "Undistort the images first");
}

void take_camera(const Json& json, const Json& file, TransformsView& view) {
  refuse_other_models(json, file);
  auto& camera = view.camera;
  const double width = value_or(json, file, "w", 0), height = value_or(json, file, "h", 0);
  if (!(width >= 0 && height >= 0 && width < 1e6 && height < 1e6))
    throw bad_input("the image is " + std::to_string(width) + " x " + std::to_string(height) + " pixels", needed);
  camera.width = static_cast<int>(width);
  camera.height = static_cast<int>(height);
  camera.fx = value_or(json, file, "fl_x", 0);
  camera.fy = value_or(json, file, "fl_y", camera.fx);
  camera.cx = value_or(json, file, "cx", no_number) - half_pixel;
  camera.cy = value_or(json, file, "cy", no_number) - half_pixel;
  camera.distortion = {value_or(json, file, "k1", 0), value_or(json, file, "k2", 0), value_or(json, file, "p1", 0),
                       value_or(json, file, "p2", 0), value_or(json, file, "k3", 0)};
  view.angle_x_rad = value_or(json, file, "camera_angle_x", 0);
  if (camera.fx == 0 && !(view.angle_x_rad > 0.001 && view.angle_x_rad < std::numbers::pi - 0.001))
    throw bad_input(view.angle_x_rad == 0 ? std::string("there is neither fl_x nor camera_angle_x")
                                          : "camera_angle_x is " + std::to_string(view.angle_x_rad),
                    "fl_x in pixels, or camera_angle_x in radians, above 0 and below pi");
  if (camera.width > 0 && camera.height > 0) complete_camera(view, camera.width, camera.height);
}

std::optional<Pose> pose_of_view(const Json& view) {
  constexpr const char* name = "transform_matrix";
  const auto numbers = numbers_of(holds(view, name) ? view[name] : Json(), name, "4 x 4 numbers");
  try {
    return from_opengl(pose_from_matrix(numbers, name));
  } catch (const Error&) {
    return std::nullopt;
  }
}

// nerfstudio lists the files of each split.
std::map<std::string, std::string> listed_splits(const Json& json) {
  std::map<std::string, std::string> splits;
  for (const auto& [key, split] :
       {std::pair{"train_filenames", "train"}, {"val_filenames", "val"}, {"test_filenames", "test"}}) {
    if (!holds(json, key) || !json[key].is_array()) continue;
    for (const auto& name : json[key])
      if (name.is_string()) splits[name.get<std::string>()] = split;
  }
  return splits;
}

}  // namespace

TransformsFile parse_transforms(Bytes text) {
  const auto json = parse_object(text, needed);
  if (!holds(json, "frames") || !json["frames"].is_array() || json["frames"].empty())
    throw bad_input("the file has no views ('frames')", needed);
  TransformsFile file;
  const double unit = number_or(json, "depth_unit_scale_factor", 0.001);
  if (!(unit >= 1e-6 && unit <= 1))
    throw bad_input("depth_unit_scale_factor is " + std::to_string(unit), "metres per unit, from 0.000001 to 1");
  file.depth_scale = 1 / unit;
  const auto splits = listed_splits(json);
  for (const auto& entry_of_view : json["frames"]) {
    try {
      if (!entry_of_view.is_object()) throw bad_input("it is " + shown(entry_of_view), needed);
      TransformsView view;
      view.file = text_at(entry_of_view, "file_path");
      if (view.file.empty()) throw bad_input("it has no file_path", needed);
      view.depth_file = text_at(entry_of_view, "depth_file_path");
      view.mask_file = text_at(entry_of_view, "mask_path");
      view.T_world_camera = pose_of_view(entry_of_view);
      take_camera(entry_of_view, json, view);
      if (const auto it = splits.find(view.file); it != splits.end()) view.split = it->second;
      file.views.push_back(std::move(view));
    } catch (const Error& e) {
      throw e.at("view " + std::to_string(file.views.size()));
    }
  }
  return file;
}

void complete_camera(TransformsView& view, int width, int height) {
  auto& camera = view.camera;
  if (camera.width == 0) camera.width = width;
  if (camera.height == 0) camera.height = height;
  if (camera.fx == 0) camera.fx = camera.width / 2.0 / std::tan(view.angle_x_rad / 2);
  if (camera.fy == 0) camera.fy = camera.fx;
  if (std::isnan(camera.cx)) camera.cx = camera.width / 2.0 - half_pixel;
  if (std::isnan(camera.cy)) camera.cy = camera.height / 2.0 - half_pixel;
  camera.check();
}

}  // namespace bole::io
