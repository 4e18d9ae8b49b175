#include "plant/core/traits/outline.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr int cells_across = 120;         // of the larger side of the room
constexpr double first_margin = 1.0 / 3;  // of the size of the cloud's plant
constexpr double last_margin = 2;
constexpr double max_against = 0.08;        // share of the pictures that may show something else in a cell
constexpr int min_outline_views = 5;        // that must show a place
constexpr double max_refuted_share = 0.35;  // of the points: above it the pictures are not believed

constexpr std::size_t min_loose_cells = 12;  // of a piece that counts: a leaf of four by two centimetres has 30

constexpr int edge_parts = 4;       // of a cell at the edge of the room
constexpr double side_error = 0.7;  // cells of the masks: sides of four simulated plants scatter by that

enum class Shown { outside, hidden, plant, other };

Shown shown(const PlantMask& view, const Eigen::Vector3d& place, double behind) {
  const Eigen::Vector3d p = view.T_camera_plant * place;
  const auto at = view.camera.project(p);
  if (!at || !view.camera.contains(*at)) return Shown::outside;
  if (view.shows_plant(*at)) return Shown::plant;
  return view.others.hides(*at, p.z() - behind) ? Shown::hidden : Shown::other;
}

// The grid of cells that the room around a plant has.
class Room {
 public:
  Room(const Points3& plant, double margin) {
    Eigen::AlignedBox3d box;
    for (const auto& p : plant) box.extend(p);
    const double size = box.sizes().maxCoeff();
    const Eigen::Vector3d more(margin * size, margin * size, 0);
    min_ = box.min() - more;
    Eigen::Vector3d max = box.max() + more;
    max.z() += margin / 2 * size;
    // Down to the soil: the lowest leaves may be what is missing. Moss has the colour of plants, so not all of the way.
    min_.z() = 0.03 * box.max().z();
    cell_ = (max - min_).maxCoeff() / cells_across;
    count_ = ((max - min_) / cell_).array().ceil().cast<int>().max(1);
    state_.assign(static_cast<std::size_t>(count_.prod()), 0);
  }
  double cell() const { return cell_; }
  std::size_t layers() const { return static_cast<std::size_t>(count_.z()); }
  std::size_t layer_size() const { return static_cast<std::size_t>(count_.x()) * static_cast<std::size_t>(count_.y()); }
  Eigen::Vector3d centre(std::size_t i) const {
    const auto x = static_cast<int>(i % static_cast<std::size_t>(count_.x()));
    const auto y = static_cast<int>(i / static_cast<std::size_t>(count_.x()) % static_cast<std::size_t>(count_.y()));
    const auto z = static_cast<int>(i / layer_size());
    return min_ + cell_ * (Eigen::Vector3d(x, y, z).array() + 0.5).matrix();
  }
  std::uint8_t& state(std::size_t i) { return state_[i]; }
  bool at_border(std::size_t i) const { return at_border(centre(i)); }
  bool at_border(const Eigen::Vector3d& place) const {
    const Eigen::Array3d at = (place - min_).array() / cell_;
    return at.x() < 1 || at.y() < 1 || at.x() > count_.x() - 1 || at.y() > count_.y() - 1 || at.z() > count_.z() - 1;
  }

  // Spreads from the cells at `seeds` to all free cells (state 1) that touch, which become 2.
  void spread(const Points3& seeds) {
    Cells open;
    for (const auto& p : seeds) take_around(((p - min_) / cell_).array().floor().cast<int>(), open);
    spread_from(std::move(open));
  }

  // Free cells that are not connected with the plant, in pieces that are no crumbs.
  Points3 loose() {
    Points3 out;
    for (std::size_t i = 0; i < state_.size(); ++i) {
      if (state_[i] != 1) continue;
      Cells open;
      take_around(((centre(i) - min_) / cell_).array().floor().cast<int>(), open);
      const Cells piece = spread_from(std::move(open));
      if (piece.size() < min_loose_cells) continue;
      for (const auto& c : piece) out.push_back(centre(index(c)));
    }
    return out;
  }

 private:
  using Cells = std::vector<Eigen::Vector3i>;
  // The free cells at and around a cell become 2, and are added to `taken`.
  void take_around(const Eigen::Vector3i& c, Cells& taken) {
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const Eigen::Vector3i at = c + Eigen::Vector3i(x, y, z);
          if ((at.array() < 0).any() || (at.array() >= count_).any()) continue;
          auto& s = state_[index(at)];
          if (s == 1) s = 2, taken.push_back(at);
        }
  }
  Cells spread_from(Cells cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) take_around(Eigen::Vector3i(cells[k]), cells);
    return cells;
  }
  std::size_t index(const Eigen::Vector3i& c) const {
    const auto size = count_.cast<std::size_t>().eval();
    const auto at = c.cast<std::size_t>().eval();
    return (at.z() * size.y() + at.y()) * size.x() + at.x();
  }
  Eigen::Vector3d min_;
  double cell_ = 0;
  Eigen::Array3i count_;
  std::vector<std::uint8_t> state_;
};

