// The place of a plot by the track of a GNSS receiver that was carried on the walk.
#pragma once

#include "cloud/trajectory.h"
#include "survey/core/georeference/georeference.h"

namespace bole::survey {

// `track`: time_s, and latitude_deg, longitude_deg, or easting_m, northing_m, or x_m, y_m of the coordinate system;
// height_m, quality (as in GGA sentences), sd_east_m and sd_north_m where it has them. `walk` is in the local axes.
// Throws Error{bad_input} where the clocks do not go together, or the walk is too small to give a direction.
Georeference place_by_track(const Trajectory& walk, const Table& track, const geo::ProjectedCrs& crs,
                            const LocalPlot& plot, const GeoreferenceOptions& options);

// x_m and y_m of a track without other coordinates are eastings and northings.
Table with_plane_columns(const Table& track);

}  // namespace bole::survey
