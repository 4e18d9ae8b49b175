#include "sim/core/scene/ray_scene.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "base/error.h"

namespace bole::sim {
namespace {

// What a hit's (instance, geometry) stand for.
struct Surface {
  float reflectivity = 0;
  float bark_depth_m = 0;
  int tree_id = 0;
  Material material = Material::ground;
};

Surface surface_of(const Piece& piece) {
  return {piece.reflectivity, piece.bark_depth_m, piece.tree_id, piece.material};
}

RTCGeometry make_geometry(RTCDevice device, const TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices.size()));
  auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
  if (!vertices || !triangles)
    throw failure("Embree has no memory for a mesh of " + std::to_string(mesh.triangles.size()) + " triangles", {},
                  "Use a smaller plot or fewer trees");
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(Eigen::Vector3f));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<RTCScene> archetype_scenes;
  std::vector<std::vector<Surface>> archetype_surfaces;  // [archetype][geometry]
  std::vector<Surface> surfaces;                         // [geometry] of pieces
  // Of placements, whose geometry ids follow those of the pieces: archetype and rotation/scale, to turn normals.
  std::vector<int> placed_archetype;
  std::vector<Eigen::Matrix3f> rotations;
  std::size_t triangles = 0;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    for (auto* s : archetype_scenes) rtcReleaseScene(s);
    if (device) rtcReleaseDevice(device);
  }

  void add_archetype(const Archetype& archetype) {
    RTCScene inner = rtcNewScene(device);
    archetype_scenes.push_back(inner);
    auto& list = archetype_surfaces.emplace_back();
    for (const auto& piece : archetype.pieces) attach(inner, piece, list);
    rtcSetSceneBuildQuality(inner, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(inner);
  }
  void attach(RTCScene to, const Piece& piece, std::vector<Surface>& list) {
    if (piece.mesh.empty()) return;
    RTCGeometry geometry = make_geometry(device, piece.mesh);
    rtcAttachGeometryByID(to, geometry, static_cast<unsigned>(list.size()));
    rtcReleaseGeometry(geometry);
    list.push_back(surface_of(piece));
    triangles += piece.mesh.triangles.size();
  }
  void add_placement(const Placement& placement) {
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, archetype_scenes.at(static_cast<std::size_t>(placement.archetype)));
    const Eigen::Matrix<float, 3, 4> T = placement.T_plot_archetype.matrix().topRows<3>();
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, T.data());
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(scene, instance, static_cast<unsigned>(surfaces.size() + rotations.size()));
    rtcReleaseGeometry(instance);
    placed_archetype.push_back(placement.archetype);
    rotations.emplace_back(placement.T_plot_archetype.linear());
  }
};

RayScene::RayScene(const SceneModel& model) : impl_(std::make_unique<Impl>()) {
  impl_->device = rtcNewDevice(nullptr);
  if (!impl_->device) throw failure("Embree could not start");
  for (const auto& archetype : model.archetypes) impl_->add_archetype(archetype);
  impl_->scene = rtcNewScene(impl_->device);
  for (const auto& piece : model.pieces) impl_->attach(impl_->scene, piece, impl_->surfaces);
  for (const auto& placement : model.placements) impl_->add_placement(placement);
  rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(impl_->scene);
  if (const RTCError error = rtcGetDeviceError(impl_->device); error != RTC_ERROR_NONE)
    throw failure("Embree error " + std::to_string(static_cast<int>(error)) + " while building the scene");
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::size_t RayScene::triangles() const { return impl_->triangles; }

void RayScene::intersect(const RayBundle& rays, RayHit hits[RayBundle::size]) const {
  constexpr int n = RayBundle::size;
  alignas(32) RTCRayHit8 packet;
  alignas(32) int valid[n];
  for (int i = 0; i < n; ++i) {
    valid[i] = -1;
    packet.ray.org_x[i] = rays.origin[0][i];
    packet.ray.org_y[i] = rays.origin[1][i];

    packet.ray.org_z[i] = rays.origin[2][i];
    packet.ray.dir_x[i] = rays.direction[0][i];
    packet.ray.dir_y[i] = rays.direction[1][i];

    packet.ray.dir_z[i] = rays.direction[2][i];
    packet.ray.tnear[i] = 0;
    packet.ray.tfar[i] = rays.max_range_m;
    packet.ray.time[i] = 0;
    packet.ray.mask[i] = ~0u;
    packet.ray.flags[i] = 0;
    packet.ray.id[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, impl_->scene, &context, &packet);
  for (int i = 0; i < n; ++i) {
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
      hits[i] = {};
      continue;
    }
    Eigen::Vector3f normal(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
    const Surface* surface = nullptr;
    if (const unsigned instance = packet.hit.instID[0][i]; instance != RTC_INVALID_GEOMETRY_ID) {
      const std::size_t placement = instance - impl_->surfaces.size();
      normal = impl_->rotations[placement] * normal;
      surface =
          &impl_
               ->archetype_surfaces[static_cast<std::size_t>(impl_->placed_archetype[placement])][packet.hit.geomID[i]];
    } else {
      surface = &impl_->surfaces[packet.hit.geomID[i]];
    }
    const Eigen::Vector3f direction(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    hits[i] = {packet.ray.tfar[i],    std::abs(normal.normalized().dot(direction)),
               surface->reflectivity, surface->bark_depth_m,
               surface->tree_id,      surface->material};
  }
}

}  // namespace bole::sim
