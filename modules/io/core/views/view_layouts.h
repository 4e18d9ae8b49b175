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

// color/NNNNNN.png or .jpg, depth/NNNNNN.png, camera.json; optionally poses.tum and mat.json. View i is at i / 30 s.
bool is_bole_layout(const std::filesystem::path& path);
FoundViews find_bole_views(const std::filesystem::path& path, const ReadViewsOptions& options, const Run& run);

}  // namespace bole::io
