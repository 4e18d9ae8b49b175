#include "ground/core/tin_filter.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "ground/core/local_plane.h"
#include "ground/core/raised_objects.h"
#include "ground/core/seeds.h"

namespace bole::ground {
namespace {

class TinFilter {
 public:
  TinFilter(const std::vector<LowPoint>& candidates, const std::vector<std::uint32_t>& pinned, const GridShape& shape,
            const GroundScales& scales, const Run& run)
      : candidates_(candidates),
        shape_(shape),
        scales_(scales),
        run_(run),
        candidate_at_(shape.cells(), none),
        accepted_(candidates.size(), 0),
        pinned_(candidates.size(), 0) {
    for (const auto i : pinned) pinned_[i] = 1;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      candidate_at_[candidates[i].cell] = static_cast<std::uint32_t>(i);
  }

  GroundSurface filter() {
    const SeedLimits limits{scales_.seed, std::tan(scales_.max_slope_deg * rad_per_deg), scales_.roughness,
                            shape_.anchor};
    above_ground_ = stands_above_ground(candidates_, limits, 2 * scales_.cell, run_);
    find_raised();
    for (const auto i : find_seeds(candidates_, above_ground_, limits)) accepted_[i] = 1;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (pinned_[i]) accepted_[i] = 1;
    prune();
    const double finest = std::max(2 * scales_.cell, scales_.seed / 64);
    for (double cell = scales_.seed / 2; cell >= finest * 0.99; cell /= 2) {
      densify(cell);
      prune();
    }
    triangulate();
    if (surface_.measured < 3 || surface_.triangles.empty())
      throw bad_input("only " + std::to_string(surface_.measured) + " ground points were found among " +
                          std::to_string(candidates_.size()) + " candidates",
                      "at least three, not on one line",
                      "Check that the cloud has ground points and its z axis points up, lower seed, or set "
                      "method=lowest for a tree that was cut out without ground, method=normalised where z is the "
                      "height above ground already");
    return std::move(surface_);
  }

 private:
  // Objects of the size of buildings. Dense clouds are scanned from the ground: what hides it is small there, and
  // boulders and banks have steps of their own.
  void find_raised() {
    constexpr double min_cell_m = 0.5;
    if (shape_.cell_m < min_cell_m) return;
    const auto raised = raised_objects(candidates_, shape_, {scales_.max_distance, 0.7, scales_.roughness}, run_);
    for (std::size_t i = 0; i < raised.size(); ++i)
      if (raised[i]) above_ground_[i] = 1;
  }

  void triangulate() {
    run_.check_cancel();
    surface_ = {};
    vertex_of_.clear();
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (accepted_[i])
        surface_.points.push_back(candidates_[i].position), vertex_of_.push_back(static_cast<std::uint32_t>(i));
    surface_.measured = surface_.points.size();
    for (const auto& p : surrounding_points(surface_.points, scales_.seed, shape_.anchor)) surface_.points.push_back(p);
    surface_.triangles = delaunay(surface_.points);
    triangles_at_ = triangles_at_vertices(surface_.triangles, surface_.points.size());
  }

  // Joins, cell by cell, the lowest candidate that fits the triangulation; repeats while that extends it. How often
  // does not depend on the number of points: what is far away must not decide here.
  void densify(double cell_m) {
    constexpr int max_rounds = 6;
    for (int round = 0; round < max_rounds; ++round) {
      triangulate();
      const auto fitting = find_fitting(cell_m);
      for (const auto i : fitting) accepted_[i] = 1;
      if (fitting.empty()) break;
    }
  }

  // f(index) for each candidate inside or on the triangle in plan.
  template <class F>
  void for_each_inside(const Triangle& triangle, const F& f) const {
    const Eigen::Vector3d &a = surface_.points[triangle[0]], &b = surface_.points[triangle[1]],
                          &c = surface_.points[triangle[2]];
    const auto [x0, x1] = std::minmax({a.x(), b.x(), c.x()});
    const auto [y0, y1] = std::minmax({a.y(), b.y(), c.y()});
    const auto left_of = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& at) {
      return (q.x() - p.x()) * (at.y() - p.y()) - (q.y() - p.y()) * (at.x() - p.x()) >= 0;
    };
    for (int iy = std::max(0, shape_.row(y0)); iy <= std::min(shape_.ny - 1, shape_.row(y1)); ++iy)
      for (int ix = std::max(0, shape_.column(x0)); ix <= std::min(shape_.nx - 1, shape_.column(x1)); ++ix) {
        const auto i = candidate_at_[shape_.index(ix, iy)];
        if (i == none) continue;
        const auto& p = candidates_[i].position;
        if (left_of(a, b, p) && left_of(b, c, p) && left_of(c, a, p)) f(i);
      }
  }
  std::vector<std::uint32_t> find_fitting(double cell_m) const;
  bool fits(const Eigen::Vector3d& p, const Triangle& triangle, const TrianglePlane& plane) const;
  bool close(const Eigen::Vector3d& p, const TrianglePlane& plane, double nearest_vertex_m) const;
  const Triangle* triangle_opposite(std::uint32_t v, const Eigen::Vector3d& p) const;
  double longest_edge(const Triangle& t) const;
  bool prune_once();
  void prune() {
    constexpr int max_rounds = 12;
    for (int round = 0; round < max_rounds; ++round) {
      triangulate();
      if (!prune_once()) return;
    }
  }