// Whether the pictures leave room for the plant in a cell.
bool has_room(const PlantMasks& masks, const Eigen::Vector3d& place, double cell) {
  const double most = max_against * static_cast<double>(masks.views.size());
  int against = 0, seen = 0;
  for (const auto& view : masks.views) {
    const Shown s = shown(view, place, cell);
    if (s == Shown::other && ++against > most) return false;
    if (s == Shown::other || s == Shown::plant) ++seen;
  }
  return seen >= min_outline_views && against <= max_against * seen;
}

// The outermost cells, those that decide over height and breadth, in `parts` along each side: what of them is free.
Points3 finer_edge(const Points3& cells, double cell, const PlantMasks& masks) {
  constexpr int directions = 72, parts = edge_parts;
  std::vector<bool> outer(cells.size(), false);
  const auto take = [&](const Eigen::Vector3d& d) {
    double high = cells.front().dot(d);
    for (const auto& c : cells) high = std::max(high, c.dot(d));
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].dot(d) > high - 1.5 * cell) outer[i] = true;
  };
  take(Eigen::Vector3d::UnitZ());
  for (int k = 0; k < directions; ++k) {
    const double turn = 2 * std::numbers::pi * k / directions;
    take({std::cos(turn), std::sin(turn), 0});
  }
  Points3 out, asked;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!outer[i]) {
      out.push_back(cells[i]);
      continue;
    }
    for (int k = 0; k < parts * parts * parts; ++k) {
      const Eigen::Array3i part_index(k % parts, k / parts % parts, k / parts / parts);
      const Eigen::Array3d part = part_index.cast<double>();
      asked.push_back(cells[i] + (cell * ((part + 0.5) / parts - 0.5)).matrix());
    }
  }
  std::vector<std::uint8_t> free(asked.size(), 0);
  tbb::parallel_for(std::size_t{0}, asked.size(),
                    [&](std::size_t i) { free[i] = has_room(masks, asked[i], cell) ? 1 : 0; });
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (free[i] != 0) out.push_back(asked[i]);
  return out;
}

Points3 points_on_plant(const Points3& plant, const PlantMasks& masks, const Run& run) {
  std::vector<std::uint8_t> refuted(plant.size(), 0);
  run.check_cancel();
  tbb::parallel_for(std::size_t{0}, plant.size(), [&](std::size_t i) {
    int on = 0, beside = 0;
    for (const auto& view : masks.views) {
      const Shown s = shown(view, plant[i], 0.01 * std::abs(plant[i].z()));
      on += s == Shown::plant ? 1 : 0;
      beside += s == Shown::other ? 1 : 0;
    }
    refuted[i] = on + beside >= min_outline_views && beside > on;
  });
  const auto count = std::ranges::count(refuted, std::uint8_t{1});
  if (static_cast<double>(count) > max_refuted_share * static_cast<double>(plant.size())) return plant;
  Points3 out;
  for (std::size_t i = 0; i < plant.size(); ++i)
    if (refuted[i] == 0) out.push_back(plant[i]);
  return out;
}

struct FreeRoom {
  Points3 connected;  // with the plant; the outermost cells in finer parts
  Points3 loose;      // not connected with it
  double cell = 0;    // edge of a cell, m
};

// What of a room around the plant is free. `ends`: whether the plant ends in it, and the loose pieces do.
struct FilledRoom {
  FreeRoom free;
  bool ends = true, loose_ends = true;
};

FilledRoom filled_room(const Points3& plant, const PlantMasks& masks, double margin, const Run& run) {
  FilledRoom out;
  Room room(plant, margin);
  out.free.cell = room.cell();
  for (std::size_t z = 0; z < room.layers(); ++z) {
    run.check_cancel();
    run.report(static_cast<double>(z) / static_cast<double>(room.layers()), "room for the plant in the pictures");
    tbb::parallel_for(z * room.layer_size(), (z + 1) * room.layer_size(),
                      [&](std::size_t i) { room.state(i) = has_room(masks, room.centre(i), room.cell()) ? 1 : 0; });
  }
  room.spread(plant);
  for (std::size_t i = 0; i < room.layers() * room.layer_size(); ++i) {
    if (room.state(i) != 2) continue;
    out.free.connected.push_back(room.centre(i));
    out.ends = out.ends && !room.at_border(i);
  }
  out.free.loose = room.loose();
  out.loose_ends = std::ranges::none_of(out.free.loose, [&](const auto& c) { return room.at_border(c); });
  return out;
}

