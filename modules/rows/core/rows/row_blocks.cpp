#include "rows/core/rows/row_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/angles.h"
#include "base/groups.h"

namespace bole::rows {
namespace {

constexpr double same_direction = radians(15);
constexpr double neighbour_spacings = 1.7;  // a single row may have been lost between two, a headland not
constexpr int samples = 9;
constexpr int min_beside = 3;  // samples of the shorter row that lie beside the longer

// How far apart two rows run; nothing where they do not run side by side.
std::optional<double> distance_side_by_side(const RowCurve& a, const RowCurve& b) {
  const auto& from = a.length_m() <= b.length_m() ? a : b;
  const auto& onto = a.length_m() <= b.length_m() ? b : a;
  std::vector<double> across;
  for (int i = 0; i < samples; ++i) {
    const double t = from.length_m() * i / (samples - 1);
    const auto foot = onto.foot(from.at(t));
    if (foot.t_m < -1e-6 || foot.t_m > onto.length_m() + 1e-6) continue;
    const Eigen::Vector2d u = from.tangent(t), v = onto.tangent(foot.t_m);
    if (std::abs(u.x() * v.y() - u.y() * v.x()) > std::sin(same_direction)) continue;
    across.push_back(std::abs(foot.across_m));
  }
  if (std::ssize(across) < min_beside) return {};
  std::sort(across.begin(), across.end());
  return across[across.size() / 2];
}

Eigen::Vector2d middle_of_row(const PlantRow& row) { return row.curve.at(row.curve.length_m() / 2); }

double mean_angle(const std::vector<PlantRow>& rows, const std::vector<int>& members) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const int i : members) {
    const auto& c = rows[static_cast<std::size_t>(i)].curve;
    const Eigen::Vector2d chord = c.at(c.length_m()) - c.at(0);
    const double angle = std::atan2(chord.y(), chord.x());
    sum += chord.norm() * Eigen::Vector2d(std::cos(2 * angle), std::sin(2 * angle));
  }
  return row_angle(0.5 * std::atan2(sum.y(), sum.x()));
}

}  // namespace

std::vector<RowBlock> find_blocks(const std::vector<PlantRow>& rows, const Points2& plants,
                                  const std::vector<double>& row_spacing_m) {
  const int n = static_cast<int>(rows.size());
  Groups groups(rows.size());
  std::map<std::pair<int, int>, double> distances;
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      const auto& ra = rows[static_cast<std::size_t>(a)];
      const auto& rb = rows[static_cast<std::size_t>(b)];
      const double reach = neighbour_spacings * std::min(row_spacing_m[static_cast<std::size_t>(a)],
                                                         row_spacing_m[static_cast<std::size_t>(b)]);
      if (!std::isfinite(reach)) continue;
      if ((middle_of_row(ra) - middle_of_row(rb)).norm() > reach + (ra.curve.length_m() + rb.curve.length_m()) / 2)
        continue;
      const auto d = distance_side_by_side(ra.curve, rb.curve);
      if (!d || *d > reach) continue;
      distances[{a, b}] = *d;
      groups.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    }

  std::map<std::size_t, std::vector<int>> members;
  for (int i = 0; i < n; ++i) members[groups.root(static_cast<std::size_t>(i))].push_back(i);
  std::vector<std::pair<Eigen::Vector2d, RowBlock>> blocks;
  for (auto& [root, list] : members) {
    RowBlock block;
    block.angle_rad = mean_angle(rows, list);
    const Eigen::Vector2d left(-std::sin(block.angle_rad), std::cos(block.angle_rad));
    std::stable_sort(list.begin(), list.end(), [&](int a, int b) {
      return middle_of_row(rows[static_cast<std::size_t>(a)]).dot(left) >
             middle_of_row(rows[static_cast<std::size_t>(b)]).dot(left);
    });
    block.rows = list;
    for (std::size_t i = 0; i < list.size(); ++i) {
      double to_next = std::numeric_limits<double>::quiet_NaN();
      if (i + 1 < list.size())
        if (const auto it = distances.find(std::minmax(list[i], list[i + 1])); it != distances.end())
          to_next = it->second;
      block.to_next_m.push_back(to_next);
    }
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double count = 0;
    for (const int i : list)
      for (const int p : rows[static_cast<std::size_t>(i)].plants) {
        centre += plants[static_cast<std::size_t>(p)];
        count += 1;
      }
    blocks.emplace_back(centre / std::max(count, 1.0), std::move(block));
  }
  std::stable_sort(blocks.begin(), blocks.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.x(), a.first.y()) < std::pair(b.first.x(), b.first.y());
  });
  std::vector<RowBlock> result;
  for (auto& b : blocks) result.push_back(std::move(b.second));
  return result;
}

}  // namespace bole::rows
