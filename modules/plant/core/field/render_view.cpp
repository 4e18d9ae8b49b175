#include "plant/core/field/render_view.h"

#include <limits>

#include "base/error.h"
#include "plant/core/field/field_store.h"

namespace bole::plant {

const OptionTable& option_table(const RenderOptions*) {
  using S = RenderOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, int>{"pose",
                     &S::pose,
                     Unit::none,
                     {0, 1'000'000},
                     Tier::basic,
                     "Which of the poses connected, from 0. Without poses the first view is shown."},
      Option<S, int>{"width", &S::width, Unit::pixel, {8, 10000}, Tier::basic, "Width of the picture."},
  });
  return table;
}

RenderedView render_view(const Table& field, const Trajectory* poses, const RenderOptions& options, const Run& run) {
  const auto stored = load_field(field);
  Pose pose = stored.T_world_camera;
  if (poses != nullptr) {
    if (static_cast<std::size_t>(options.pose) >= poses->poses.size())
      throw bad_input("pose " + std::to_string(options.pose) + " of " + std::to_string(poses->poses.size()) + " poses",
                      "a number from 0 to " + std::to_string(static_cast<int>(poses->poses.size()) - 1));
    pose = poses->poses[static_cast<std::size_t>(options.pose)].T_target_sensor;
  }
  const auto camera = stored.camera.scaled(static_cast<double>(options.width) / stored.camera.width);
  const auto picture = render_field(stored.model, camera, *pixel_directions(camera), pose, Eigen::Array3f::Ones(), run);
  Raster empty;
  empty.cell_m = 1;
  empty.nx = camera.width;
  empty.ny = camera.height;
  empty.values.assign(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height), 0.0F);
  RenderedView out{empty, empty, empty, empty};
  out.red.quantity = "red";
  out.green.quantity = "green";
  out.blue.quantity = "blue";
  out.depth.quantity = "depth_m";
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const int row = camera.height - 1 - y;
      out.red.at(x, row) = picture.color.at(x, y, 0);
      out.green.at(x, row) = picture.color.at(x, y, 1);
      out.blue.at(x, row) = picture.color.at(x, y, 2);
      const float z = picture.depth.at(x, y);
      out.depth.at(x, row) = z > 0 ? z : std::numeric_limits<float>::quiet_NaN();
    }
  return out;
}

}  // namespace bole::plant
