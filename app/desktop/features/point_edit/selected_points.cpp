#include "features/point_edit/selected_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/angles.h"
#include "base/arrays.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::desktop {
namespace {

constexpr float breast_low_m = 1.1F, breast_high_m = 1.5F;
constexpr std::size_t min_stem_points = 20;
constexpr double stem_error_m = 0.05, stem_sigma_m = 0.025, min_arc_rad = 1.5;

}  // namespace

std::vector<std::uint32_t> points_within(const PointCloud& cloud, const std::vector<PointRegion>& regions,
                                         const std::optional<std::int32_t>& only_tree) {
  const std::vector<RegionTest> tests(regions.begin(), regions.end());
  const auto* trees = cloud.has(arrays::tree_id) ? &cloud.values<std::int32_t>(arrays::tree_id) : nullptr;
  if (only_tree && trees == nullptr) return {};
  std::vector<std::uint8_t> held(cloud.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), 100'000), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (!only_tree || (*trees)[i] == *only_tree)
        held[i] =
            std::ranges::any_of(tests, [&](const auto& test) { return test.contains(cloud.position(i)); }) ? 1 : 0;
  });
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] != 0) out.push_back(static_cast<std::uint32_t>(i));
  return out;
}

Eigen::Vector2d stem_among(const PointCloud& cloud, const std::vector<std::uint32_t>& points) {
  const char* remedy = "Select the stem with the crown, or add the tree by a circle and give it the points";
  std::vector<Eigen::Vector2d> bark;
  if (cloud.has(arrays::height_above_ground)) {
    const auto& heights = cloud.values<float>(arrays::height_above_ground);
    for (const auto i : points)
      if (heights[i] >= breast_low_m && heights[i] <= breast_high_m) bark.emplace_back(cloud.position(i).head<2>());
  }
  if (bark.size() < min_stem_points)
    throw bad_input(std::to_string(bark.size()) + " of the selected points lie about breast height",
                    "at least " + std::to_string(min_stem_points), remedy);
  const Eigen::Vector2d origin = bark.front();
  for (auto& p : bark) p -= origin;
  const auto start = stems::hyper_circle(bark);
  const auto fit = start ? stems::robust_circle(bark, *start, stem_error_m, stem_sigma_m) : std::nullopt;
  if (!fit || fit->arc_rad < min_arc_rad)
    throw bad_input("the selected points hold no circle at breast height", "bark of one stem", remedy);
  return origin + fit->circle.centre;
}

std::int32_t free_tree_id(const PointCloud& cloud) {
  if (!cloud.has(arrays::tree_id) || cloud.empty()) return 1;
  return std::max(0, *std::ranges::max_element(cloud.values<std::int32_t>(arrays::tree_id))) + 1;
}

std::shared_ptr<const PointCloud> relabelled(const PointCloud& cloud, const std::vector<std::uint32_t>& points,
                                             const std::optional<std::int32_t>& tree, const PointEdit& edit) {
  auto out = std::make_shared<PointCloud>(cloud);
  if (tree && cloud.has(arrays::tree_id)) {
    auto ids = cloud.values<std::int32_t>(arrays::tree_id);
    for (const auto i : points) ids[i] = *tree;
    out->set_column(arrays::tree_id, std::move(ids));
  }
  if (edit.gives_class() && cloud.has(arrays::classification)) {
    auto classes = cloud.values<std::uint8_t>(arrays::classification);
    for (const auto i : points) classes[i] = edit.action == PointEdit::Action::to_ground ? ground_class : noise_class;
    out->set_column(arrays::classification, std::move(classes));
  }
  return out;
}

std::vector<std::vector<Eigen::Vector3d>> lines_of(const PointRegion& region) {
  if (region.kind == PointRegion::Kind::brush) return {region.path};
  if (region.kind == PointRegion::Kind::outline) {
    auto line = region.outline;
    line.push_back(line.front());
    return {line};
  }
  const Eigen::Vector3d middle = (region.min + region.max) / 2, half = (region.max - region.min) / 2;
  const Eigen::AngleAxisd turn(radians(region.turn_deg), Eigen::Vector3d::UnitZ());
  const auto corner = [&](int x, int y, int z) -> Eigen::Vector3d {
    return middle + turn * Eigen::Vector3d(x * half.x(), y * half.y(), z * half.z());
  };
  std::vector<std::vector<Eigen::Vector3d>> lines;
  for (const int z : {-1, 1})
    lines.push_back({corner(-1, -1, z), corner(1, -1, z), corner(1, 1, z), corner(-1, 1, z), corner(-1, -1, z)});
  for (const int x : {-1, 1})
    for (const int y : {-1, 1}) lines.push_back({corner(x, y, -1), corner(x, y, 1)});
  return lines;
}

}  // namespace bole::desktop
