// The place of local axes (plot or map) in a coordinate reference system, and data moved there for exports.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "base/run.h"
#include "cloud/facts.h"
#include "cloud/known_facts.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"

namespace bole {
inline namespace cloud {

namespace facts {

inline constexpr FactInfo global_crs{"global_crs", "", 0, 0,
                                     "Coordinate reference system in which the local axes have a place, as WKT."};
inline constexpr FactInfo global_frame{"global_frame", "", 0, 0,
                                       "Place of the local axes in it: 15 numbers, see cloud/core/global_frame.h."};
inline constexpr FactInfo local_axes{
    "local_axes", "", 0, 0,
    "Of a cloud in global axes: place of the local axes that it was moved from, as global_frame."};

}  // namespace facts

// global = shift + A (local - centre). A levels, turns about the vertical and scales the plan; its third row keeps
// heights unscaled. Axes of the result: easting, northing, height. Doubles throughout: eastings have seven digits
// before the point.
struct GlobalFrame {
  Eigen::Vector3d centre_local = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift_global = Eigen::Vector3d::Zero();
  Eigen::Matrix3d A_global_local = Eigen::Matrix3d::Identity();
  std::string crs_wkt;
  bool heights_known = false;  // where not, heights are those of the local axes

  Eigen::Vector3d to_global(const Eigen::Vector3d& local) const {
    return shift_global + A_global_local * (local - centre_local);
  }
  Eigen::Vector3d to_local(const Eigen::Vector3d& global) const;
  // Turn of the plan, counter-clockwise from local to global axes.
  double turn_rad() const;
  // North stays north and nothing is levelled or scaled: a grid keeps its cells.
  bool only_shifts() const;
};

// The frame as two facts of a table, and back. Nothing where a table has none. Throws Error{bad_input} for facts that
// are damaged.
void set_facts(Facts& facts, const GlobalFrame& frame);
std::optional<GlobalFrame> global_frame_of(const Facts& facts);

// Positions and sensor positions in global coordinates, about an origin of whole metres; other columns are shared. The
// cloud keeps the frame as a fact, so that it can be brought back to what else there is of its survey.
PointCloud to_global(const PointCloud& local, const GlobalFrame& frame, const Run& run);
// That frame; nothing where the cloud has none or its axes are not global. Throws Error{bad_input} for a fact that is
// damaged.
std::optional<GlobalFrame> local_axes_of(const PointCloud& global);
// The way back: axes of the plot.
PointCloud to_local(const PointCloud& global, const GlobalFrame& frame, const Run& run);

// The grid with its rows along the easting and cells of the same size. A frame that only shifts keeps the cells;
// else elevations (quantity elevation_m) and slopes are interpolated; a cell of canopy_height_m gets the highest value
// of the cells that it lies on. `terrain` is the elevation of the cells in local axes where `local` is another
// quantity, null: its own values. It is needed because a frame that levels moves what is high sideways.
Raster to_global(const Raster& local, const GlobalFrame& frame, const Raster* terrain, const Run& run);

}  // namespace cloud
}  // namespace bole
