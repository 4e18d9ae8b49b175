#include "document/cross_section.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bole::desktop {
namespace {

constexpr std::size_t max_section_points = 400'000;
constexpr double piece_m = 4;  // boxes along a slanting line, that the octree is asked for
constexpr double terrain_bin_m = 0.25, terrain_gap_m = 1.5;
constexpr double course_m = 1;  // over which the direction of a path is taken

std::vector<std::uint32_t> slab_points(const Survey& survey, const SectionLine& line) {
  const auto& cloud = *survey.points;
  std::vector<std::uint32_t> found;
  const auto keep = [&](std::uint32_t i, double lo_m, double hi_m) {
    const Eigen::Vector2d at = line.along_and_off(cloud.position(i).head<2>());
    if (at.x() >= lo_m && at.x() < hi_m && std::abs(at.y()) <= line.width_m / 2) found.push_back(i);
  };
  if (!survey.index) {
    for (std::uint32_t i = 0; i < cloud.size(); ++i) keep(i, 0, line.length_m());
    return found;
  }
  // Without the levels of detail every box looks at every point.
  const double step_m = survey.index->complete() ? std::max(piece_m, line.width_m) : line.length_m();
  for (double at_m = 0; at_m < line.length_m(); at_m += step_m) {
    const double end_m = std::min(at_m + step_m, line.length_m());
    Eigen::Vector2d lo = Eigen::Vector2d::Constant(1e300), hi = -lo;
    for (const double along : {at_m, end_m})
      for (const double side : {-0.5, 0.5}) {
        const Eigen::Vector2d corner = line.from + along * line.direction() + side * line.width_m * line.behind();
        lo = lo.cwiseMin(corner);
        hi = hi.cwiseMax(corner);
      }
    const Eigen::Vector3d low(lo.x(), lo.y(), -1e6), high(hi.x(), hi.y(), 1e6);
    auto near = survey.index->in_box(cloud, (low - cloud.origin).cast<float>(), (high - cloud.origin).cast<float>());
    std::ranges::sort(near);
    for (const auto i : near) keep(i, at_m, end_m);
  }
  return found;
}

// From the heights above ground of the points: each says where the ground below it is.
std::vector<std::vector<Eigen::Vector2d>> terrain_of(const PointCloud& cloud, const std::vector<std::uint32_t>& indices,
                                                     const std::vector<Eigen::Vector2d>& places) {
  if (!cloud.has(arrays::height_above_ground)) return {};
  const auto* heights = std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name));
  if (heights == nullptr) return {};
  struct Sum {
    double z = 0;
    std::size_t count = 0;
  };
  std::map<long, Sum> bins;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const double ground = places[k].y() - static_cast<double>((*heights)[indices[k]]);
    if (!std::isfinite(ground)) continue;
    auto& bin = bins[std::lround(places[k].x() / terrain_bin_m)];
    bin.z += ground;
    ++bin.count;
  }
  std::vector<std::vector<Eigen::Vector2d>> pieces;
  for (const auto& [bin, sum] : bins) {
    const Eigen::Vector2d place(static_cast<double>(bin) * terrain_bin_m, sum.z / static_cast<double>(sum.count));
    if (pieces.empty() || place.x() - pieces.back().back().x() > terrain_gap_m) pieces.emplace_back();
    pieces.back().push_back(place);
  }
  return pieces;
}

// The outline of a stem that reaches into the slab.
std::optional<render::SectionStem> outline_of_stem(const render::StemShape& stem, const SectionLine& line) {
  render::SectionStem drawn{stem.tree_id, {}, stem.quality};
  bool within = false;
  std::vector<Eigen::Vector2d> right;
  for (std::size_t k = 0; k < stem.axis.size(); ++k) {
    const Eigen::Vector2d at = line.along_and_off(stem.axis[k].head<2>());
    const double r = stem.radius_m[k];
    within = within || (std::abs(at.y()) <= line.width_m / 2 + r && at.x() >= -r && at.x() <= line.length_m() + r);
    drawn.outline.emplace_back(at.x() - r, stem.axis[k].z());
    right.emplace_back(at.x() + r, stem.axis[k].z());
  }
  drawn.outline.insert(drawn.outline.end(), right.rbegin(), right.rend());
  return within ? std::optional(std::move(drawn)) : std::nullopt;
}

