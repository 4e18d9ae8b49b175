#include "plant/core/leaves/plant_graph.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "cloud/voxels.h"

namespace bole::plant {
namespace {

constexpr double off_sheet_cost = 6, crease_cost = 4, gap_cost = 2.5;
constexpr std::size_t block = 20000;  // nodes between two looks at the cancel flag

struct Thinned {
  Points3 places;
  std::vector<std::uint32_t> of_point;
};

Thinned thin(const Points3& points, double cell) {
  Thinned out;
  std::vector<std::uint64_t> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) keys[i] = voxel_key(points[i], cell);
  auto unique = keys;
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  out.places.assign(unique.size(), Eigen::Vector3d::Zero());
  out.of_point.resize(points.size());
  std::vector<double> count(unique.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto node = static_cast<std::uint32_t>(std::ranges::lower_bound(unique, keys[i]) - unique.begin());
    out.of_point[i] = node;
    out.places[node] += points[i];
    count[node] += 1;
  }
  for (std::size_t n = 0; n < unique.size(); ++n) out.places[n] /= count[n];
  return out;
}

struct Sheet {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(), middle = Eigen::Vector3d::Zero();
  double flatness = 0;
};

// The plane through the neighbours of each place, near ones counting more.
std::vector<Sheet> sheets_of(const Points3& places, double radius, const Run& run) {
  const PointGrid grid(places, radius);
  std::vector<Sheet> out(places.size());
  for (std::size_t begin = 0; begin < places.size(); begin += block) {
    run.check_cancel();
    tbb::parallel_for(begin, std::min(begin + block, places.size()), [&](std::size_t i) {
      double total = 0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      grid.near(places[i], radius, [&](std::uint32_t k, double d2) {
        const double w = 1 - 0.9 * d2 / (radius * radius);
        const Eigen::Vector3d d = places[k] - places[i];
        total += w;
        sum += w * d;
        squares += w * d * d.transpose();
      });
      const Eigen::Vector3d mean = sum / total;
      out[i].middle = places[i] + mean;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / total - mean * mean.transpose());
      const auto& v = solver.eigenvalues();
      out[i].normal = solver.eigenvectors().col(0);
      if (v[2] > 0) out[i].flatness = std::clamp((v[1] - v[0]) / v[2], 0.0, 1.0);
    });
  }
  return out;
}

class Linking {
 public:
  Linking(PlantGraph& graph, double reach, double max_gap, const Run& run)
      : g_(graph), reach_(reach), max_gap_(max_gap), run_(run), grid_(graph.places, reach) {}

  void link() {
    links_.resize(g_.size());
    for (std::size_t begin = 0; begin < g_.size(); begin += block) {
      run_.check_cancel();
      tbb::parallel_for(begin, std::min(begin + block, g_.size()), [&](std::size_t i) {
        grid_.near(g_.places[i], reach_, [&](std::uint32_t k, double) {
          if (k != i) links_[i].push_back({k, cost(static_cast<std::uint32_t>(i), k)});
        });
        std::ranges::sort(links_[i], {}, &Link::to);
      });
    }
    bridge();
    g_.first.assign(1, 0);
    for (const auto& links : links_) {
      for (const auto& l : links) {
        g_.neighbour.push_back(l.to);
        g_.cost.push_back(l.cost);
      }
      g_.first.push_back(static_cast<std::uint32_t>(g_.neighbour.size()));
    }
  }

 private:
  struct Link {
    std::uint32_t to;
    double cost;
  };

  double cost(std::uint32_t a, std::uint32_t b) const {
    const Eigen::Vector3d d = g_.places[b] - g_.places[a];
    const double length = d.norm();
    if (!(length > 0)) return 1e-9;
    const double off =
        std::max(std::abs(d.dot(g_.normals[a])) * g_.flatness[a], std::abs(d.dot(g_.normals[b])) * g_.flatness[b]) /
        length;
    const double crease = (1 - std::abs(g_.normals[a].dot(g_.normals[b]))) * std::min(g_.flatness[a], g_.flatness[b]);
    return length * (1 + off_sheet_cost * off * off + crease_cost * crease);
  }