// The room is made wider until the plant ends in it, and then for the loose pieces, whose cells may be coarser.
// Pictures that leave room without end say nothing.
FreeRoom room_for(const Points3& plant, const PlantMasks& masks, const Run& run) {
  FreeRoom found;
  for (double margin = first_margin; margin <= last_margin; margin *= 2) {
    auto room = filled_room(plant, masks, margin, run);
    if (found.connected.empty() && room.ends && !room.free.connected.empty())
      found = {finer_edge(room.free.connected, room.free.cell, masks), {}, room.free.cell};
    if (found.connected.empty() || !room.loose_ends) continue;
    found.loose = std::move(room.free.loose);
    break;
  }
  return found;
}

// Whether enough pictures look across `direction` at the outermost place there: more than those that may be against it.
bool seen_across(const Points3& cells, const PlantMasks& masks, const Eigen::Vector3d& direction) {
  constexpr double across = 0.3;  // cosine
  const auto far = std::ranges::max_element(cells, {}, [&](const Eigen::Vector3d& c) { return c.dot(direction); });
  int looking = 0;
  for (const auto& v : masks.views) {
    const Eigen::Vector3d p = v.T_camera_plant * *far;
    const auto at = v.camera.project(p);
    if (!at || !v.camera.contains(*at)) continue;
    const Eigen::Vector3d ray = v.T_camera_plant.linear().transpose() * p.normalized();
    looking += std::abs(ray.dot(direction)) < across ? 1 : 0;
  }
  return looking > max_against * static_cast<double>(masks.views.size()) + 1;
}

// What a cell of the masks is at the plant, in units of the cloud: the median of the views.
double mask_step(const Points3& plant, const PlantMasks& masks) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& p : plant) middle += p / static_cast<double>(plant.size());
  std::vector<double> steps;
  for (const auto& v : masks.views) {
    const double depth = (v.T_camera_plant * middle).z();
    if (depth > 0) steps.push_back(v.cell_px * depth / std::abs(v.camera.fx));
  }
  return steps.empty() ? 0 : median(std::move(steps));
}

}  // namespace

Outline measure_outline(const MaskInputs& inputs, const std::vector<std::uint32_t>& which, const Run& run) {
  Outline out;
  const auto masks = plant_masks(inputs, which, run.part(0, 0.5));
  out.told = masks.told;
  out.points = *inputs.plant;
  if (!out.told) return out;
  out.views = masks.views.size();
  out.points = points_on_plant(*inputs.plant, masks, run);
  out.refuted = 1 - static_cast<double>(out.points.size()) / static_cast<double>(inputs.plant->size());
  const auto free = room_for(out.points, masks, run.part(0.5, 1));
  const auto& room = free.connected;
  if (room.size() < 20) {
    out.told = false;
    return out;
  }
  const auto sizes = sizes_of(room);
  // Of one side: the masks end within a cell of theirs, the room within a part of a cell.
  const double side_sd = std::hypot(side_error * mask_step(out.points, masks), free.cell / edge_parts / 2);
  Extents extents;
  std::vector<Eigen::Vector2d> plan;
  for (const auto& c : room) plan.emplace_back(c.head<2>());
  extents.rectangle = smallest_rectangle(plan);
  extents.length = {sizes.length, sizes.length, std::numbers::sqrt2 * side_sd};
  extents.width = {sizes.width, sizes.width, std::numbers::sqrt2 * side_sd};
  take_scatter_of_rectangle(plan, extents);
  out.top = {sizes.top, sizes.top, side_sd};
  out.length = extents.length;
  out.width = extents.width;
  out.rectangle = extents.rectangle;
  Points3 all = room;
  all.insert(all.end(), free.loose.begin(), free.loose.end());
  out.with_loose = sizes_of(all);
  const auto both_sides = [&](const Eigen::Vector2d& way) {
    const Eigen::Vector3d d = Eigen::Vector3d(way.x(), way.y(), 0).normalized();
    return seen_across(room, masks, d) && seen_across(room, masks, -d);
  };
  const auto& corners = out.rectangle.corners;
  const Eigen::Vector2d first = corners[1] - corners[0], second = corners[2] - corners[1];
  out.top_measured = seen_across(room, masks, Eigen::Vector3d::UnitZ());
  out.length_measured = both_sides(first.norm() >= second.norm() ? first : second);
  out.width_measured = both_sides(first.norm() >= second.norm() ? second : first);
  return out;
}

}  // namespace bole::plant