Eigen::Vector2d place_on(const std::vector<Eigen::Vector2d>& path, double at_m) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    if (at_m <= length && length > 0) return path[i] + at_m / length * (path[i + 1] - path[i]);
    at_m -= length;
  }
  return path.back();
}

}  // namespace

Eigen::Vector2d SectionLine::along_and_off(const Eigen::Vector2d& plan) const {
  return {(plan - from).dot(direction()), (plan - from).dot(behind())};
}

bool SectionLine::holds(const Eigen::Vector2d& plan) const {
  const Eigen::Vector2d at = along_and_off(plan);
  return at.x() >= 0 && at.x() <= length_m() && std::abs(at.y()) <= width_m / 2;
}

SectionLine SectionLine::shifted(double metres) const {
  const Eigen::Vector2d by = metres * behind();
  return {from + by, to + by, width_m};
}

CrossSection cut_through(const Survey& survey, const SectionLine& line, const render::PointPaint& paint,
                         const std::vector<render::StemShape>& stems) {
  CrossSection section;
  section.drawn.length_m = line.length_m();
  for (const auto& stem : stems)
    if (auto outline = outline_of_stem(stem, line)) section.drawn.stems.push_back(std::move(*outline));
  if (!survey.points || line.length_m() <= 0) return section;
  auto& indices = section.indices;
  indices = slab_points(survey, line);
  section.found = indices.size();
  if (indices.size() > max_section_points) {
    for (std::size_t k = 0; k < max_section_points; ++k) indices[k] = indices[k * indices.size() / max_section_points];
    indices.resize(max_section_points);
  }
  // What is near covers what is far.
  std::vector<std::pair<double, std::uint32_t>> by_depth;
  for (const auto i : indices) by_depth.emplace_back(-line.along_and_off(survey.points->position(i).head<2>()).y(), i);
  std::ranges::sort(by_depth);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    indices[k] = by_depth[k].second;
    const auto p = survey.points->position(indices[k]);
    section.drawn.points.emplace_back(line.along_and_off(p.head<2>()).x(), p.z());
  }
  section.drawn.rgb.resize(3 * indices.size());
  if (!indices.empty()) render::paint_points(*survey.points, indices, paint, section.drawn.rgb.data());
  section.drawn.terrain = terrain_of(*survey.points, indices, section.drawn.points);
  return section;
}

std::shared_ptr<const PointCloud> slab_from_disk(const DiskPoints& disk, const SectionLine& line, const Run& run) {
  constexpr double picture_px = 2000;  // across
  io::copc::CopcTree::Query query;
  query.spacing = line.length_m() / picture_px;
  for (const auto& end : {line.from, line.to})
    for (const double side : {-0.5, 0.5}) {
      const Eigen::Vector2d corner = end + side * line.width_m * line.behind();
      const bool first = end == line.from && side < 0;
      query.box.min.head<2>() = first ? corner : query.box.min.head<2>().cwiseMin(corner).eval();
      query.box.max.head<2>() = first ? corner : query.box.max.head<2>().cwiseMax(corner).eval();
    }
  // Of a slanting line most of the box is not in the slab.
  query.meets = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const Eigen::Vector2d half = (high - low).head<2>() / 2;
    const Eigen::Vector2d at = line.along_and_off((low + high).head<2>() / 2);
    const double reach_along = half.dot(line.direction().cwiseAbs()), reach_off = half.dot(line.behind().cwiseAbs());
    return at.x() + reach_along >= 0 && at.x() - reach_along <= line.length_m() &&
           std::abs(at.y()) <= line.width_m / 2 + reach_off;
  };
  return disk.points_in(query, run);
}

double path_length_m(const std::vector<Eigen::Vector2d>& path) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  return length;
}

std::optional<SectionLine> line_across(const std::vector<Eigen::Vector2d>& path, double at_m, double half_m,
                                       double width_m) {
  const double length = path_length_m(path);
  if (path.size() < 2 || at_m < 0 || at_m > length) return {};
  const Eigen::Vector2d course =
      place_on(path, std::min(at_m + course_m, length)) - place_on(path, std::max(at_m - course_m, 0.0));
  if (course.norm() < 1e-6) return {};
  // Seen by who walks: behind the line is ahead of him.
  const Eigen::Vector2d ahead = course.normalized(), right(ahead.y(), -ahead.x()), middle = place_on(path, at_m);
  return SectionLine{middle - half_m * right, middle + half_m * right, width_m};
}

}  // namespace bole::desktop