  const std::vector<LowPoint>& candidates_;
  const GridShape& shape_;
  const GroundScales& scales_;
  const Run& run_;
  std::vector<std::uint32_t> candidate_at_;  // of each cell, or none
  std::vector<char> accepted_, pinned_, above_ground_;
  std::vector<std::uint32_t> vertex_of_;  // candidate of each measured vertex
  GroundSurface surface_;
  Neighbourhood triangles_at_;
};

bool TinFilter::close(const Eigen::Vector3d& p, const TrianglePlane& plane, double nearest_vertex_m) const {
  const double distance = std::abs(p.z() - plane.at(p.x(), p.y())) / std::sqrt(1 + plane.gradient.squaredNorm());
  if (distance <= scales_.roughness) return true;
  return distance <= scales_.max_distance &&
         distance <= std::sin(scales_.max_angle_deg * rad_per_deg) * nearest_vertex_m;
}

bool TinFilter::fits(const Eigen::Vector3d& p, const Triangle& triangle, const TrianglePlane& plane) const {
  std::uint32_t nearest = triangle[0];
  for (const auto v : triangle)
    if ((surface_.points[v] - p).squaredNorm() < (surface_.points[nearest] - p).squaredNorm()) nearest = v;
  const double distance = (surface_.points[nearest] - p).norm();
  if (close(p, plane, distance)) return true;
  const auto* opposite = triangle_opposite(nearest, p);
  if (!opposite) return false;
  const TrianglePlane mirrored(surface_.points[(*opposite)[0]], surface_.points[(*opposite)[1]],
                               surface_.points[(*opposite)[2]]);
  if (mirrored.degenerate || mirrored.gradient.norm() > std::tan(scales_.max_slope_deg * rad_per_deg) ||
      !close(p, mirrored, distance))
    return false;
  // Upwards only over long triangles and from the plane of one as large as the step: objects are as steep as brows, but
  // small.
  return p.z() < plane.at(p.x(), p.y()) ||
         (longest_edge(triangle) > 3 * distance && longest_edge(*opposite) > distance);
}

double TinFilter::longest_edge(const Triangle& t) const {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (surface_.points[t[k]] - surface_.points[t[(k + 1) % 3]]).head<2>().norm());
  return longest;
}

// The triangle at vertex v on the side away from p, or nullptr on the hull.
const Triangle* TinFilter::triangle_opposite(std::uint32_t v, const Eigen::Vector3d& p) const {
  const Eigen::Vector2d at = surface_.points[v].head<2>(), away = at - p.head<2>();
  for (const auto t : triangles_at_.of(v)) {
    const auto& triangle = surface_.triangles[t];
    const auto k = static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), v) - triangle.begin());
    const Eigen::Vector2d first = surface_.points[triangle[(k + 1) % 3]].head<2>() - at,
                          second = surface_.points[triangle[(k + 2) % 3]].head<2>() - at;
    if (first.x() * away.y() - first.y() * away.x() >= 0 && away.x() * second.y() - away.y() * second.x() >= 0)
      return &triangle;
  }
  return nullptr;
}

std::vector<std::uint32_t> TinFilter::find_fitting(double cell_m) const {
  // Best candidate of each coarse cell: the lowest above (or deepest below) the triangulation among those that fit.
  const CellKeys coarse(candidates_, cell_m, shape_.anchor);
  std::vector<std::uint32_t> best(coarse.cells(), none);
  std::vector<float> best_height(coarse.cells(), 0);
  std::vector<char> occupied(coarse.cells(), 0);
  for (const auto i : vertex_of_) occupied[coarse.key(i)] = 1;
  for (const auto& t : surface_.triangles) {
    const TrianglePlane plane(surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
    if (plane.degenerate) continue;
    for_each_inside(t, [&](std::uint32_t i) {
      const auto cell = coarse.key(i);
      if (occupied[cell] || accepted_[i] || above_ground_[i]) return;
      const auto& p = candidates_[i].position;
      if (!fits(p, t, plane)) return;
      const auto height = static_cast<float>(p.z() - plane.at(p.x(), p.y()));
      if (best[cell] == none || height < best_height[cell] || (height == best_height[cell] && i < best[cell]))
        best[cell] = i, best_height[cell] = height;
    });
  }
  std::vector<std::uint32_t> out;
  for (const auto i : best)
    if (i != none) out.push_back(i);
  return out;
}

// Removes vertices that stand out of the plane through their neighbours by more than the ground may bend there; of
// adjacent ones only that which stands out most, since one spike makes all its neighbours look wrong.
bool TinFilter::prune_once() {
  const auto around = neighbourhood(surface_.triangles, surface_.points.size());
  std::vector<double> excess(surface_.points.size(), 0.0);
  const double bend = std::tan(scales_.max_angle_deg * rad_per_deg);
  for (std::size_t v = 0; v < surface_.measured; ++v) {
    const auto fit = plane_through_neighbours(surface_.points, around.of(v), surface_.points[v]);
    if (!fit.valid || pinned_[vertex_of_[v]]) continue;
    const double most = scales_.roughness + std::min(bend * fit.mean_distance, scales_.max_distance);
    excess[v] = std::max(0.0, std::abs(fit.residual) / most - 1.0);
  }
  bool removed = false;
  for (std::size_t v = 0; v < surface_.measured; ++v) {
    if (excess[v] <= 0) continue;
    const bool greatest = std::all_of(around.of(v).begin(), around.of(v).end(), [&](std::uint32_t n) {
      return excess[n] < excess[v] || (excess[n] == excess[v] && v < n);
    });
    if (greatest) accepted_[vertex_of_[v]] = 0, removed = true;
  }
  return removed;
}

}  // namespace

GroundSurface tin_ground(const std::vector<LowPoint>& candidates, const std::vector<std::uint32_t>& pinned,
                         const GridShape& shape, const GroundScales& scales, const Run& run) {
  return TinFilter(candidates, pinned, shape, scales, run).filter();
}

}  // namespace bole::ground
