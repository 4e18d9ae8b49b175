#include "io/core/views/view_layouts.h"

#include <array>

namespace bole::io {

std::span<const LayoutRow> view_layouts() {
  static const std::array rows{
      LayoutRow{ViewLayout::bole, "Bole", "color/, depth/, camera.json", is_bole_layout, find_bole_views},
      LayoutRow{ViewLayout::tum, "TUM", "rgb.txt, depth.txt, groundtruth.txt", is_tum_layout, find_tum_views},
      LayoutRow{ViewLayout::icl, "ICL or Open3D", "color/, depth/, trajectory.log or pose.txt", is_icl_layout,
                find_icl_views},
      LayoutRow{ViewLayout::seven_scenes, "7-Scenes", "frame-000000.color.png, .depth.png, .pose.txt",
                is_7scenes_layout, find_7scenes_views},
      LayoutRow{ViewLayout::scannet, "ScanNet", "color/, depth/, pose/, intrinsic/", is_scannet_layout,
                find_scannet_views},
      LayoutRow{ViewLayout::realsense, "RealSense", "NAME_Color_TIME.png, NAME_Depth_TIME.png", is_realsense_layout,
                find_realsense_views},
      LayoutRow{ViewLayout::nerf, "NeRF", "transforms.json", is_nerf_layout, find_nerf_views},
      LayoutRow{ViewLayout::colmap, "COLMAP", "cameras and images, .bin or .txt", is_colmap_layout, find_colmap_views},
      LayoutRow{ViewLayout::romi, "ROMI", "images/, metadata/images/", is_romi_layout, find_romi_views},
      LayoutRow{ViewLayout::images, "Images", "pictures and camera.json", is_images_layout, find_images_views},
  };
  return rows;
}

const LayoutRow* find_layout(const std::filesystem::path& path) {
  for (const auto& row : view_layouts())
    if (row.matches(path)) return &row;
  return nullptr;
}

std::string layout_list() {
  std::string out;
  const auto rows = view_layouts();
  for (std::size_t i = 0; i < rows.size(); ++i)
    out += (i == 0                ? ""
            : i + 1 < rows.size() ? ", "
                                  : " or ") +
           std::string(rows[i].title) + " (" + std::string(rows[i].note) + ")";
  return out;
}

}  // namespace bole::io
