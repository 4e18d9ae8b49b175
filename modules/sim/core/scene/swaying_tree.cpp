// Trees that sway: geometries of Embree that move the rays instead of themselves.
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/core/scene/ray_group.h"
#include "sim/core/scene/ray_scene.h"

namespace bole::sim {
namespace {

constexpr int lanes = RayBundle::size;

// The context of a pulse: Embree hands it on to the trees.
struct PulseContext {
  RTCIntersectContext embree;
  double time_s = 0;
};

// Upper ends of the height bands above the foot.
constexpr std::array<float, 6> band_tops_m{2, 4, 7, 11, 16, 1000};

// Where the ray passes the axis of the tree: height above its foot, and distance beside it.
std::pair<double, double> passing(const Wind::Swaying& tree, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  const double flat = std::max(1e-9, ray.head<2>().squaredNorm());
  double height = 0, beside = 0;
  // The second time with the axis where it stands in the height of the first.
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d axis = tree.foot.head<2>() + std::clamp(height, 0.0, tree.height_m) * tree.lean;
    const double way = std::max(0.0, (axis - from.head<2>()).dot(ray.head<2>()) / flat);
    height = from.z() + way * ray.z() - tree.foot.z();
    beside = (from.head<2>() + way * ray.head<2>() - axis).norm();
  }
  return {height, beside};
}

void bounds_of_tree(const RTCBoundsFunctionArguments* args) {
  const auto& tree = *static_cast<const Group*>(args->geometryUserPtr);
  const auto& band = tree.bands[args->primID];
  const auto reach =
      static_cast<float>(Wind::reach_m(*tree.sway, static_cast<double>(band.max().z()) - tree.sway->foot.z()));
  RTCBounds& bounds = *args->bounds_o;
  bounds.lower_x = band.min().x() - reach;
  bounds.lower_y = band.min().y() - reach;
  bounds.lower_z = band.min().z();
  bounds.upper_x = band.max().x() + reach;
  bounds.upper_y = band.max().y() + reach;
  bounds.upper_z = band.max().z();
}

// Moves the rays against the sway of the tree and meets the tree at rest. The tree is moved as a whole by what its axis
// moves in the height in which the pulse passes it, which is the same for all rays of a pulse.
void meet_tree(const RTCIntersectFunctionNArguments* args) {
  const auto& tree = *static_cast<const Group*>(args->geometryUserPtr);
  const auto n = static_cast<int>(args->N);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  alignas(32) RTCRayHit8 packet{};
  alignas(32) int valid[lanes] = {};
  Eigen::Vector2f moved = Eigen::Vector2f::Zero();
  bool known = false;
  for (int i = 0; i < n; ++i) {
    valid[i] = args->valid[i];
    if (!valid[i]) continue;
    const auto k = static_cast<unsigned>(i);
    const Eigen::Vector3f from(RTCRayN_org_x(rays, args->N, k), RTCRayN_org_y(rays, args->N, k),
                               RTCRayN_org_z(rays, args->N, k));
    const Eigen::Vector3f ray(RTCRayN_dir_x(rays, args->N, k), RTCRayN_dir_y(rays, args->N, k),
                              RTCRayN_dir_z(rays, args->N, k));
    if (!known) {
      const auto [height, beside] = passing(*tree.sway, from.cast<double>(), ray.cast<double>());
      const double time = reinterpret_cast<const PulseContext*>(args->context)->time_s;
      moved = Wind::displacement(*tree.sway, height, beside, time).cast<float>();
      known = true;
    }
    packet.ray.org_x[i] = from.x() - moved.x();
    packet.ray.org_y[i] = from.y() - moved.y();
    packet.ray.org_z[i] = from.z();
    packet.ray.dir_x[i] = ray.x();
    packet.ray.dir_y[i] = ray.y();
    packet.ray.dir_z[i] = ray.z();
    packet.ray.tnear[i] = RTCRayN_tnear(rays, args->N, k);
    packet.ray.tfar[i] = RTCRayN_tfar(rays, args->N, k);
    packet.ray.time[i] = 0;
    packet.ray.mask[i] = ~0u;
    packet.ray.flags[i] = 0;
    packet.ray.id[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect_at(0, tree.scene, valid, packet);  // at rest: nothing in it sways
  for (int i = 0; i < n; ++i) {
    if (!valid[i] || packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const auto k = static_cast<unsigned>(i);
    RTCRayN_tfar(rays, args->N, k) = packet.ray.tfar[i];
    RTCHitN_Ng_x(hits, args->N, k) = packet.hit.Ng_x[i];
    RTCHitN_Ng_y(hits, args->N, k) = packet.hit.Ng_y[i];
    RTCHitN_Ng_z(hits, args->N, k) = packet.hit.Ng_z[i];
    RTCHitN_geomID(hits, args->N, k) = packet.hit.geomID[i];
    RTCHitN_instID(hits, args->N, k, 0) = packet.hit.instID[0][i];
    RTCHitN_primID(hits, args->N, k) = in_swaying_tree | tree.number;
  }
}

}  // namespace

void intersect_at(double time_s, RTCSceneTy* scene, const int* valid, RTCRayHit8& packet) {
  PulseContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  context.time_s = time_s;
  rtcIntersect8(valid, scene, &context.embree, &packet);
}

void Group::cover(const TriangleMesh& mesh, const Eigen::Affine3f& T_plot_mesh) {
  if (bands.empty()) bands.resize(band_tops_m.size());
  const auto foot = static_cast<float>(sway->foot.z());
  for (const auto& triangle : mesh.triangles) {
    Eigen::AlignedBox3f box;
    for (const auto corner : triangle) box.extend(T_plot_mesh * mesh.vertices[corner]);
    for (std::size_t k = 0; k < bands.size(); ++k) {
      const float bottom = k == 0 ? box.min().z() : foot + band_tops_m[k - 1], top = foot + band_tops_m[k];
      if (box.max().z() < bottom || box.min().z() > top) continue;
      Eigen::AlignedBox3f part = box;
      part.min().z() = std::max(box.min().z(), bottom);
      part.max().z() = std::min(box.max().z(), top);
      bands[k].extend(part);
    }
  }
}

void attach_swaying(RTCDeviceTy* device, RTCSceneTy* scene, Group& tree) {
  std::erase_if(tree.bands, [](const auto& band) { return band.isEmpty(); });
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(tree.bands.size()));
  rtcSetGeometryUserData(geometry, &tree);
  rtcSetGeometryBoundsFunction(geometry, bounds_of_tree, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meet_tree);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace bole::sim
