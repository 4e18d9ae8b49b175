#include "render/rows/plant_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace bole::render {
namespace {

const char* const plant_name = "plant";
constexpr Color other_ink = hex(0xc4ccd1);

const std::vector<std::int32_t>* plant_numbers(const PointCloud& cloud) {
  return cloud.has(plant_name) ? &cloud.values<std::int32_t>(plant_name) : nullptr;
}

}  // namespace

void ViewBox::include(const Eigen::Vector3d& p) {
  if (!p.allFinite()) return;
  lo = lo.cwiseMin(p);
  hi = hi.cwiseMax(p);
}

void ViewBox::round(double margin_m) {
  constexpr double step_m = 0.5;
  if (!(lo.x() <= hi.x())) {
    lo = Eigen::Vector3d::Constant(-1);
    hi = Eigen::Vector3d::Constant(1);
  }
  lo = ((lo.array() - margin_m) / step_m).floor() * step_m;
  hi = ((hi.array() + margin_m) / step_m).ceil() * step_m;
}

bool ViewBox::contains(const Eigen::Vector3d& p) const {
  return (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all();
}

ViewBox box_of(const PointCloud& cloud, bool plants_only) {
  ViewBox box;
  const auto* plant = plant_numbers(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!plants_only || (plant != nullptr && (*plant)[i] > 0)) box.include(cloud.position(i));
  return box;
}

std::vector<std::uint32_t> sampled_in(const PointCloud& cloud, const ViewBox& box, std::size_t most) {
  std::vector<std::uint32_t> inside;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (box.contains(cloud.position(i))) inside.push_back(static_cast<std::uint32_t>(i));
  const std::size_t n = inside.size();
  if (n <= most) return inside;
  std::erase_if(inside, [&](std::uint32_t i) {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
    return ((i * golden) >> 40U) % n >= most;
  });
  return inside;
}

PlantCloud height_cloud(const PointCloud& cloud, const ViewBox& box, std::size_t most) {
  PlantCloud out{{}, box.lo, box.hi};
  for (const auto i : sampled_in(cloud, box, most)) {
    const Eigen::Vector3d p = cloud.position(i);
    const double share = (p.z() - box.lo.z()) / (box.hi.z() - box.lo.z());
    // The brightest tenth of the map is hard to see on paper.
    out.points.push_back({p, ColorMap::viridis().at(0.9 * std::round(15 * share) / 15)});
  }
  return out;
}

PlantCloud plant_cloud(const PointCloud& cloud, const ViewBox& box, std::size_t most) {
  PlantCloud out{{}, box.lo, box.hi};
  const auto* plant = plant_numbers(cloud);
  for (const auto i : sampled_in(cloud, box, most))
    out.points.push_back({cloud.position(i), plant != nullptr && (*plant)[i] > 0 ? id_color((*plant)[i]) : other_ink});
  return out;
}

std::size_t plants_in(const PointCloud& cloud) {
  std::set<std::int32_t> ids;
  if (const auto* plant = plant_numbers(cloud))
    for (const auto id : *plant)
      if (id > 0) ids.insert(id);
  return ids.size();
}

}  // namespace bole::render
