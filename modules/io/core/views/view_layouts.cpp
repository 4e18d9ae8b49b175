#include "io/core/views/view_layouts.h"

#include <array>

namespace bole::io {

std::span<const LayoutRow> view_layouts() {
  static const std::array rows{
      LayoutRow{ViewLayout::bole, "Bole", "color/, depth/, camera.json", is_bole_layout, find_bole_views},
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
