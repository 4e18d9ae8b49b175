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

std::vector<std::uint32_t> slab_points(const PointCloud& cloud, const PointIndex* index, const SectionLine& line) {
  std::vector<std::uint32_t> found;
  const auto keep = [&](std::uint32_t i, double lo_m, double hi_m) {
    const Eigen::Vector2d at = line.along_and_off(cloud.position(i).head<2>());
    if (at.x() >= lo_m && at.x() < hi_m && std::abs(at.y()) <= line.width_m / 2) found.push_back(i);
  };
  if (index == nullptr) {
    for (std::uint32_t i = 0; i < cloud.size(); ++i) keep(i, 0, line.length_m());
    return found;
  }
  // Without the levels of detail every box looks at every point.
  const double step_m = index->complete() ? std::max(piece_m, line.width_m) : line.length_m();
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
    auto near = index->in_box(cloud, (low - cloud.origin).cast<float>(), (high - cloud.origin).cast<float>());
    std::ranges::sort(near);
    for (const auto i : near) keep(i, at_m, end_m);
  }
  return found;
}

// From the heights above ground of the points: each says where the ground below it is.
std::vector<std::vector<Eigen::Vector2d>> terrain_of(const PointCloud& cloud, const CrossSection& section) {
  if (!cloud.has(arrays::height_above_ground)) return {};
  const auto* heights = std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name));
  if (heights == nullptr) return {};
  struct Sum {
    double z = 0;
    std::size_t count = 0;
  };
  std::map<long, Sum> bins;
  const auto& places = section.drawn.points;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (section.owners[k] != 0) continue;
    const double ground = places[k].y() - static_cast<double>((*heights)[section.indices[k]]);
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

struct SlabPoint {
  double nearness = 0;
  std::uint32_t owner = 0, index = 0;
  auto operator<=>(const SlabPoint&) const = default;
};

// The share of one cloud of all that may be drawn.
void thin_evenly(std::vector<std::uint32_t>& indices, std::size_t of_all) {
  if (of_all <= max_section_points) return;
  const std::size_t kept = indices.size() * max_section_points / of_all;
  for (std::size_t k = 0; k < kept; ++k) indices[k] = indices[k * indices.size() / kept];
  indices.resize(kept);
}

void paint_owner(CrossSection& section, std::uint32_t owner, const SectionCloud& cloud) {
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < section.indices.size(); ++k)
    if (section.owners[k] == owner) {
      indices.push_back(section.indices[k]);
      places.push_back(k);
    }
  if (indices.empty()) return;
  std::vector<std::uint8_t> rgb(3 * indices.size());
  render::paint_points(*cloud.points, indices, cloud.paint, rgb.data());
  for (std::size_t k = 0; k < places.size(); ++k)
    std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(3 * k), 3,
                section.drawn.rgb.begin() + static_cast<std::ptrdiff_t>(3 * places[k]));
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

std::size_t CrossSection::points_of(std::uint32_t owner) const {
  return static_cast<std::size_t>(std::ranges::count(owners, owner));
}

CrossSection cut_through(const Survey& survey, const SectionLine& line, const render::PointPaint& paint,
                         const std::vector<render::StemShape>& stems, const std::vector<SectionCloud>& beside) {
  CrossSection section;
  section.drawn.length_m = line.length_m();
  for (const auto& stem : stems)
    if (auto outline = outline_of_stem(stem, line)) section.drawn.stems.push_back(std::move(*outline));
  if (line.length_m() <= 0) return section;
  std::vector<SectionCloud> all{{survey.points, survey.index, paint, {}}};
  all.insert(all.end(), beside.begin(), beside.end());
  std::vector<std::vector<std::uint32_t>> found;
  for (const auto& cloud : all) {
    found.push_back(cloud.points ? slab_points(*cloud.points, cloud.index.get(), line) : std::vector<std::uint32_t>());
    section.found += found.back().size();
  }
  // What is near covers what is far, whose ever it is.
  std::vector<SlabPoint> by_depth;
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    thin_evenly(found[k], section.found);
    for (const auto i : found[k])
      by_depth.push_back({-line.along_and_off(all[k].points->position(i).head<2>()).y(), k, i});
  }
  std::ranges::sort(by_depth);
  section.drawn.rgb.resize(3 * by_depth.size());
  for (const auto& point : by_depth) {
    const auto p = all[point.owner].points->position(point.index);
    section.indices.push_back(point.index);
    section.owners.push_back(point.owner);
    section.drawn.points.emplace_back(line.along_and_off(p.head<2>()).x(), p.z());
  }
  for (std::uint32_t k = 0; k < all.size(); ++k) paint_owner(section, k, all[k]);
  for (const auto& cloud : beside) section.drawn.clouds.push_back(cloud.key);
  if (survey.points) section.drawn.terrain = terrain_of(*survey.points, section);
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
