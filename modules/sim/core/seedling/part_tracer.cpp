#include "sim/core/seedling/part_tracer.h"

#include <embree3/rtcore.h>

#include <cstring>
#include <limits>
#include <string>

#include "base/error.h"

namespace bole::sim {
namespace {

// RTCRay8 is the first member of RTCRayHit8.
void fill_rays(const RayPack& rays, float max_distance, RTCRay8& ray, int* valid) {
  for (int i = 0; i < RayPack::size; ++i) {
    valid[i] = rays.active[static_cast<std::size_t>(i)] ? -1 : 0;
    ray.tnear[i] = 0;
    ray.tfar[i] = max_distance;
    ray.time[i] = 0;
    ray.mask[i] = ~0u;
    ray.flags[i] = 0;
    ray.id[i] = 0;
  }
  std::memcpy(ray.org_x, rays.origin[0], sizeof rays.origin[0]);
  std::memcpy(ray.org_y, rays.origin[1], sizeof rays.origin[1]);
  std::memcpy(ray.org_z, rays.origin[2], sizeof rays.origin[2]);
  std::memcpy(ray.dir_x, rays.direction[0], sizeof rays.direction[0]);
  std::memcpy(ray.dir_y, rays.direction[1], sizeof rays.direction[1]);
  std::memcpy(ray.dir_z, rays.direction[2], sizeof rays.direction[2]);
}

}  // namespace

struct PartTracer::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  void attach(const ScenePart& part, unsigned number) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                             part.positions.size());
    auto* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              3 * sizeof(std::uint32_t), part.triangles.size());
    if (!vertices || !triangles) throw failure("Embree has no memory for the seedling");
    std::memcpy(vertices, static_cast<const void*>(part.positions.data()),
                part.positions.size() * sizeof(part.positions[0]));
    std::memcpy(triangles, part.triangles.data(), part.triangles.size() * sizeof(part.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }
};

PartTracer::PartTracer(const std::vector<ScenePart>& parts) : impl_(std::make_unique<Impl>()) {
  impl_->device = rtcNewDevice(nullptr);
  if (!impl_->device) throw failure("Embree could not start");
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
  for (unsigned i = 0; i < parts.size(); ++i) impl_->attach(parts[i], i);
  rtcCommitScene(impl_->scene);
  if (const RTCError error = rtcGetDeviceError(impl_->device); error != RTC_ERROR_NONE)
    throw failure("Embree error " + std::to_string(static_cast<int>(error)) + " while building the seedling");
}

PartTracer::~PartTracer() = default;
PartTracer::PartTracer(PartTracer&&) noexcept = default;
PartTracer& PartTracer::operator=(PartTracer&&) noexcept = default;

void PartTracer::closest(const RayPack& rays, std::array<PartHit, RayPack::size>& hits) const {
  alignas(32) RTCRayHit8 packet;
  alignas(32) int valid[RayPack::size];
  fill_rays(rays, std::numeric_limits<float>::infinity(), packet.ray, valid);
  for (int i = 0; i < RayPack::size; ++i) {
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, impl_->scene, &context, &packet);
  for (int i = 0; i < RayPack::size; ++i) {
    auto& hit = hits[static_cast<std::size_t>(i)];
    hit = {};
    if (!valid[i] || packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hit = {static_cast<int>(packet.hit.geomID[i]), packet.hit.primID[i], packet.ray.tfar[i], packet.hit.u[i],
           packet.hit.v[i]};
  }
}

std::array<bool, RayPack::size> PartTracer::blocked(const RayPack& rays, float max_distance) const {
  alignas(32) RTCRay8 packet;
  alignas(32) int valid[RayPack::size];
  fill_rays(rays, max_distance, packet, valid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, impl_->scene, &context, &packet);
  std::array<bool, RayPack::size> out{};
  for (int i = 0; i < RayPack::size; ++i)
    out[static_cast<std::size_t>(i)] = valid[i] && packet.tfar[i] < 0;  // Embree sets it to minus infinity
  return out;
}

}  // namespace bole::sim
