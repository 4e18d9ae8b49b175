// What lies about a cloud in another one that is shown from the disk.
#pragma once

#include <memory>

#include "document/disk_points.h"
#include "render/beside/placed_cloud.h"

namespace bole::desktop {

struct NearOnDisk {
  std::shared_ptr<const PointCloud> points;  // where `place` shows them; positions alone
  // Where the points within `margin_m` are too many: the distance up to which all are there, and about how far apart
  // those are that lie farther away. spacing_m 0: all are there.
  double all_within_m = 0, spacing_m = 0;
};

// The points of `disk` within `margin_m` of the box around `about`, no more than about `max_points`: then near ones
// come before far ones, since of a large distance less is lost between coarse points. For threads other than that of
// the window: it reads the disk. Throws Error{cancelled}, and Error{bad_input} where the file cannot be decoded there.
NearOnDisk near_on_disk(const DiskPoints& disk, const render::CloudPlace& place, const PointCloud& about,
                        double margin_m, std::size_t max_points, const Run& run);

}  // namespace bole::desktop
