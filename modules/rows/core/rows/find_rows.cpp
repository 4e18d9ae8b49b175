#include "rows/core/rows/find_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "rows/core/rows/median_or.h"
#include "rows/core/rows/row_tables.h"

namespace bole::rows {
namespace {

constexpr double widest_m = 3e6;
constexpr double ambiguous_ratio = 1.15;  // row spacing over plant spacing: below, across and along look alike

class Finder {
 public:
  Finder(const Table& stems, const RowOptions& options, const Run& run) : o_(options), run_(run) {
    set_.stems = &stems;
    take_plants(stems);
    if (stems.has("row_id")) take_labels(stems);
  }

  FoundRows find() {
    run_.report(0, "looking for rows");
    const std::vector<Chain> chains = labelled_ ? given_chains() : search();
    run_.report(0.7, "numbering plants");
    assemble(chains);
    if (!labelled_) take_up_leftovers();
    order();
    run_.report(0.95, "tables");
    fill_tables(set_, found_);
    report_counts();
    return std::move(found_);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void take_plants(const Table& stems) {
    const auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
    std::size_t lost = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
        ++lost;
        continue;
      }
      if (set_.plants.empty()) set_.origin = {x[i], y[i]};
      set_.plants.emplace_back(x[i] - set_.origin.x(), y[i] - set_.origin.y());
      if (!(set_.plants.back().norm() < widest_m))
        throw bad_input(
            fmt::format("stem {} at ({}, {}) is more than {:g} km from the first", i + 1, x[i], y[i], widest_m / 1000),
            "metres of one plane", "Are these degrees, or a wrong line?");
      set_.stem_rows.push_back(i);
    }
    if (set_.plants.empty())
      throw bad_input(fmt::format("the table has {} rows and no stem with coordinates", x.size()),
                      "columns x_m and y_m with numbers");
    if (lost > 0) found_.report.warn(fmt::format("{} stems without coordinates are ignored", lost));
  }

  // Plants by the text of their row_id; rows of numbers in order of the numbers, else of the texts.
  void take_labels(const Table& stems) {
    labelled_ = true;
    const auto& values = *stems.find("row_id");
    const bool text = std::holds_alternative<std::vector<std::string>>(values);
    set_.labels_are_numbers = !text;
    std::map<std::pair<double, std::string>, Chain> groups;
    for (int p = 0; p < static_cast<int>(set_.plants.size()); ++p) {
      const auto row = set_.stem_rows[at(p)];
      if (text) {
        const auto& label = stems.texts("row_id")[row];
        if (!label.empty()) groups[{0, label}].push_back(p);
        continue;
      }
      const double id = stems.numbers("row_id")[row];
      if (std::isnan(id)) continue;
      if (id != std::floor(id) || std::abs(id) > 1e15)
        throw bad_input(fmt::format("row_id {} in line {}", id, row + 1), "whole numbers or names");
      groups[{id, fmt::format("{:.0f}", id)}].push_back(p);
    }
    for (auto& [key, chain] : groups) {
      set_.labels.push_back(key.second);
      given_.push_back(std::move(chain));
    }
    if (set_.labels.empty()) throw bad_input("the column row_id is empty", "an id for every plant of a row");
  }

  std::vector<Chain> search() {
    if (set_.plants.size() < 2) return {};
    const PlantGrid grid(set_.plants);
    patterns_ = local_patterns(set_.plants, grid, o_, run_.part(0, 0.4));
    return grow_chains(set_.plants, grid, patterns_, o_, run_.part(0.4, 0.7));
  }

  // Each given group in the order along its line.
  std::vector<Chain> given_chains() {
    if (set_.plants.size() > 1) {
      const PlantGrid grid(set_.plants);
      patterns_ = local_patterns(set_.plants, grid, o_, run_.part(0, 0.6));
    }
    std::vector<Chain> chains = given_;
    for (auto& chain : chains) {
      Points2 points;
      for (const int p : chain) points.push_back(set_.plants[at(p)]);
      const auto fit = fit_orthogonal(points);
      if (std::isnan(fit.angle_rad)) continue;
      const Eigen::Vector2d u = fit.direction();
      std::stable_sort(chain.begin(), chain.end(),
                       [&](int a, int b) { return set_.plants[at(a)].dot(u) < set_.plants[at(b)].dot(u); });
    }
    return chains;
  }

