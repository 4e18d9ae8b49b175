#include "stems/core/tables/renumber_points.h"

namespace bole::stems {

PointCloud renumber_points(const PointCloud& points, const std::map<std::int32_t, std::int32_t>& number,
                           const Run& run) {
  PointCloud out = points;
  if (!points.has(arrays::tree_id)) {
    out.set_column(arrays::tree_id, std::vector<std::int32_t>(points.size(), 0));
    return out;
  }
  auto ids = points.values<std::int32_t>(arrays::tree_id);
  auto bark = points.has(arrays::stem) ? points.values<std::uint8_t>(arrays::stem) : std::vector<std::uint8_t>();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto found = number.find(ids[i]);
    ids[i] = found == number.end() ? 0 : found->second;
    if (ids[i] == 0 && !bark.empty()) bark[i] = 0;
  }
  out.set_column(arrays::tree_id, std::move(ids));
  if (!bark.empty()) out.set_column(arrays::stem, std::move(bark));
  return out;
}

}  // namespace bole::stems
