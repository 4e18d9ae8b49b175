#include "stems/core/detect/stem_candidates.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/angles.h"

namespace bole::stems {
namespace {

struct Axis {
  double x = 0, y = 0, z = 0, sx = 0, sy = 0, r = 0, taper = 0;
  double x_at(double h) const { return x + sx * (h - z); }
  double y_at(double h) const { return y + sy * (h - z); }
  double r_at(double h) const { return r + taper * (h - z); }
};

double position_tolerance(double radius) { return std::max(0.03, 0.30 * radius); }
double radius_tolerance(double radius) { return std::max(0.02, 0.30 * radius); }

// Circles by place, for neighbours of up to one cell away.
class CircleGrid {
 public:
  CircleGrid(const std::vector<SlabCircle>& circles, double cell) : cell_(cell) {
    for (std::uint32_t i = 0; i < circles.size(); ++i) cells_[key(circles[i].x, circles[i].y)].push_back(i);
  }
  std::vector<std::uint32_t> around(double x, double y) const {
    std::vector<std::uint32_t> out;
    const auto [kx, ky] = key(x, y);
    for (long dy = -1; dy <= 1; ++dy)
      for (long dx = -1; dx <= 1; ++dx)
        if (const auto it = cells_.find({kx + dx, ky + dy}); it != cells_.end())
          out.insert(out.end(), it->second.begin(), it->second.end());
    std::ranges::sort(out);
    return out;
  }

 private:
  std::pair<long, long> key(double x, double y) const {
    return {std::lround(std::floor(x / cell_)), std::lround(std::floor(y / cell_))};
  }
  double cell_;
  std::map<std::pair<long, long>, std::vector<std::uint32_t>> cells_;
};

struct Consensus {
  Axis axis;
  std::vector<std::uint32_t> members;
  double score = 0;
};

class Linker {
 public:
  Linker(const std::vector<SlabCircle>& circles, const MeasureOptions& options)
      : circles_(circles),
        taken_(circles.size(), false),
        max_slope_(std::tan(radians(options.max_lean_deg))),
        grid_(circles, (options.search_top - options.search_bottom) * max_slope_ * 0.5 + 0.5) {}

  // The best axis through circle `i` and one of its neighbours.
  Consensus best_through(std::uint32_t i) const {
    Consensus best;
    const auto& a = circles_[i];
    const auto near = grid_.around(a.x, a.y);
    for (const auto j : near) {
      const auto& b = circles_[j];
      const double dz = b.z - a.z;
      if (taken_[j] || b.slab == a.slab || std::abs(dz) < 0.15 || std::abs(dz) > 1.3) continue;
      if (std::abs(a.radius - b.radius) > radius_tolerance(0.5 * (a.radius + b.radius))) continue;
      const Axis axis{a.x, a.y, a.z, (b.x - a.x) / dz, (b.y - a.y) / dz, a.radius, 0};
      if (std::hypot(axis.sx, axis.sy) > max_slope_) continue;
      auto found = consent(axis, near);
      if (found.score > best.score) best = std::move(found);
    }
    for (int round = 0; round < 2 && best.members.size() >= 3; ++round) {
      auto better = consent(fitted(best.members), near);
      if (better.members.size() < best.members.size()) break;
      best = std::move(better);
    }
    return best;
  }

  // Marks the members, and every circle that the stem leaves no room for; returns the latter.
  std::vector<SlabCircle> take(const Consensus& c) {
    for (const auto i : c.members) taken_[i] = true;
    std::vector<SlabCircle> displaced;
    for (const auto i : grid_.around(c.axis.x, c.axis.y)) {
      const auto& o = circles_[i];
      if (taken_[i] || std::hypot(o.x - c.axis.x_at(o.z), o.y - c.axis.y_at(o.z)) >=
                           std::max(0.8 * c.axis.r_at(o.z), 0.5 * o.radius))
        continue;
      taken_[i] = true, displaced.push_back(o);
    }
    return displaced;
  }
  bool taken(std::uint32_t i) const { return taken_[i]; }