  // Median of the steps of a given row, or of the pattern about the plants of a found one.
  double first_spacing(const Chain& chain) const {
    std::vector<double> s;
    if (labelled_)
      for (std::size_t i = 1; i < chain.size(); ++i)
        s.push_back((set_.plants[at(chain[i])] - set_.plants[at(chain[i - 1])]).norm());
    else
      for (const int p : chain) s.push_back(patterns_[at(p)].plant_spacing_m);
    return o_.plant_spacing ? *o_.plant_spacing : std::max(median_or(std::move(s), 1), 1e-9);
  }

  double row_spacing_about(const std::vector<int>& plants) const {
    if (o_.row_spacing) return *o_.row_spacing;
    std::vector<double> s;
    if (!patterns_.empty())
      for (const int p : plants) s.push_back(patterns_[at(p)].row_spacing_m);
    return median_or(std::move(s), std::numeric_limits<double>::infinity());
  }

  // Blocks from the chains as they are, for the direction that plants are counted in; then the rows.
  void assemble(const std::vector<Chain>& chains) {
    std::vector<PlantRow> rough;
    std::vector<double> row_spacing;
    for (const auto& chain : chains) {
      run_.check_cancel();
      rough.push_back(assemble_row(set_.plants, chain, first_spacing(chain), o_, labelled_).row);
      row_spacing.push_back(row_spacing_about(chain));
    }
    const auto blocks = find_blocks(rough, set_.plants, row_spacing);
    set_.rows.resize(chains.size());
    std::vector<bool> used(set_.plants.size(), false);
    for (const auto& block : blocks) {
      const Eigen::Vector2d u(std::cos(block.angle_rad), std::sin(block.angle_rad));
      for (const int r : block.rows) {
        run_.check_cancel();
        Chain chain = chains[at(r)];
        if ((set_.plants[at(chain.back())] - set_.plants[at(chain.front())]).dot(u) < 0)
          std::reverse(chain.begin(), chain.end());
        auto assembled = assemble_row(set_.plants, chain, first_spacing(chain), o_, labelled_);
        set_.rows[at(r)] = std::move(assembled.row);
        for (const int p : set_.rows[at(r)].plants) used[at(p)] = true;
      }
    }
    for (int p = 0; p < static_cast<int>(used.size()); ++p)
      if (!used[at(p)]) set_.strays.push_back(p);
  }

  bool fits(const PlantRow& row, const Eigen::Vector2d& p) const {
    if (row.plants.size() < 4) return false;
    const auto foot = row.curve.foot(p);
    if (std::abs(foot.across_m) > std::max(3.5 * row.curve.sigma_m(), 0.1 * row.spacing_m)) return false;
    if (foot.t_m < -1.3 * row.spacing_m || foot.t_m > row.curve.length_m() + 1.3 * row.spacing_m) return false;
    for (const int q : row.plants) {
      const double step = std::abs(row.curve.foot(set_.plants[at(q)]).t_m - foot.t_m) / row.spacing_m;
      if (step < 0.7) return false;
      if (step < 1.4 && std::abs(step - 1) > 0.3) return false;
    }
    return true;
  }

