#include "camera/camera_json.h"

#include <charconv>

namespace bole {
inline namespace camera {
namespace {

std::string text_of(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value == 0 ? 0.0 : value).ptr;
  return {buffer, end};
}

std::string list_of(std::span<const double> values) {
  std::string out;
  for (const double v : values) out += (out.empty() ? "" : ", ") + text_of(v);
  return "[" + out + "]";
}

std::string fields_of(const CameraModel& c, const std::string& indent) {
  return indent + "\"width\": " + std::to_string(c.width) + ",\n" + indent + "\"height\": " + std::to_string(c.height) +
         ",\n" + indent + "\"fx\": " + text_of(c.fx) + ",\n" + indent + "\"fy\": " + text_of(c.fy) + ",\n" + indent +
         "\"cx\": " + text_of(c.cx) + ",\n" + indent + "\"cy\": " + text_of(c.cy) + ",\n" + indent +
         "\"distortion\": " + list_of(c.distortion);
}

}  // namespace

std::string camera_json(const RgbdCamera& camera, std::span<const double> depth_bias) {
  std::string out = "{\n" + fields_of(camera.color, "  ") + ",\n  \"depth_scale\": " + text_of(camera.depth_scale);
  if (!depth_bias.empty()) out += ",\n  \"depth_bias\": " + list_of(depth_bias);
  if (camera.depth) {
    out += ",\n  \"depth\": {\n" + fields_of(*camera.depth, "    ") + "\n  },\n  \"depth_to_color\": [\n";
    for (int row = 0; row < 4; ++row) {
      const Eigen::Vector4d numbers = camera.T_color_depth.matrix().row(row);
      out += "    " + list_of({numbers.data(), 4}) + (row < 3 ? ",\n" : "\n");
    }
    out += "  ]";
  }
  return out + "\n}\n";
}

}  // namespace camera
}  // namespace bole
