#include "stems/core/tree/crown_form.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "stems/core/fit/each_stem.h"
#include "stems/core/tree/tree_axis.h"

namespace bole::stems {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Alpha_shape_vertex_base_2<Kernel>;
using FaceBase = CGAL::Alpha_shape_face_base_2<Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using AlphaShape = CGAL::Alpha_shape_2<Triangulation>;

constexpr double voxel_m = 0.10, layer_m = 0.25, lowest_m = 1.0, branch_m = 0.30, reach_m = 0.5, farthest_m = 1000;
constexpr int bearings = 8, min_bearings = 3, metre_of_layers = 4, min_layers = 3;

// A point in the axes of its tree, in voxels: from the stem at breast height and above the ground.
std::uint64_t voxel_key(const Eigen::Vector3d& p) {
  const auto part = [](double v) { return static_cast<std::uint64_t>(std::floor(v / voxel_m) + (1 << 20)); };
  return (part(p.z()) << 42) | (part(p.y()) << 21) | part(p.x());
}
Eigen::Vector3d voxel_centre(std::uint64_t key) {
  const auto part = [&](int shift) {
    return (static_cast<double>((key >> shift) & 0x1fffffU) - (1 << 20) + 0.5) * voxel_m;
  };
  return {part(0), part(21), part(42)};
}

// Most points lie in a voxel that was met a moment ago: told without a search, so that few keys need sorting.
class RecentKeys {
 public:
  bool is_new(std::uint64_t key) {
    auto& met = met_[(key * 0x9e3779b97f4a7c15ULL) >> (64 - bits)];
    return std::exchange(met, key) != key;  // no key is zero
  }

 private:
  static constexpr int bits = 9;
  std::array<std::uint64_t, 1U << bits> met_{};
};

double crown_base(const Stem& stem, const std::vector<Eigen::Vector3d>& voxels) {
  constexpr auto layers = static_cast<std::size_t>(tallest_m / layer_m);
  std::vector<unsigned> sides(layers, 0);  // bit per bearing that a branch is seen at
  const Eigen::Vector2d slope = stem.direction.head<2>() / stem.direction.z();
  for (const auto& v : voxels) {
    if (v.z() < lowest_m || v.z() >= tallest_m) continue;
    const Eigen::Vector2d q = v.head<2>() - std::min(v.z(), 4.0) * slope;
    if (q.norm() < stem.radius + branch_m) continue;
    const auto side = static_cast<unsigned>((std::atan2(q.y(), q.x()) / std::numbers::pi + 1) / 2 * bearings);
    sides[static_cast<std::size_t>(v.z() / layer_m)] |= 1U << (side % bearings);
  }
  for (std::size_t i = 0; i + metre_of_layers <= layers; ++i) {
    if (std::popcount(sides[i]) < min_bearings) continue;
    const auto full = std::count_if(sides.begin() + static_cast<std::ptrdiff_t>(i),
                                    sides.begin() + static_cast<std::ptrdiff_t>(i) + metre_of_layers,
                                    [](unsigned s) { return std::popcount(s) >= min_bearings; });
    if (full >= min_layers) return static_cast<double>(i) * layer_m;
  }
  return std::nan("");
}

}  // namespace

double covered_area_m2(const std::vector<Eigen::Vector2d>& points, double reach) {
  if (points.size() < 3) return 0;
  std::vector<Kernel::Point_2> at;
  at.reserve(points.size());
  for (const auto& p : points) {
    if (!p.allFinite()) throw failure("a point of the outline is no number");  // the exact predicates would not end
    at.emplace_back(p.x(), p.y());
  }
  const AlphaShape shape(at.begin(), at.end(), reach * reach, AlphaShape::GENERAL);
  double area = 0;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
    if (shape.classify(f) == AlphaShape::INTERIOR) area += std::abs(shape.triangle(f).area());
  return area;
}

void measure_crowns(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, const Run& run,
                    Report& report) {
  std::vector<std::vector<std::uint64_t>> keys(stems.size());
  std::vector<RecentKeys> recent(stems.size());
  std::vector<char> astray(stems.size(), 0);  // a point too far away for a voxel, or no number
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto id = static_cast<std::size_t>(labels.tree_id[i]);
    if (id == 0 || labels.stem[i] != 0) continue;
    const Stem& s = stems[id - 1];
    Eigen::Vector3d p = points.positions()[i].cast<double>();
    p.head<2>() -= s.breast_height.head<2>(), p.z() -= s.ground_z;
    if (!(p.norm() < farthest_m)) astray[id - 1] = 1;
    if (!(p.z() >= lowest_m) || p.z() >= tallest_m || astray[id - 1] != 0) continue;
    const auto key = voxel_key(p);
    if (!recent[id - 1].is_new(key)) continue;
    auto& mine = keys[id - 1];
    mine.push_back(key);
    if (mine.size() >= 400000 && std::has_single_bit(mine.size())) {
      std::ranges::sort(mine);
      mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
    }
  }
  const auto measure = [&](std::size_t k) {
    if (astray[k] != 0)
      throw failure("a point of the tree lies more than 1 km from its stem, or one of both has no place");
    auto& mine = keys[k];
    std::ranges::sort(mine);
    mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
    std::vector<Eigen::Vector3d> voxels;
    voxels.reserve(mine.size());
    for (const auto key : mine) voxels.push_back(voxel_centre(key));
    auto& s = stems[k];
    s.crown_base_m = crown_base(s, voxels);
    if (!std::isfinite(s.crown_base_m)) return;
    std::vector<std::pair<double, double>> plan;
    for (const auto& v : voxels)
      if (v.z() >= s.crown_base_m) plan.emplace_back(v.x(), v.y());
    std::ranges::sort(plan);
    plan.erase(std::unique(plan.begin(), plan.end()), plan.end());
    std::vector<Eigen::Vector2d> at;
    for (const auto& [x, y] : plan) at.emplace_back(x, y);
    s.crown_area_m2 = covered_area_m2(at, reach_m);
  };
  for_each_stem(stems, "the crown", run, report, measure,
                [](Stem& s) { s.crown_base_m = s.crown_area_m2 = std::nan(""); });
}

}  // namespace bole::stems
