#include "sim/core/seedling/picture_scene.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

constexpr float shadow_reach = 0.75F;     // metres; walls are light, not shade
constexpr float light_of_others = 0.14F;  // radiance of what stands in the way of a lamp
constexpr float off_surface = 0.0002F;    // metres, so that a surface does not shade itself

float radical_inverse(std::uint32_t i) {
  i = (i << 16) | (i >> 16);
  i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
  i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
  i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
  i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
  return static_cast<float>(static_cast<double>(i) * 0x1.0p-32);
}

// Direction i of n about z, as dense as the cosine; `u`, `v` shift the pattern.
Eigen::Vector3f cosine_direction(int i, int n, float u, float v) {
  float a = (static_cast<float>(i) + 0.5F) / static_cast<float>(n) + u;
  float b = radical_inverse(static_cast<std::uint32_t>(i)) + v;
  a -= std::floor(a);
  b -= std::floor(b);
  const float r = std::sqrt(a), turn = 2 * std::numbers::pi_v<float> * b;
  return {r * std::cos(turn), r * std::sin(turn), std::sqrt(std::max(0.0F, 1 - a))};
}

Eigen::Matrix3f axes_about(const Eigen::Vector3f& normal) {
  const Eigen::Vector3f other = std::abs(normal.z()) < 0.9F ? Eigen::Vector3f::UnitZ() : Eigen::Vector3f::UnitX();
  Eigen::Matrix3f axes;
  axes.col(0) = other.cross(normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

class LightBaker {
 public:
  LightBaker(const PictureScene& scene, const Lighting& lighting, int samples, std::uint64_t seed,
             const std::stop_token& cancel)
      : scene_(scene),
        lighting_(lighting),
        samples_(samples),
        seed_(seed),
        cancel_(cancel),
        T_world_room_(scene.T_room_world.inverse()) {}

  void light(std::vector<ScenePart>& parts, const Pose& T_room_parts, bool of_room) const {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      auto& part = parts[p];
      part.light.assign(part.positions.size(), 0.75F);
      part.through.assign(part.positions.size(), 0.0F);
      if (part.surface == PartSurface::wall) continue;
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, part.positions.size(), 64), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end() && !cancel_.stop_requested(); ++i) {
          const std::uint64_t key = mix64(seed_ ^ mix64(p * 1'000'003 + i));
          part.light[i] =
              irradiance(T_room_parts * (part.positions[i] + off_surface * part.normals[i]).cast<double>(),
                         (T_room_parts.linear() * part.normals[i].cast<double>()).cast<float>(), of_room, key);
        }
      });
    }
    pass_through(parts);
  }

 private:
  float irradiance(const Eigen::Vector3d& at_room, const Eigen::Vector3f& normal_room, bool of_room,
                   std::uint64_t key) const {
    const auto u = static_cast<float>(static_cast<double>(key >> 40) * 0x1.0p-24);
    const auto v = static_cast<float>(static_cast<double>((key >> 8) & 0xffffffu) * 0x1.0p-24);
    const Eigen::Matrix3f axes = axes_about(normal_room);
    const Eigen::Vector3d at_world = T_world_room_ * at_room;
    float sum = 0;
    for (int first = 0; first < samples_; first += RayPack::size) {
      RayPack in_room, in_world;
      std::array<Eigen::Vector3f, RayPack::size> directions;
      for (int k = 0; k < RayPack::size; ++k) {
        const Eigen::Vector3f d = axes * cosine_direction(first + k, samples_, u, v);
        directions[static_cast<std::size_t>(k)] = d;
        in_room.set(k, at_room, d.cast<double>());
        in_world.set(k, at_world, T_world_room_.linear() * d.cast<double>());
      }
      auto blocked = scene_.world_rays->blocked(in_world, shadow_reach);
      // Above the plant there is nothing of the room within reach.
      bool more = false;
      for (std::size_t k = 0; k < RayPack::size; ++k) {
        in_room.active[k] = !blocked[k] && (of_room || directions[k].z() < 0);
        more = more || in_room.active[k];
      }
      if (more) {
        const auto by_room = scene_.room_rays->blocked(in_room, shadow_reach);
        for (std::size_t k = 0; k < RayPack::size; ++k) blocked[k] = blocked[k] || by_room[k];
      }
      for (std::size_t k = 0; k < RayPack::size; ++k)
        sum += blocked[k] ? light_of_others : lighting_.radiance(directions[k]);
    }
    return sum / static_cast<float>(samples_);
  }

  // What one side of a leaf gets shines through to the other. Vertices of the sides correspond.
  static void pass_through(std::vector<ScenePart>& parts) {
    for (std::size_t p = 0; p + 1 < parts.size(); ++p) {
      auto &upper = parts[p], &under = parts[p + 1];
      if (upper.surface != PartSurface::leaf || under.surface != PartSurface::leaf || upper.under || !under.under)
        continue;
      std::copy_n(under.light.begin(), upper.light.size(), upper.through.begin());
      std::ranges::copy(upper.light, under.through.begin());
    }
  }

  const PictureScene& scene_;
  const Lighting& lighting_;
  int samples_;
  std::uint64_t seed_;
  const std::stop_token& cancel_;
  Pose T_world_room_;
};

}  // namespace

Lighting::Lighting(std::uint64_t seed) {
  Random random(seed, Stream::surroundings, 5);
  const double azimuth = random.angle();
  const auto lamp = [&](double turn_deg, double elevation_deg, double sharpness, double strength) {
    const double a = azimuth + turn_deg * rad_per_deg, e = elevation_deg * rad_per_deg;
    lamps_.push_back({Eigen::Vector3d(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)).cast<float>(),
                      static_cast<float>(sharpness), static_cast<float>(strength)});
  };
  lamp(0, random.uniform(45, 70), random.uniform(6, 14), random.uniform(1.6, 2.6));
  lamp(random.uniform(130, 230), random.uniform(25, 45), random.uniform(2, 5), random.uniform(0.5, 1.0));
  constexpr int n = 4096;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += static_cast<double>(radiance(cosine_direction(i, n, 0, 0)));
  scale_ = static_cast<float>(n / sum);
}

float Lighting::radiance(const Eigen::Vector3f& direction) const {
  float sum = direction.z() > 0 ? ceiling_ * (0.6F + 0.4F * direction.z()) : bounce_;
  for (const auto& lamp : lamps_) sum += lamp.strength * std::exp(lamp.sharpness * (direction.dot(lamp.direction) - 1));
  return scale_ * sum;
}

float Lighting::highlight(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_camera) const {
  float sum = 0;
  for (const auto& lamp : lamps_) {
    const Eigen::Vector3f half = (lamp.direction + to_camera).normalized();
    const float cosine = std::max(0.0F, normal.dot(half));
    sum += lamp.strength * std::exp(4 * lamp.sharpness * (cosine - 1));
  }
  return scale_ * sum;
}

void PictureScene::trace_again() { world_rays.emplace(world); }

void light_scene(PictureScene& scene, const Lighting& lighting, int samples, bool of_room, std::uint64_t seed,
                 const std::stop_token& cancel) {
  const LightBaker baker(scene, lighting, samples, seed, cancel);
  baker.light(scene.world, scene.T_room_world, false);
  if (of_room) baker.light(scene.room, Pose::Identity(), true);
}

}  // namespace bole::sim
