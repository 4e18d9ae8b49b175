#include "plant/core/leaves/leaf_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/no_number.h"
#include "plant/core/leaves/leaf_tables.h"

namespace bole::plant {
namespace {

constexpr double section_step = 0.005;  // metres between sections of the stem

// Whether leaves and stem can be told apart at all.
bool find_doubts(const PlantOrgans& organs, Report& report) {
  if (organs.axes.empty() || organs.axes.front().curve.empty()) {
    report.find(Severity::look, "stem_not_followed",
                "The stem could not be followed from its foot: leaves and internodes were not measured. Look at the "
                "base of the plant.");
    return false;
  }
  const auto doubtful = std::ranges::count_if(organs.leaves, [](const auto& l) { return !l.doubt.empty(); });
  if (doubtful > 0)
    report.find(3 * static_cast<std::size_t>(doubtful) > organs.leaves.size() ? Severity::look : Severity::note,
                "leaves_doubtful",
                fmt::format("{} of {} leaves touch others, or are hidden in part: their rows say check.", doubtful,
                            organs.leaves.size()));
  const auto hanging = std::ranges::count_if(organs.leaves, &Leaf::on_other);
  const double stem = organs.axes.front().curve.length(), height = organs.axes.front().curve.places.back().z();
  const bool apart = 5 * static_cast<std::size_t>(hanging) <= organs.leaves.size() && stem <= 1.6 * height;
  if (!apart)
    report.find(
        Severity::look, "leaves_not_apart",
        fmt::format("{} of {} leaves hang on others: the cloud is too coarse or too thick to tell leaves and "
                    "stem apart. Number and area of the leaves and the length of the stem are left out; do not use the "
                    "tables of leaves and internodes.",
                    hanging, organs.leaves.size()));
  if (organs.sparse)
    report.find(Severity::look, "plant_too_sparse",
                fmt::format("The plant's points lie too far apart: {} gaps between them were bridged. Do not use the "
                            "leaves and internodes.",
                            organs.gaps));
  if (organs.lost_share > max_lost_share)
    report.find(
        Severity::look, "plant_in_pieces",
        fmt::format("{:.0f} % of the plant's points are not connected with its stem: leaves may be missing, and "
                    "the leaf area is a lower bound.",
                    100 * organs.lost_share));
  return apart && !organs.sparse;
}

void mark_doubts(PlantOrgans& organs) {
  for (auto& leaf : organs.leaves) {
    if (!leaf.doubt.empty()) continue;
    if (!leaf.touching.empty()) {
      leaf.doubt = "touches leaf";
      for (const int t : leaf.touching) leaf.doubt += fmt::format(" {}", t + 1);
    } else if (leaf.sheet.filled > 0.1) {
      leaf.doubt = fmt::format("{:.0f} % of its area has no points", 100 * leaf.sheet.filled);
    }
  }
}

}  // namespace

LeafTraits measure_leaves(const LeafInputs& in, const Run& run, Report& report) {
  LeafTraits out;
  out.organs = find_organs(*in.plant, {in.unit, in.spacing, in.noise, in.max_gap}, run);
  mark_doubts(out.organs);
  out.usable = find_doubts(out.organs, report);
  out.leaves = leaf_table(out.organs, in.R_world_plant, in.scale_sd, in.noise);
  out.internodes = internode_table(out.organs, in.R_world_plant);
  out.branches = branch_table(out.organs);
  report.counts["leaves"] = static_cast<std::int64_t>(out.organs.leaves.size());
  report.counts["branches"] = static_cast<std::int64_t>(out.organs.axes.size()) - 1;
  report.counts["gaps_bridged"] = static_cast<std::int64_t>(out.organs.gaps);
  return out;
}

void add_leaf_columns(Table& traits, const LeafTraits& leaves, const LeafInputs& in) {
  const auto set = [&](const std::string& name, const std::string& unit, double value, double low, double high) {
    traits.set(name + "_" + unit, std::vector<double>{value});
    traits.set(name + "_lo_" + unit, std::vector<double>{low});
    traits.set(name + "_hi_" + unit, std::vector<double>{high});
  };
  const auto& organs = leaves.organs;
  const bool found = leaves.usable;
  // What hangs on another leaf is most often a piece of it.
  const auto all = static_cast<double>(organs.leaves.size()),
             pieces = static_cast<double>(std::ranges::count_if(organs.leaves, &Leaf::on_other));
  traits.set("leaf_count", std::vector<double>{found ? all - pieces : no_number});
  traits.set("leaf_lo_count", std::vector<double>{found ? all - pieces : no_number});
  traits.set("leaf_hi_count", std::vector<double>{found ? all : no_number});
  double area = 0, low = 0, high = 0;
  for (const auto& leaf : organs.leaves) {
    const auto bounds = area_bounds(leaf, in.scale_sd, in.noise);
    area += leaf.sheet.area;
    low += bounds.low;
    high += bounds.high;
  }
  high += organs.lost_share * area;
  if (!found) area = low = high = no_number;
  set("leaf_area", "cm2", 1e4 * area, 1e4 * low, 1e4 * high);
  traits.set("branch_count", std::vector<double>{found ? static_cast<double>(organs.axes.size()) - 1 : no_number});
  const double length = found ? organs.axes.front().curve.length() : no_number;
  // The tip hides between the last leaves, up to an internode further, and what was followed may be the stalk of one.
  const double scale = in.scale_sd * length, down_sd = organs.stem_ends_in_leaf ? 0.6 : 0.25,
               up_sd = organs.stem_ends_in_leaf ? 0.25 : 0.12;
  set("stem_length", "mm", 1000 * length, 1000 * (length - 1.96 * std::hypot(down_sd * in.unit, scale)),
      1000 * (length + 1.96 * std::hypot(up_sd * in.unit, scale) + 0.6 * in.unit));
}

void add_stem_sections(Table& stem, const LeafTraits& leaves, const LeafInputs& in,
                       const std::function<DiameterThere(double arc)>& diameter_at) {
  if (leaves.organs.axes.empty() || leaves.organs.axes.front().curve.empty()) return;
  const auto& curve = leaves.organs.axes.front().curve;
  auto height = stem.numbers("height_mm"), x = stem.numbers("x_m"), y = stem.numbers("y_m"), z = stem.numbers("z_m"),
       diameter = stem.numbers("diameter_mm"), lo = stem.numbers("diameter_lo_mm"), hi = stem.numbers("diameter_hi_mm");
  auto source = stem.texts("source");
  const double none = std::numeric_limits<double>::infinity();
  const double first = height.empty() ? none : *std::ranges::min_element(height);
  const double last = height.empty() ? -none : *std::ranges::max_element(height);
  std::size_t below = 0;
  const double step = section_step * in.unit / 0.02;
  const auto steps = static_cast<std::size_t>(std::lround(curve.length() / step));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double along = std::min(curve.length(), static_cast<double>(i) * step);
    const Eigen::Vector3d p = curve.at(along);
    if (1000 * (p.z() + step / 2) > first && 1000 * (p.z() - step / 2) < last) continue;
    const bool down = 1000 * p.z() < first && !height.empty() && first < none;
    const auto at = down ? static_cast<std::ptrdiff_t>(below++) : static_cast<std::ptrdiff_t>(height.size());
    height.insert(height.begin() + at, 1000 * p.z());
    x.insert(x.begin() + at, p.x());
    y.insert(y.begin() + at, p.y());
    z.insert(z.begin() + at, p.z());
    const auto there = diameter_at(along);
    diameter.insert(diameter.begin() + at, 1000 * there.diameter);
    lo.insert(lo.begin() + at, 1000 * std::max(there.diameter - 1.96 * there.sd, 0.0));
    hi.insert(hi.begin() + at, 1000 * (there.diameter + 1.96 * there.sd));
    source.insert(source.begin() + at, there.seen ? "contours" : std::isfinite(there.diameter) ? "between" : "cloud");
  }
  Table all;
  all.facts = stem.facts;
  all.set("height_mm", height);
  all.set("x_m", x);
  all.set("y_m", y);
  all.set("z_m", z);
  all.set("diameter_mm", diameter);
  all.set("diameter_lo_mm", lo);
  all.set("diameter_hi_mm", hi);
  all.set("source", source);
  stem = std::move(all);
}

}  // namespace bole::plant
