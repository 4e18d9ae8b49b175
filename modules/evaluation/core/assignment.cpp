#include "evaluation/core/assignment.h"

#include <algorithm>
#include <limits>
#include <map>

#include "base/groups.h"

namespace bole::evaluation {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Column of each row for the least sum of cost[row][column]; rows <= columns.
std::vector<std::size_t> hungarian(const std::vector<std::vector<double>>& cost) {
  const std::size_t n = cost.size(), m = n == 0 ? 0 : cost[0].size();
  std::vector<double> u(n + 1, 0), v(m + 1, 0);
  std::vector<std::size_t> row_of(m + 1, 0), way(m + 1, 0);
  for (std::size_t i = 1; i <= n; ++i) {
    row_of[0] = i;
    std::size_t j0 = 0;
    std::vector<double> least(m + 1, infinite);
    std::vector<bool> used(m + 1, false);
    do {
      used[j0] = true;
      const std::size_t i0 = row_of[j0];
      double delta = infinite;
      std::size_t j1 = 0;
      for (std::size_t j = 1; j <= m; ++j) {
        if (used[j]) continue;
        const double reduced = cost[i0 - 1][j - 1] - u[i0] - v[j];
        if (reduced < least[j]) least[j] = reduced, way[j] = j0;
        if (least[j] < delta) delta = least[j], j1 = j;
      }
      for (std::size_t j = 0; j <= m; ++j) {
        if (used[j])
          u[row_of[j]] += delta, v[j] -= delta;
        else
          least[j] -= delta;
      }
      j0 = j1;
    } while (row_of[j0] != 0);
    for (; j0 != 0; j0 = way[j0]) row_of[j0] = row_of[way[j0]];
  }
  std::vector<std::size_t> column(n, 0);
  for (std::size_t j = 1; j <= m; ++j)
    if (row_of[j] != 0) column[row_of[j] - 1] = j - 1;
  return column;
}

// One connected group. Each left row has a private column that means "no partner", dearer than any set of pairs.
void assign_group(const std::vector<Pairing>& group, std::vector<Pairing>& out) {
  std::map<std::size_t, std::size_t> rows, columns;
  double total = 1;
  for (const auto& p : group) {
    rows.try_emplace(p.left, rows.size());
    columns.try_emplace(p.right, columns.size());
    total += p.cost;
  }
  const double lonely = 2 * total, forbidden = lonely * static_cast<double>(rows.size() + 2);
  std::vector<std::vector<double>> cost(rows.size(), std::vector<double>(columns.size() + rows.size(), forbidden));
  for (std::size_t i = 0; i < rows.size(); ++i) cost[i][columns.size() + i] = lonely;
  for (const auto& p : group) cost[rows[p.left]][columns[p.right]] = p.cost;
  const auto column = hungarian(cost);
  for (const auto& p : group)
    if (column[rows[p.left]] == columns[p.right]) out.push_back(p);
}

}  // namespace

std::vector<Pairing> assign_pairs(const std::vector<Pairing>& offered) {
  std::size_t lefts = 0, rights = 0;
  for (const auto& p : offered) {
    lefts = std::max(lefts, p.left + 1);
    rights = std::max(rights, p.right + 1);
  }
  Groups groups(lefts + rights);
  for (const auto& p : offered) groups.join(p.left, lefts + p.right);
  std::map<std::size_t, std::vector<Pairing>> by_group;
  for (const auto& p : offered) by_group[groups.root(p.left)].push_back(p);
  std::vector<Pairing> out;
  for (const auto& [root, group] : by_group) assign_group(group, out);
  std::ranges::sort(out, {}, &Pairing::left);
  return out;
}

}  // namespace bole::evaluation
