#include "rows/core/rows/row_tables.h"

#include <cmath>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/option_text.h"
#include "base/statistics.h"

namespace bole::rows {
namespace {

constexpr double guidance_step_m = 1;

using Ids = Table::Values;

// The ids of listed things: `row_of[i]` is the row of thing i.
Ids ids_of(const RowSet& set, const std::vector<int>& row_of) {
  std::vector<std::int64_t> numbers;
  std::vector<std::string> texts;
  std::vector<std::int64_t> place(set.rows.size());
  for (std::size_t k = 0; k < set.order.size(); ++k)
    place[static_cast<std::size_t>(set.order[k])] = static_cast<std::int64_t>(k) + 1;
  for (const int r : row_of) {
    const auto i = static_cast<std::size_t>(r);
    if (set.labels.empty())
      numbers.push_back(place[i]);
    else if (set.labels_are_numbers)
      numbers.push_back(std::stoll(set.labels[i]));
    else
      texts.push_back(set.labels[i]);
  }
  if (!set.labels.empty() && !set.labels_are_numbers) return texts;
  return numbers;
}

constexpr const char* yaw_se_fact = "yaw_se_deg";  // of the axes of all stems: place_stems()

double yaw_se_rad(const RowSet& set) {
  const auto it = set.stems->facts.find(yaw_se_fact);
  return it == set.stems->facts.end() ? 0 : radians(number_from_text(it->second).value_or(0));
}

void copy_facts(const RowSet& set, Table& table) {
  for (const char* name : {"axes", "crs", yaw_se_fact})
    if (const auto it = set.stems->facts.find(name); it != set.stems->facts.end()) table.facts[name] = it->second;
}

// Ends of the row: the feet of its outer plants on its line.
std::pair<Eigen::Vector2d, Eigen::Vector2d> ends_of(const RowSet& set, const PlantRow& row) {
  const auto& a = set.plants[static_cast<std::size_t>(row.plants.front())];
  const auto& b = set.plants[static_cast<std::size_t>(row.plants.back())];
  if (row.plants.size() < 2) return {a + set.origin, a + set.origin};
  const Eigen::Vector2d u = row.line.direction();
  const auto foot = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return row.line.centre + (p - row.line.centre).dot(u) * u + set.origin;
  };
  return {foot(a), foot(b)};
}

Table rows_table(const RowSet& set) {
  std::vector<std::int64_t> block, place, plants, missing;
  std::vector<double> angle, se, lo, hi, x0, y0, x1, y1, spacing, spacing_sd, next, length, sagitta, rms;
  std::vector<std::string> shape;
  std::vector<int> index_in_block(set.rows.size());
  std::vector<double> to_next(set.rows.size(), no_number);
  const double turn_se = yaw_se_rad(set), turn_half = student_975(1e6) * turn_se;
  for (const auto& b : set.blocks)
    for (std::size_t k = 0; k < b.rows.size(); ++k) {
      index_in_block[static_cast<std::size_t>(b.rows[k])] = static_cast<int>(k) + 1;
      to_next[static_cast<std::size_t>(b.rows[k])] = b.to_next_m[k];
    }
  for (const int r : set.order) {
    const auto& row = set.rows[static_cast<std::size_t>(r)];
    const auto [a, b] = ends_of(set, row);
    const double half =
        std::hypot(student_975(static_cast<double>(row.plants.size()) - 2) * row.line.angle_se_rad, turn_half);
    angle.push_back(row.line.angle_rad / rad_per_deg);
    se.push_back(std::hypot(row.line.angle_se_rad, turn_se) / rad_per_deg);
    lo.push_back((row.line.angle_rad - half) / rad_per_deg);
    hi.push_back((row.line.angle_rad + half) / rad_per_deg);
    x0.push_back(a.x());
    y0.push_back(a.y());
    x1.push_back(b.x());
    y1.push_back(b.y());
    plants.push_back(std::ssize(row.plants));
    missing.push_back(std::ssize(row.missing));
    spacing.push_back(row.spacing_m);
    spacing_sd.push_back(row.spacing_sd_m);
    next.push_back(to_next[static_cast<std::size_t>(r)]);
    const bool alone = row.plants.size() < 2;
    length.push_back(alone ? 0 : row.curve.length_m());
    sagitta.push_back(alone ? 0 : row.curve.sagitta_m());
    rms.push_back(row.line.rms_m);
    shape.emplace_back(alone ? "plant" : row.curve.degree() == 1 ? "straight" : "curved");
    block.push_back(row.block);
    place.push_back(index_in_block[static_cast<std::size_t>(r)]);
  }
  Table t;
  t.set("row_id", ids_of(set, set.order));
  t.set("angle_deg", angle);
  t.set("angle_se_deg", se);
  t.set("x0_m", x0);
  t.set("y0_m", y0);
  t.set("x1_m", x1);
  t.set("y1_m", y1);
  t.set("plants", plants);
  t.set("spacing_m", spacing);
  t.set("spacing_sd_m", spacing_sd);
  t.set("missing", missing);
  t.set("block", block);
  t.set("row_in_block", place);
  t.set("to_next_m", next);
  t.set("angle_lo_deg", lo);
  t.set("angle_hi_deg", hi);
  t.set("length_m", length);
  t.set("rms_m", rms);
  t.set("shape", shape);
  t.set("sagitta_m", sagitta);
  copy_facts(set, t);
  return t;
}

void add_tree_ids(const RowSet& set, const std::vector<int>& plant_of, Table& table) {
  if (!set.stems->has("tree_id")) return;
  std::vector<std::string> ids;
  for (const int p : plant_of)
    ids.push_back(p < 0 ? std::string() : set.stems->text("tree_id", set.stem_rows[static_cast<std::size_t>(p)]));
  table.set("tree_id", ids);
}

// Coordinates of plants as the stems have them, to the last bit.
class StemPlaces {
 public:
  explicit StemPlaces(const RowSet& set) : set_(set), x_(set.stems->numbers("x_m")), y_(set.stems->numbers("y_m")) {}
  Eigen::Vector2d operator()(int plant) const {
    const auto row = set_.stem_rows[static_cast<std::size_t>(plant)];
    return {x_[row], y_[row]};
  }

