// The 3-D map of a survey as a figure: points, fitted stems, the walk, a metre grid, legend and north.
#pragma once

#include <limits>

#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/draw/figure.h"
#include "render/scene/point_color.h"

namespace bole::render {

// The points that the maps of a survey draw: choosing them takes longer than drawing, so it is done once for several
// maps.
struct MapPoints {
  std::vector<std::uint32_t> all;        // within the window that is drawn
  std::vector<std::uint32_t> off_stems;  // of these, the ones that do not lie on a fitted stem
};

struct MapData {
  const PointCloud* points = nullptr;
  const Table* stems = nullptr;
  const Table* sections = nullptr;
  const Trajectory* trajectory = nullptr;
  PlotArea area;            // what the view shows, with a margin; else the stems, else the middle of the cloud
  bool north_known = true;  // y points north
  const MapPoints* chosen = nullptr;  // from choose_map_points(); null: chosen anew for each map
};

// Those of them that lie in the window of the map, with points on stems: what a view draws that shows both. Empty where
// there are none. Throws Error{cancelled}.
std::vector<std::uint32_t> map_window_points(const MapData& data, std::size_t budget, const Run& run = {});

// Throws Error{bad_input} without points, Error{cancelled}.
MapPoints choose_map_points(const MapData& data, std::size_t budget, const Run& run = {});

enum class MapView { oblique, top };

struct MapOptions {
  PointColor color = PointColor::height;
  MapView view = MapView::oblique;
  std::size_t point_budget = 2'500'000;  // unless points were chosen before
  double from_azimuth_deg = 205;         // where an oblique view is seen from, clockwise from north
  double elevation_deg = 24;             // above the horizon
  bool stems = true;
  bool walk = true;
  bool dark = false;       // light drawing on a dark ground, for screens
  double crown_share = 1;  // of the points higher than 4 m above ground, so many are drawn
  double max_height_m = std::numeric_limits<double>::infinity();  // above ground: higher points are not drawn
  bool furniture = true;                                          // legend, grid labels, north arrow
  int supersampling = 2;                                          // each pixel is the mean of so many squared
  int color_step = 1;  // colours are rounded to multiples of it, of 255: a greater step makes a smaller file
  double dpi = 300;
};

// Draws with the backend in use (see offscreen.h) at once, and keeps the picture: the figure itself is cheap to write.
Figure map_figure(const MapData& data, const MapOptions& options, double width_mm);

// The picture at the top of the README: an oblique view with the fitted stems standing free of most of the crowns.
Figure hero_figure(const MapData& data, double width_mm, double dpi);

}  // namespace bole::render
