#include "stems/core/tree/crown_cells.h"

#include <cmath>

#include "base/arrays.h"

namespace bole::stems {
namespace {

constexpr double max_cells = 48e6;
constexpr std::uint8_t low_noise = 7, high_noise = 18;

}  // namespace

CrownCells::CrownCells(const PointCloud& points, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double cell_m,
                       double bottom_m, const Run& run)
    : low_(low), cell_m_(cell_m) {
  const Eigen::Vector3d extent = (high - low).cwiseMax(cell_m);
  while ((extent / cell_m_).array().ceil().prod() > max_cells) cell_m_ *= 1.25;
  size_ = (extent / cell_m_).array().ceil().cast<int>().max(1);
  node_.assign(index(0, 0, size_.z()), none);
  const auto& heights = points.values<float>(arrays::height_above_ground);
  const auto* classes =
      points.has(arrays::classification) ? &points.values<std::uint8_t>(arrays::classification) : nullptr;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (!(heights[i] >= static_cast<float>(bottom_m))) continue;
    if (classes != nullptr && ((*classes)[i] == low_noise || (*classes)[i] == high_noise)) continue;
    if (const auto c = cell_of(points.positions()[i].cast<double>())) node_[index(c->x(), c->y(), c->z())] = 0;
  }
  number_nodes();
}

void CrownCells::number_nodes() {
  place_.clear();
  for (int z = 0; z < size_.z(); ++z)
    for (int y = 0; y < size_.y(); ++y)
      for (int x = 0; x < size_.x(); ++x)
        if (auto& node = node_[index(x, y, z)]; node != none) {
          node = static_cast<std::uint32_t>(place_.size());
          place_.emplace_back(x, y, z);
        }
}

CrownCells CrownCells::coarser(int times) const {
  CrownCells out;
  out.low_ = low_;
  out.cell_m_ = times * cell_m_;
  out.size_ = (size_.array() + times - 1) / times;
  out.node_.assign(out.index(0, 0, out.size_.z()), none);
  for (const auto& p : place_) out.node_[out.index(p.x() / times, p.y() / times, p.z() / times)] = 0;
  out.number_nodes();
  return out;
}

std::optional<Eigen::Vector3i> CrownCells::cell_of(const Eigen::Vector3d& p) const {
  if (!p.allFinite()) return std::nullopt;
  const Eigen::Vector3d q = (p - low_) / cell_m_;
  if (!((q.array() >= 0).all() && (q.array() < size_.array().cast<double>()).all())) return std::nullopt;
  return q.cast<int>();
}

std::uint32_t CrownCells::node_at(const Eigen::Vector3d& p) const {
  const auto c = cell_of(p);
  return c ? node_[index(c->x(), c->y(), c->z())] : none;
}

}  // namespace bole::stems