 private:
  const RowSet& set_;
  std::vector<double> x_, y_;
};

Table plants_table(const RowSet& set) {
  std::vector<int> row_of, plant_of;
  std::vector<std::int64_t> number;
  std::vector<double> x, y, across;
  std::vector<std::string> state;
  const StemPlaces stem_at(set);
  for (const int r : set.order) {
    const auto& row = set.rows[static_cast<std::size_t>(r)];
    auto gap = row.missing.begin();
    const auto add = [&](int n, int plant, const Eigen::Vector2d& p, double a) {
      row_of.push_back(r);
      plant_of.push_back(plant);
      number.push_back(n);
      x.push_back(p.x());
      y.push_back(p.y());
      across.push_back(a);
      state.emplace_back(plant < 0 ? "missing" : "present");
    };
    for (std::size_t i = 0; i < row.plants.size(); ++i) {
      for (; gap != row.missing.end() && gap->number < row.numbers[i]; ++gap)
        add(gap->number, -1, gap->at + set.origin, no_number);
      const auto& p = set.plants[static_cast<std::size_t>(row.plants[i])];
      add(row.numbers[i], row.plants[i], stem_at(row.plants[i]),
          row.plants.size() < 2 ? 0 : row.curve.foot(p).across_m);
    }
  }
  Table t;
  t.set("row_id", ids_of(set, row_of));
  t.set("number", number);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("state", state);
  t.set("across_m", across);
  add_tree_ids(set, plant_of, t);
  copy_facts(set, t);
  return t;
}

Table lines_table(const RowSet& set) {
  std::vector<int> row_of;
  std::vector<std::int64_t> number;
  std::vector<double> x, y;
  for (const int r : set.order) {
    const auto& row = set.rows[static_cast<std::size_t>(r)];
    if (row.plants.size() < 2) continue;
    const auto [a, b] = ends_of(set, row);
    std::vector<Eigen::Vector2d> line{a, b};
    if (row.curve.degree() > 1) {
      line.clear();
      const int steps = std::max(2, static_cast<int>(std::ceil(row.curve.length_m() / guidance_step_m)));
      for (int i = 0; i <= steps; ++i) line.push_back(row.curve.at(row.curve.length_m() * i / steps) + set.origin);
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      row_of.push_back(r);
      number.push_back(static_cast<std::int64_t>(i) + 1);
      x.push_back(line[i].x());

      y.push_back(line[i].y());
    }
  }
  Table t;
  t.set("row_id", ids_of(set, row_of));
  t.set("number", number);
  t.set("x_m", x);
  t.set("y_m", y);
  copy_facts(set, t);
  return t;
}

Table strays_table(const RowSet& set) {
  std::vector<double> x, y;
  const StemPlaces stem_at(set);
  for (const int p : set.strays) {
    const auto at = stem_at(p);
    x.push_back(at.x());
    y.push_back(at.y());
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  add_tree_ids(set, set.strays, t);
  copy_facts(set, t);
  return t;
}

}  // namespace

void fill_tables(const RowSet& set, FoundRows& found) {
  found.rows = rows_table(set);
  found.plants = plants_table(set);
  found.lines = lines_table(set);
  found.strays = strays_table(set);
}

}  // namespace bole::rows
