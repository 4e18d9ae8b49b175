// COPC (cloud optimised point cloud, copc.io): LAZ whose chunks are the nodes of an octree.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/core/clouds/cloud_bounds.h"
#include "io/core/las/las_info.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::copc {

// Whether the first variable length record, which lies right behind the header, is that of COPC.
bool looks_like_copc(Bytes file);

struct CopcInfo {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double half_size = 0;  // of the cube of the root
  double spacing = 0;    // of the points of the root; half of it in each level below
  std::uint64_t root_offset = 0, root_size = 0;
};

// Nothing for other files. A record with numbers that cannot be gives a warning and nothing.
std::optional<CopcInfo> copc_info(Bytes file, const LasInfo& info, std::vector<std::string>& warnings);

struct CopcNodes {
  std::vector<laz::Chunk> chunks;  // in the order of the file, none on top of another
  std::uint64_t points = 0;        // of these chunks, as the hierarchy says
  int deepest_level = 0;
  std::size_t refused = 0;        // entries and pages that lie outside of the file, on top of one another, or nowhere
  std::size_t refused_pages = 0;  // of these; nobody knows how many points they had
  std::uint64_t refused_points = 0;  // that the refused entries of chunks had, as they say
};

// The nodes that meet the bounds, down to the first level whose spacing is no greater than `resolution` (0: all
// levels). Every page is read once, so that pages which name one another end.
CopcNodes find_nodes(Bytes file, const LasInfo& info, const CopcInfo& copc, const CloudBounds& bounds,
                     double resolution);

}  // namespace bole::io::copc
