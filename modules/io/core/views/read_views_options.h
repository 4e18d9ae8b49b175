// Options of reading views.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::io {

// How a folder of views is laid out. The rows of view_layouts() have the same order.
enum class ViewLayout { bole, tum, icl, seven_scenes, scannet, realsense, nerf, colmap, romi, images };
constexpr std::array<std::string_view, 10> choice_names(ViewLayout) {
  return {"bole", "tum", "icl", "7scenes", "scannet", "realsense", "nerf", "colmap", "romi", "images"};
}

struct ReadViewsOptions {
  std::optional<ViewLayout> layout{};  // open: by the files of the folder
  std::string camera{};                // a file; empty: the folder's own
  int every = 1;
  std::optional<int> max_views{};
  std::optional<double> depth_scale{};  // units per metre; open: what the folder says
  std::optional<double> max_depth{};    // metres
};
const OptionTable& option_table(const ReadViewsOptions*);

}  // namespace bole::io
