// Regions of points in lists of edits.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cloud/core/regions/point_region.h"
#include "cloud/edit_list.h"

namespace bole {
inline namespace cloud {

// Places are [x, y, z] in metres. They throw Error{bad_input} that names the key.
Eigen::Vector3d edit_place_3d(const EditJson& value, const std::string& key);
EditJson edit_json(const Eigen::Vector3d& place);
PointRegion outline_in(const EditJson& object);  // "outline": corners, "eye" where it was drawn in perspective

// The keys of a region in an edit of points, of which each edit has those of one form:
//   "outline": [[x, y, z], ...], "eye": [x, y, z]?, "depth_m": [least, most]?
//   "centre": [x, y, z], "size_m": [x, y, z], "turn_deg": number?
//   "path": [[x, y, z], ...], "radius_m": number
// and any of them "within": [[x, y, z], [x, y, z]], the corners of a box.
inline constexpr std::array<std::string_view, 9> region_keys{"outline",  "eye",  "depth_m",  "centre", "size_m",
                                                             "turn_deg", "path", "radius_m", "within"};
PointRegion region_in(const EditJson& object);
void put_region(EditJson& object, const PointRegion& region);  // that region_in() reads: no ball

}  // namespace cloud
}  // namespace bole