  std::vector<std::uint32_t> parts() const {
    std::vector<std::uint32_t> part(g_.size(), std::numeric_limits<std::uint32_t>::max());
    std::uint32_t count = 0;
    std::vector<std::uint32_t> stack;
    for (std::uint32_t i = 0; i < g_.size(); ++i) {
      if (part[i] != std::numeric_limits<std::uint32_t>::max()) continue;
      part[i] = count;
      stack.assign(1, i);
      while (!stack.empty()) {
        const auto at = stack.back();
        stack.pop_back();
        for (const auto& l : links_[at])
          if (part[l.to] > count) {
            part[l.to] = count;
            stack.push_back(l.to);
          }
      }
      ++count;
    }
    return part;
  }

  struct Bridge {
    double gap = std::numeric_limits<double>::infinity();
    std::uint32_t from = 0, to = 0;
  };

  // Every part but the largest is linked with what is nearest to it, until all are one or too far away (Boruvka).
  void bridge() {
    for (;;) {
      run_.check_cancel();
      const auto part = parts();
      if (part.empty()) return;
      const auto count = *std::ranges::max_element(part) + 1;
      if (count == 1) return;
      std::vector<std::size_t> sizes(count, 0);
      for (const auto p : part) ++sizes[p];
      const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
      std::vector<Bridge> best(count);
      for (std::uint32_t i = 0; i < g_.size(); ++i) {
        if (part[i] == largest) continue;
        auto& b = best[part[i]];
        for (double radius = 2 * reach_;; radius *= 2) {
          const double within = std::min({radius, max_gap_, b.gap});
          grid_.near(g_.places[i], within, [&](std::uint32_t k, double d2) {
            if (part[k] != part[i] && std::sqrt(d2) < b.gap) b = {std::sqrt(d2), i, k};
          });
          if (b.gap <= radius || max_gap_ <= radius) break;
        }
      }
      bool added = false;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> done;
      for (const auto& b : best) {
        if (!(b.gap <= max_gap_)) continue;
        const auto ends = std::minmax(b.from, b.to);
        if (std::ranges::find(done, std::pair(ends.first, ends.second)) != done.end()) continue;
        done.emplace_back(ends.first, ends.second);
        links_[b.from].push_back({b.to, gap_cost * b.gap});
        links_[b.to].push_back({b.from, gap_cost * b.gap});
        ++g_.gaps;
        g_.widest_gap = std::max(g_.widest_gap, b.gap);
        added = true;
      }
      if (!added) return;
    }
  }

  PlantGraph& g_;
  double reach_, max_gap_;
  const Run& run_;
  PointGrid grid_;
  std::vector<std::vector<Link>> links_;
};

}  // namespace

PlantGraph plant_graph(const Points3& plant, double cell, double noise, double max_gap, const Run& run) {
  PlantGraph out;
  out.cell = cell;
  const double radius = std::max(3 * cell, 4 * noise);
  auto rough = thin(plant, cell);
  const auto rough_sheets = sheets_of(rough.places, radius, run);
  for (std::size_t i = 0; i < rough.places.size(); ++i) {
    const auto& s = rough_sheets[i];
    // Threads and lumps stay as they are: a plane through a thin stem would make a ribbon of it.
    const double share = std::clamp((s.flatness - 0.3) / 0.3, 0.0, 1.0);
    rough.places[i] -= share * s.normal.dot(rough.places[i] - s.middle) * s.normal;
  }
  auto fine = thin(rough.places, cell);
  out.places = std::move(fine.places);
  out.node_of_point.resize(plant.size());
  for (std::size_t i = 0; i < plant.size(); ++i) out.node_of_point[i] = fine.of_point[rough.of_point[i]];
  const auto sheets = sheets_of(out.places, radius, run);
  for (const auto& s : sheets) {
    out.normals.push_back(s.normal);
    out.flatness.push_back(s.flatness);
  }
  Linking(out, 2.2 * cell, max_gap, run).link();
  return out;
}

}  // namespace bole::plant