 private:
  Consensus consent(const Axis& axis, const std::vector<std::uint32_t>& near) const {
    std::map<int, std::pair<double, std::uint32_t>> by_slab;  // nearest circle of each slab
    for (const auto i : near) {
      if (taken_[i]) continue;
      const auto& c = circles_[i];
      const double r = axis.r_at(c.z), dr = (c.radius - r) / radius_tolerance(r);
      const double dx = c.x - axis.x_at(c.z), dy = c.y - axis.y_at(c.z), reach = position_tolerance(r);
      const double off2 = (dx * dx + dy * dy) / (reach * reach), dr2 = dr * dr;
      if (off2 > 1 || dr2 > 1) continue;
      const double cost = off2 + dr2;
      if (const auto it = by_slab.find(c.slab); it == by_slab.end() || cost < it->second.first)
        by_slab[c.slab] = {cost, i};
    }
    Consensus out;
    out.axis = axis;
    for (const auto& [slab, entry] : by_slab) {
      out.members.push_back(entry.second);
      out.score += std::sqrt(std::max(0.0, circles_[entry.second].score)) * (1 - 0.4 * entry.first);
    }
    return out;
  }

  Axis fitted(const std::vector<std::uint32_t>& members) const {
    double w = 0, z = 0;
    for (const auto i : members) w += 1, z += circles_[i].z;
    z /= w;
    double zz = 1e-3, mx = 0, my = 0, mr = 0, zx = 0, zy = 0, zr = 0;
    for (const auto i : members) {
      const auto& c = circles_[i];
      const double dz = c.z - z;
      zz += dz * dz, mx += c.x / w, my += c.y / w, mr += c.radius / w, zx += dz * c.x, zy += dz * c.y,
          zr += dz * c.radius;
    }
    for (const auto i : members)
      zx -= (circles_[i].z - z) * mx, zy -= (circles_[i].z - z) * my, zr -= (circles_[i].z - z) * mr;
    return {mx, my, z, zx / zz, zy / zz, mr, std::clamp(zr / zz, -0.03, 0.01)};
  }

  const std::vector<SlabCircle>& circles_;
  std::vector<bool> taken_;
  double max_slope_;
  CircleGrid grid_;
};

StemCandidate candidate_of(const Consensus& c, const std::vector<SlabCircle>& circles) {
  StemCandidate s;
  s.x = c.axis.x, s.y = c.axis.y, s.z = c.axis.z, s.slope_x = c.axis.sx, s.slope_y = c.axis.sy, s.radius = c.axis.r,
  s.taper = c.axis.taper;
  s.score = c.score, s.sections = static_cast<int>(c.members.size()), s.lowest = 1e9, s.highest = -1e9;
  for (const auto i : c.members) {
    const auto& m = circles[i];
    s.lowest = std::min(s.lowest, m.height), s.highest = std::max(s.highest, m.height), s.points += m.points;
    s.ground_z += (m.z - m.height) / static_cast<double>(c.members.size());
  }
  return s;
}

}  // namespace

LinkedCircles link_circles(const std::vector<SlabCircle>& circles, const MeasureOptions& options, const Run& run) {
  Linker linker(circles, options);
  LinkedCircles out;
  std::vector<Consensus> first(circles.size());
  const auto look_through = [&](const auto& block) {
    for (auto i = block.begin(); i != block.end() && !run.cancelled(); ++i) first[i] = linker.best_through(i);
  };
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(circles.size()), 16), look_through);
  run.check_cancel();
  std::vector<std::pair<Consensus, std::uint32_t>> queue;
  for (std::uint32_t i = 0; i < circles.size(); ++i)
    if (first[i].members.size() >= 2) queue.emplace_back(std::move(first[i]), i);
  const auto weaker = [](const auto& a, const auto& b) { return a.first.score < b.first.score; };
  std::ranges::make_heap(queue, weaker);
  while (!queue.empty()) {
    run.check_cancel();
    std::ranges::pop_heap(queue, weaker);
    auto [best, seed] = std::move(queue.back());
    queue.pop_back();
    if (linker.taken(seed)) continue;
    if (std::ranges::any_of(best.members,
                            [&](auto i) { return linker.taken(i); })) {  // a stronger stem took some: look again
      if (auto again = linker.best_through(seed); again.members.size() >= 2) {
        queue.emplace_back(std::move(again), seed);
        std::ranges::push_heap(queue, weaker);
      }
      continue;
    }
    auto displaced = linker.take(best);
    auto candidate = candidate_of(best, circles);
    candidate.displaced = std::move(displaced);
    (candidate.sections >= options.min_sections ? out.stems : out.weak).push_back(candidate);
  }
  return out;
}

}  // namespace bole::stems
