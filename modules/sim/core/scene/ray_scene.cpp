#include "sim/core/scene/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "base/error.h"
#include "sim/core/scene/ray_group.h"

namespace bole::sim {
namespace {

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
  std::memcpy(vertices, static_cast<const void*>(mesh.vertices.data()), mesh.vertices.size() * sizeof(Eigen::Vector3f));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  std::vector<RTCScene> archetype_scenes;
  std::vector<std::vector<Surface>> archetype_surfaces;  // [archetype][geometry]
  Group rest;
  std::vector<Group> trees;  // and low plants, that sway
  std::size_t triangles = 0;

  ~Impl() {
    if (rest.scene) rtcReleaseScene(rest.scene);
    for (const auto& tree : trees)
      if (tree.scene) rtcReleaseScene(tree.scene);
    for (auto* s : archetype_scenes) rtcReleaseScene(s);
    if (device) rtcReleaseDevice(device);
  }

  void add_archetype(const Archetype& archetype) {
    RTCScene inner = rtcNewScene(device);
    archetype_scenes.push_back(inner);
    auto& list = archetype_surfaces.emplace_back();
    for (const auto& piece : archetype.pieces) attach(inner, piece, list);
    commit(inner);
  }
  void attach(RTCScene to, const Piece& piece, std::vector<Surface>& list) {
    if (piece.mesh.empty()) return;
    RTCGeometry geometry = make_geometry(device, piece.mesh);
    rtcAttachGeometryByID(to, geometry, static_cast<unsigned>(list.size()));
    rtcReleaseGeometry(geometry);
    list.push_back(surface_of(piece));
    triangles += piece.mesh.triangles.size();
  }
  void add_placement(Group& group, const Placement& placement) {
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, archetype_scenes.at(static_cast<std::size_t>(placement.archetype)));
    const Eigen::Matrix<float, 3, 4> T = placement.T_plot_archetype.matrix().topRows<3>();
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, T.data());
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(group.scene, instance, static_cast<unsigned>(group.surfaces.size() + group.rotations.size()));
    rtcReleaseGeometry(instance);
    group.placed_archetype.push_back(placement.archetype);
    group.rotations.emplace_back(placement.T_plot_archetype.linear());
  }
  static void commit(RTCScene s) {
    rtcSetSceneBuildQuality(s, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(s);
  }
  void build(const SceneModel& model, const Wind* wind) {
    rest.scene = rtcNewScene(device);
    std::map<int, Group*> swaying;
    if (wind) {
      trees.resize(wind->trees().size());  // they stay where they are: Embree points to them
      for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].scene = rtcNewScene(device);
        trees[i].sway = &wind->trees()[i];
        trees[i].number = static_cast<unsigned>(i);
        swaying[trees[i].sway->id] = &trees[i];
      }
    }
    const auto group_of = [&](int tree_id) -> Group& {
      const auto it = tree_id != 0 ? swaying.find(tree_id) : swaying.end();
      return it == swaying.end() ? rest : *it->second;
    };
    for (const auto& piece : model.pieces) {
      Group& group = group_of(piece.tree_id);
      attach(group.scene, piece, group.surfaces);
      if (group.sway) group.cover(piece.mesh, Eigen::Affine3f::Identity());
    }
    for (const auto& placement : model.placements) {
      Group& group = group_of(placement.tree_id);
      add_placement(group, placement);
      if (!group.sway) continue;
      for (const auto& piece : model.archetypes[static_cast<std::size_t>(placement.archetype)].pieces)
        group.cover(piece.mesh, placement.T_plot_archetype);
    }
    for (auto& tree : trees) {
      commit(tree.scene);
      attach_swaying(device, rest.scene, tree);
    }
    commit(rest.scene);
  }
};

RayScene::RayScene(const SceneModel& model, const Wind* wind) : impl_(std::make_unique<Impl>()) {
  impl_->device = rtcNewDevice(nullptr);
  if (!impl_->device) throw failure("Embree could not start");
  for (const auto& archetype : model.archetypes) impl_->add_archetype(archetype);
  impl_->build(model, wind);
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
  intersect_at(rays.time_s, impl_->rest.scene, valid, packet);
  for (int i = 0; i < n; ++i) {
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
      hits[i] = {};
      continue;
    }
    const unsigned part = packet.hit.primID[i];
    const Group& group = part & in_swaying_tree ? impl_->trees[part & ~in_swaying_tree] : impl_->rest;
    Eigen::Vector3f normal(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
    const Surface* surface = nullptr;
    if (const unsigned instance = packet.hit.instID[0][i]; instance != RTC_INVALID_GEOMETRY_ID) {
      const std::size_t placement = instance - group.surfaces.size();
      normal = group.rotations[placement] * normal;
      const auto archetype = static_cast<std::size_t>(group.placed_archetype[placement]);
      surface = &impl_->archetype_surfaces[archetype][packet.hit.geomID[i]];
    } else {
      surface = &group.surfaces[packet.hit.geomID[i]];
    }
    const Eigen::Vector3f direction(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    hits[i] = {packet.ray.tfar[i],    std::abs(normal.normalized().dot(direction)),
               surface->reflectivity, surface->bark_depth_m,
               surface->tree_id,      surface->material};
  }
}

}  // namespace bole::sim
