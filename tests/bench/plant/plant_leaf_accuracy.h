// Leaves, internodes and branches beside the truth of a simulated seedling.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "base/statistics.h"
#include "cloud/table.h"
#include "io/core/tables/table_file.h"

namespace bole::bench {

struct LeafPair {
  std::size_t found, truth;
  double cost;
};

// Pairs of leaves whose nodes lie within 15 mm of height and whose azimuths within 60 degrees, the best first.
inline std::vector<LeafPair> pair_leaves(const Table& found, const Table& truth) {
  std::vector<LeafPair> all, out;
  if (found.rows() == 0 || truth.rows() == 0) return out;
  const auto h1 = found.numbers("height_mm"), h2 = truth.numbers("height_mm");
  const auto a1 = found.numbers("azimuth_deg"), a2 = truth.numbers("azimuth_deg");
  const auto l1 = found.numbers("length_mm"), l2 = truth.numbers("length_mm");
  for (std::size_t i = 0; i < h1.size(); ++i)
    for (std::size_t j = 0; j < h2.size(); ++j) {
      const double h = std::abs(h1[i] - h2[j]), a = std::abs(std::remainder(a1[i] - a2[j], 360.0));
      if (h > 15 || a > 60) continue;
      all.push_back({i, j, h / 5 + a / 20 + std::abs(l1[i] / l2[j] - 1) / 0.3});
    }
  std::ranges::sort(all, {}, &LeafPair::cost);
  std::vector<bool> used1(h1.size()), used2(h2.size());
  for (const auto& p : all) {
    if (used1[p.found] || used2[p.truth]) continue;
    used1[p.found] = used2[p.truth] = true;
    out.push_back(p);
  }
  return out;
}

inline double share_of(const std::vector<double>& v, double q) {
  if (v.empty()) return std::nan("");
  auto s = v;
  std::ranges::sort(s);
  return s[static_cast<std::size_t>(q * static_cast<double>(s.size() - 1))];
}

inline void compare_leaves(const Table& leaves, const Table& internodes, const Table& branches,
                           const std::filesystem::path& folder, bool list) {
  const auto truth = io::read_table(folder / "leaves.csv");
  const auto pairs = pair_leaves(leaves, truth);
  std::vector<double> area, length, width, angle, azimuth, height, stalk;
  std::size_t inside = 0;
  const auto value = [](const Table& t, const char* name, std::size_t i) { return t.numbers(name)[i]; };
  std::vector<long> of_truth(truth.rows(), -1);
  for (const auto& p : pairs) of_truth[p.truth] = static_cast<long>(p.found);
  for (const auto& p : pairs) {
    const auto ratio = [&](const char* name) {
      return 100 * (value(leaves, name, p.found) / value(truth, name, p.truth) - 1);
    };
    area.push_back(ratio("area_cm2"));
    length.push_back(ratio("length_mm"));
    width.push_back(ratio("width_mm"));
    angle.push_back(value(leaves, "angle_deg", p.found) - value(truth, "angle_deg", p.truth));
    azimuth.push_back(
        std::remainder(value(leaves, "azimuth_deg", p.found) - value(truth, "azimuth_deg", p.truth), 360.0));
    height.push_back(value(leaves, "height_mm", p.found) - value(truth, "height_mm", p.truth));
    stalk.push_back(value(leaves, "petiole_mm", p.found) - value(truth, "petiole_mm", p.truth));
    const double a = value(truth, "area_cm2", p.truth);
    inside += a >= value(leaves, "area_lo_cm2", p.found) && a <= value(leaves, "area_hi_cm2", p.found);
  }
  if (list) {
    std::printf("    truth: height azimuth angle length width petiole area -> found\n");
    for (std::size_t j = 0; j < truth.rows(); ++j) {
      const auto line = [&](const Table& t, std::size_t i) {
        std::printf("  [%2.0f] %6.1f %6.1f %5.1f %5.1f %5.1f %5.1f %6.2f", value(t, "axis", i),
                    value(t, "height_mm", i), value(t, "azimuth_deg", i), value(t, "angle_deg", i),
                    value(t, "length_mm", i), value(t, "width_mm", i), value(t, "petiole_mm", i),
                    value(t, "area_cm2", i));
      };
      line(truth, j);
      if (of_truth[j] >= 0) {
        line(leaves, static_cast<std::size_t>(of_truth[j]));
        std::printf(" %s", leaves.text("remark", static_cast<std::size_t>(of_truth[j])).c_str());
      }
      std::printf("\n");
    }
    for (std::size_t i = 0; i < leaves.rows(); ++i)
      if (std::ranges::none_of(pairs, [&](const auto& p) { return p.found == i; }))
        std::printf("    extra [%2.0f] height %.1f azimuth %.1f angle %.1f length %.1f width %.1f area %.2f %s\n",
                    value(leaves, "axis", i), value(leaves, "height_mm", i), value(leaves, "azimuth_deg", i),
                    value(leaves, "angle_deg", i), value(leaves, "length_mm", i), value(leaves, "width_mm", i),
                    value(leaves, "area_cm2", i), leaves.text("remark", i).c_str());
  }
  // Internodes whose two leaves are neighbours in the truth too.
  std::vector<double> internode;
  const auto true_nodes = io::read_table(folder / "internodes.csv");
  for (std::size_t k = 0; k < true_nodes.rows(); ++k) {
    const auto one = of_truth[static_cast<std::size_t>(value(true_nodes, "from_leaf", k))],
               two = of_truth[static_cast<std::size_t>(value(true_nodes, "to_leaf", k))];
    for (std::size_t i = 0; i < internodes.rows(); ++i)
      if (value(internodes, "from_leaf", i) == one + 1 && value(internodes, "to_leaf", i) == two + 1 && one >= 0)
        internode.push_back(value(internodes, "length_mm", i) - value(true_nodes, "length_mm", k));
  }
  const auto line = [](const char* name, std::vector<double> v, const char* unit) {
    double sum = 0, square = 0;
    for (const double e : v) {
      sum += e / static_cast<double>(v.size());
      square += e * e / static_cast<double>(v.size());
    }
    auto off = v;
    for (auto& e : off) e = std::abs(e);
    std::printf("  leaf %-10s n %2zu  median %+6.2f  mean %+6.2f  rms %6.2f  median |e| %5.2f  90%% |e| %6.2f %s\n",
                name, v.size(), v.empty() ? 0 : median(v), sum, std::sqrt(square), v.empty() ? 0 : median(off),
                share_of(off, 0.9), unit);
  };
  std::printf("  leaves: %zu of %zu, matched %zu, missed %zu, extra %zu; area in interval %zu\n", leaves.rows(),
              truth.rows(), pairs.size(), truth.rows() - pairs.size(), leaves.rows() - pairs.size(), inside);
  line("area", area, "%");
  line("length", length, "%");
  line("width", width, "%");
  line("angle", angle, "deg");
  line("azimuth", azimuth, "deg");
  line("node", height, "mm");
  line("petiole", stalk, "mm");
  line("internode", internode, "mm");
  const auto true_branches = io::read_table(folder / "branches.csv");
  for (std::size_t k = 0; k < true_branches.rows(); ++k)
    std::printf("  true branch height %.1f angle %.1f length %.1f\n", value(true_branches, "height_mm", k),
                value(true_branches, "angle_deg", k), value(true_branches, "length_mm", k));
  for (std::size_t k = 0; k < branches.rows(); ++k)
    std::printf("  found branch of %.0f height %.1f angle %.1f length %.1f leaves %.0f\n", value(branches, "parent", k),
                value(branches, "height_mm", k), value(branches, "angle_deg", k), value(branches, "length_mm", k),
                value(branches, "leaves", k));
}

}  // namespace bole::bench