  // Plants that no chain took up, or that were dropped from another, where a row has a free place for them.
  void take_up_leftovers() {
    std::vector<int> left;
    for (const int p : set_.strays) {
      int home = -1;
      for (int r = 0; r < static_cast<int>(set_.rows.size()) && home < 0; ++r)
        if (fits(set_.rows[at(r)], set_.plants[at(p)])) home = r;
      if (home < 0) {
        left.push_back(p);
        continue;
      }
      auto& row = set_.rows[at(home)];
      Chain chain = row.plants;
      const double t = row.curve.foot(set_.plants[at(p)]).t_m;
      const auto place =
          std::find_if(chain.begin(), chain.end(), [&](int q) { return row.curve.foot(set_.plants[at(q)]).t_m > t; });
      chain.insert(place, p);
      auto assembled = assemble_row(set_.plants, chain, row.spacing_m, o_, false);
      row = std::move(assembled.row);
      left.insert(left.end(), assembled.strays.begin(), assembled.strays.end());
    }
    std::sort(left.begin(), left.end());
    set_.strays = std::move(left);
  }

  void order() {
    std::vector<double> row_spacing;
    for (const auto& row : set_.rows) row_spacing.push_back(row_spacing_about(row.plants));
    set_.blocks = find_blocks(set_.rows, set_.plants, row_spacing);
    for (std::size_t b = 0; b < set_.blocks.size(); ++b)
      for (const int r : set_.blocks[b].rows) {
        set_.rows[at(r)].block = static_cast<int>(b) + 1;
        if (!labelled_) set_.order.push_back(r);
      }
    if (labelled_)
      for (int r = 0; r < static_cast<int>(set_.rows.size()); ++r) set_.order.push_back(r);
  }

  void report_counts() {
    auto& r = found_.report;
    std::int64_t planted = 0, missing = 0, uneven = 0, curved = 0;
    std::vector<double> spacing, to_next, ratio;
    for (const auto& row : set_.rows) {
      planted += std::ssize(row.plants);
      missing += std::ssize(row.missing);
      curved += row.curve.degree() > 1 && row.plants.size() > 1;
      if (row.plants.size() >= 3 && !row.even) ++uneven;
      if (std::isfinite(row.spacing_m)) spacing.push_back(row.spacing_m);
    }
    for (const auto& block : set_.blocks)
      for (const double d : block.to_next_m)
        if (std::isfinite(d)) to_next.push_back(d);
    const double along = median_or(spacing, std::nan("")), across = median_or(to_next, std::nan(""));
    r.counts["stems"] = std::ssize(set_.plants);
    r.counts["rows"] = std::ssize(set_.rows);
    r.counts["blocks"] = std::ssize(set_.blocks);
    r.counts["plants"] = planted;
    r.counts["missing"] = missing;
    r.counts["strays"] = std::ssize(set_.strays);
    r.counts["curved"] = curved;
    if (std::isfinite(along)) r.metrics["plant_spacing"] = {along, Unit::metre};
    if (std::isfinite(across)) r.metrics["row_spacing"] = {across, Unit::metre};
    r.message = fmt::format("{} rows in {} blocks: {} plants, {} missing, {} strays", set_.rows.size(),
                            set_.blocks.size(), planted, missing, set_.strays.size());
    if (set_.rows.empty())
      r.warn(fmt::format(
          "no row of {} or more plants among {} stems{}: lower min_plants or raise lateral_tolerance{}", o_.min_plants,
          set_.plants.size(), o_.direction_deg ? fmt::format(" at {:.1f} deg from east", *o_.direction_deg) : "",
          o_.direction_deg ? ", or leave direction open. It counts in the axes of the stems, after they were placed"
                           : ""));
    if (uneven > 0)
      r.warn(fmt::format("{} rows are planted too unevenly to find missing plants: set plant_spacing if it is known",
                         uneven));
    if (!labelled_ && !o_.direction_deg && across < ambiguous_ratio * along)
      r.warn(
          fmt::format("rows are {:.2f} m apart and plants {:.2f} m: the rows may run the other way. Set direction "
                      "to fix it",
                      across, along));
  }

  const RowOptions& o_;
  const Run& run_;
  RowSet set_;
  FoundRows found_;
  std::vector<LocalPattern> patterns_;
  std::vector<Chain> given_;
  bool labelled_ = false;
};

}  // namespace

FoundRows find_rows(const Table& stems, const RowOptions& options, const Run& run) {
  return Finder(stems, options, run).find();
}

}  // namespace bole::rows
