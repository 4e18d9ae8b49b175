#include "io/core/views/camera_choice.h"

#include <array>
#include <vector>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/views/camera_file.h"

namespace bole::io {
namespace {

struct KnownCamera {
  std::string_view name;
  RgbdCamera camera;
};

const std::vector<KnownCamera>& known_cameras() {
  const auto camera = [](double fx, double fy, double cx, double cy, std::array<double, 5> distortion, double scale) {
    RgbdCamera out;
    out.color = {.width = 640, .height = 480, .fx = fx, .fy = fy, .cx = cx, .cy = cy, .distortion = distortion};
    out.depth_scale = scale;
    return out;
  };
  static const std::vector<KnownCamera> rows{
      {"tum_freiburg1", camera(517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}, 5000)},
      {"tum_freiburg2", camera(520.9, 521.0, 325.1, 249.7, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172}, 5000)},
      {"tum_freiburg3", camera(535.4, 539.2, 320.1, 247.6, {}, 5000)},
      {"icl_nuim", camera(481.2, -480, 319.5, 239.5, {}, 5000)},
      {"primesense", camera(525, 525, 319.5, 239.5, {}, 1000)}};
  return rows;
}

std::string how_to_give() {
  return "Write camera.json (pipelines/calibrate_camera.json measures it), or set camera=FILE, camera=fx,fy,cx,cy or "
         "one "
         "of " +
         known_camera_names();
}

// "481.2,-480,319.5,239.5", in pixels. The size comes from the images.
RgbdCamera camera_of_numbers(const std::string& text) {
  std::string copy = text;
  for (char& c : copy)
    if (c == ',') c = ' ';
  const auto words = split_blanks(copy);
  std::array<double, 4> values{};
  bool numbers = words.size() == values.size();
  for (std::size_t i = 0; numbers && i < values.size(); ++i) numbers = parse_number(words[i], values[i]);
  if (!numbers)
    throw bad_input("camera is '" + text + "'",
                    "a file camera.json, four numbers fx,fy,cx,cy in pixels, or one of " + known_camera_names());
  RgbdCamera camera;
  camera.color.fx = values[0];
  camera.color.fy = values[1];
  camera.color.cx = values[2];
  camera.color.cy = values[3];
  return camera;
}

void tell_left_handed(const RgbdCamera& camera, Report& report) {
  if (camera.color.fx * camera.color.fy < 0)
    report.find(Severity::look, "axes_left_handed",
                "fx and fy of the camera have different signs: its axes, and those of the world, are left-handed, so "
                "that everything is mirrored");
}

}  // namespace

const RgbdCamera* known_camera(std::string_view name) {
  for (const auto& known : known_cameras())
    if (known.name == name) return &known.camera;
  return nullptr;
}

std::string known_camera_names() {
  std::string out;
  for (const auto& known : known_cameras()) out += (out.empty() ? "" : ", ") + std::string(known.name);
  return out;
}

RgbdCamera chosen_camera(const std::string& choice, const std::filesystem::path& own, bool with_depth, Report& report) {
  std::error_code ignored;
  RgbdCamera camera;
  if (choice.empty() && !own.empty() && std::filesystem::exists(own, ignored)) {
    camera = read_camera_file(own, with_depth, report);
  } else if (choice.empty()) {
    throw bad_input(
        own.empty() ? std::string("the views have no file of their camera") : "there is no '" + own.string() + "'",
        "the camera of the views", how_to_give());
  } else if (choice.ends_with(".json")) {
    camera = read_camera_file(choice, with_depth, report);
  } else if (choice == "unknown") {
    report.find(Severity::look, "camera_unknown",
                "the camera is not known: its focal length is a guess that serves calibration only");
  } else if (const auto* known = known_camera(choice)) {
    camera = *known;
  } else {
    camera = camera_of_numbers(choice);
  }
  tell_left_handed(camera, report);
  return camera;
}

}  // namespace bole::io
