// The chain from one frame to rows, with the paper's settings or with ours: what plant_rows.json runs, in one function.
#pragma once

#include "rows/core/frame/frame_filters.h"
#include "rows/core/frame/mean_shift.h"
#include "rows/core/frame/place_stems.h"
#include "rows/core/frame/trunk_centres.h"
#include "rows/core/rows/find_rows.h"

namespace bole::rows {

struct ChainSettings {
  RegionOptions region;
  VoxelOptions voxel;
  RayGroundOptions ground;
  RadiusOptions radius;
  MeanShiftOptions mean_shift;
  TrunkOptions trunks;
  RowOptions rows;
};

inline Table centres_of(const PointCloud& frame, const Table* attitude, const ChainSettings& s, Report& report) {
  const bole::Run run;
  const auto dense = cut_region(level(frame, {}, attitude), s.region);
  auto points = remove_ground(voxel_centroids(dense, s.voxel), s.ground, run);
  points = mean_shift(radius_filter(points, s.radius, run), s.mean_shift, run);
  return trunk_centres(points, &dense, s.trunks, report).stems;
}

}  // namespace bole::rows
