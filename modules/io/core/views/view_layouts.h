// The table of the layouts in which folders of views are found.
#pragma once

#include <span>
#include <string_view>

#include "io/core/views/found_views.h"

namespace bole::io {

struct LayoutRow {
  ViewLayout layout;
  std::string_view title;  // "Bole"
  std::string_view note;   // what the folder holds
  // Whether a folder, or a file that stands for it, is laid out so: by the names of its files alone.
  bool (*matches)(const std::filesystem::path& path) = nullptr;
  FoundViews (*find)(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run) = nullptr;
};

// In the order in which they are tried, which is that of ViewLayout.
std::span<const LayoutRow> view_layouts();

// The first row that matches; null where none does.
const LayoutRow* find_layout(const std::filesystem::path& path);

// "Bole (color/, depth/, camera.json), ...".
std::string layout_list();

// The readers, one for each file of layouts/. Each throws Error{bad_input} where the folder is not laid out so.
bool is_bole_layout(const std::filesystem::path& path);
FoundViews find_bole_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_tum_layout(const std::filesystem::path& path);
FoundViews find_tum_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_icl_layout(const std::filesystem::path& path);
FoundViews find_icl_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_7scenes_layout(const std::filesystem::path& path);
FoundViews find_7scenes_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_scannet_layout(const std::filesystem::path& path);
FoundViews find_scannet_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_realsense_layout(const std::filesystem::path& path);
FoundViews find_realsense_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_nerf_layout(const std::filesystem::path& path);
FoundViews find_nerf_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_colmap_layout(const std::filesystem::path& path);
FoundViews find_colmap_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_romi_layout(const std::filesystem::path& path);
FoundViews find_romi_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);
bool is_images_layout(const std::filesystem::path& path);
FoundViews find_images_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);

}  // namespace bole::io
