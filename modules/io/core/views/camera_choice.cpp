#include "io/core/views/camera_choice.h"

#include <array>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/views/camera_file.h"

namespace bole::io {
namespace {

constexpr const char* how_to_give =
    "Write camera.json (pipelines/calibrate_camera.json measures it), or set camera=FILE or camera=fx,fy,cx,cy";

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
    throw bad_input("camera is '" + text + "'", "a file camera.json, or four numbers fx,fy,cx,cy in pixels");
  RgbdCamera camera;
  camera.color.fx = values[0];
  camera.color.fy = values[1];
  camera.color.cx = values[2];
  camera.color.cy = values[3];
  return camera;
}

}  // namespace

RgbdCamera chosen_camera(const std::string& choice, const std::filesystem::path& own, bool with_depth, Report& report) {
  std::error_code ignored;
  if (choice.empty() && std::filesystem::exists(own, ignored)) return read_camera_file(own, with_depth, report);
  if (choice.empty()) throw bad_input("there is no '" + own.string() + "'", "the camera of the views", how_to_give);
  if (choice.ends_with(".json")) return read_camera_file(choice, with_depth, report);
  return camera_of_numbers(choice);
}

}  // namespace bole::io
