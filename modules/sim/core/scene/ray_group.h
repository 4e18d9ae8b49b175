// What the ray scene and its swaying trees share: Embree's scenes with what their hits stand for.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "sim/core/scene/scene_model.h"
#include "sim/core/scene/wind.h"

// Of Embree, whose headers stay in .cpp files.
struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCRayHit8;

namespace bole::sim {

// What a hit's (instance, geometry) stand for.
struct Surface {
  float reflectivity = 0;
  float bark_depth_m = 0;
  int tree_id = 0;
  Material material = Material::ground;
};

// A scene with what its hits stand for: all that is at rest, or one tree that sways.
struct Group {
  RTCSceneTy* scene = nullptr;
  std::vector<Surface> surfaces;  // [geometry] of pieces
  // Of placements, whose geometry ids follow those of the pieces: archetype and rotation/scale, to turn normals.
  std::vector<int> placed_archetype;
  std::vector<Eigen::Matrix3f> rotations;
  const Wind::Swaying* sway = nullptr;
  unsigned number = 0;
  // Of a swaying tree: what its parts fill at rest, by height band, so that rays between the stems do not ask the
  // crowns.
  std::vector<Eigen::AlignedBox3f> bands;

  // Widens the bands by a part.
  void cover(const TriangleMesh& mesh, const Eigen::Affine3f& T_plot_mesh);
};

// Makes `tree` a geometry of `scene` that sways. `tree` must stay where it is.
void attach_swaying(RTCDeviceTy* device, RTCSceneTy* scene, Group& tree);

// Hits in a swaying tree carry its number where those of triangles have their own.
inline constexpr unsigned in_swaying_tree = 0x80000000u;

// Casts the rays of one pulse into a scene and the swaying trees in it. `valid` has -1 for the rays to cast, 0 for
// others.
void intersect_at(double time_s, RTCSceneTy* scene, const int* valid, RTCRayHit8& packet);

}  // namespace bole::sim
