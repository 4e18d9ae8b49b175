#include "features/map_behind/map_ground.h"

#include <algorithm>

namespace bole::desktop {
namespace {

constexpr int coarse_side_px = 1024;  // of the map that is drawn from afar

std::optional<GlobalFrame> frame_in(const Table* table) {
  if (table == nullptr) return {};
  try {
    return global_frame_of(table->facts);
  } catch (const Error&) {
    return {};  // the stage that reads it says so
  }
}

}  // namespace

std::optional<GlobalFrame> place_on_earth(const Survey& shown, const Results& results) {
  if (shown.points && shown.points->axes == Axes::global) {
    GlobalFrame itself;
    itself.crs_wkt = shown.points->crs_wkt;
    itself.heights_known = true;
    return itself;
  }
  if (auto frame = frame_in(shown.stems.get())) return frame;
  for (const auto& [stage, outputs] : results)
    for (const auto& [port, data] : outputs.all())
      if (const auto* table = std::get_if<std::shared_ptr<const Table>>(&data))
        if (auto frame = frame_in(table->get())) return frame;
  return {};
}

ReadMap read_map(const QString& path, const MapGround& ground, const Run& run) {
  const auto map = report::read_ground_map(path.toStdString(), ground, run);
  ReadMap read{{map.picture, nullptr, map.pixel_m, map.corners, map.north}, map.crs_known, map.file_pixel_m};
  const auto& pixels = *map.picture;
  if (const int step = (std::max(pixels.width, pixels.height) - 1) / coarse_side_px + 1; step > 1)
    read.map.coarse = std::make_shared<const render::GroundPicture>(render::coarser(pixels, step));
  return read;
}

}  // namespace bole::desktop
