#include "rows/core/edits/edited_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/option_text.h"
#include "rows/core/rows/joined_tables.h"
#include "rows/core/rows/line_fit.h"

namespace bole::rows {
namespace {

using Eigen::Vector2d;

// The ids as one type for all tables: whole numbers where all of them are.
Table::Values ids_as(std::vector<std::string> ids, bool numbers) {
  if (!numbers) return ids;
  std::vector<std::int64_t> out;
  for (const auto& id : ids) out.push_back(is_whole_number(id) ? std::stoll(id) : 0);
  return out;
}

std::vector<std::string> ids_of(const Table& t) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < t.rows(); ++i) ids.push_back(t.text("row_id", i));
  return ids;
}

class Composer {
 public:
  Composer(const EditableRows& field, const FoundRows& before, const RowEditOptions& options, const Run& run)
      : field_(field), before_(before), o_(options), run_(run) {
    numbers_ = std::ranges::all_of(field.rows, [](const auto& row) { return is_whole_number(row.id); });
  }

  FoundRows compose() {
    measure();
    add_bare_rows();
    keep_the_rest();
    for (const auto& row : field_.rows)
      if (row.ends) set_ends(row);
    return std::move(out_);
  }

 private:
  void measure() {
    std::vector<std::string> label(field_.plants.size());
    bool planted = false;
    for (const auto& row : field_.rows)
      for (const int p : row.plants) {
        label[static_cast<std::size_t>(p)] = row.id;
        planted = true;
      }
    if (!planted) {  // no plant in any row: find_rows wants one
      out_.rows = before_.rows.subset({});
      out_.plants = before_.plants.subset({});
      out_.lines = before_.lines.subset({});
      out_.strays = field_.sources;
      for (Table* t : {&out_.rows, &out_.plants, &out_.lines}) t->set("row_id", ids_as({}, numbers_));
      return;
    }
    Table stems = field_.sources;
    std::vector<double> number;
    for (const auto& l : label) number.push_back(numbers_ ? number_from_text(l).value_or(no_number) : no_number);
    if (numbers_)
      stems.set("row_id", std::move(number));
    else
      stems.set("row_id", std::move(label));
    RowOptions options;
    options.fit = o_.fit;
    out_ = find_rows(stems, options, run_);
  }

  // Rows without plants were not measured; they stand at the end of the list.
  void add_bare_rows() {
    auto ids = ids_of(out_.rows);
    for (const auto& row : field_.rows)
      if (row.plants.empty()) ids.push_back(row.id);
    out_.rows = with_blank_rows(out_.rows, ids.size() - out_.rows.rows());
    out_.rows.set("row_id", ids_as(std::move(ids), numbers_));
  }

  template <class T>
  void put(std::size_t row, const char* name, T value) {
    const auto* column = out_.rows.find(name);
    if (column == nullptr) return;
    auto values = std::get<std::vector<T>>(*column);
    values[row] = std::move(value);
    out_.rows.set(name, std::move(values));
  }

  void set_ends(const EditableRow& row) {
    const auto ids = ids_of(out_.rows);
    const auto k = static_cast<std::size_t>(std::ranges::find(ids, row.id) - ids.begin());
    const Vector2d d = row.ends->to - row.ends->from;
    const double angle = row_angle(std::atan2(d.y(), d.x()));
    const Vector2d u(std::cos(angle), std::sin(angle));
    const bool turned = u.dot(d) < 0;
    const Vector2d a = turned ? row.ends->to : row.ends->from, b = turned ? row.ends->from : row.ends->to;
    put(k, "angle_deg", angle / rad_per_deg);
    put(k, "x0_m", a.x());
    put(k, "y0_m", a.y());
    put(k, "x1_m", b.x());
    put(k, "y1_m", b.y());
    put(k, "length_m", d.norm());
    put(k, "sagitta_m", 0.0);
    for (const char* name : {"angle_se_deg", "angle_lo_deg", "angle_hi_deg", "rms_m"}) put(k, name, no_number);
    put(k, "shape", std::string("straight"));
    set_line(row.id, a, b);
    set_distances(row.id, a, u);
  }

  // The guidance line is the straight one between the ends.
  void set_line(const std::string& id, const Vector2d& a, const Vector2d& b) {
    std::vector<std::size_t> others;
    auto ids = ids_of(out_.lines);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] != id) others.push_back(i);
    Table lines = with_blank_rows(out_.lines.subset(others), 2);
    ids = ids_of(lines);
    auto x = lines.numbers("x_m"), y = lines.numbers("y_m");
    auto number = lines.integers("number");
    const std::size_t n = x.size();
    ids[n - 2] = ids[n - 1] = id;
    number[n - 2] = 1;
    number[n - 1] = 2;
    x[n - 2] = a.x();
    y[n - 2] = a.y();
    x[n - 1] = b.x();
    y[n - 1] = b.y();
    lines.set("row_id", ids_as(std::move(ids), numbers_));
    lines.set("number", number);
    lines.set("x_m", x);
    lines.set("y_m", y);
    out_.lines = std::move(lines);
  }

  // Distances of the plants from the given line, left positive.
  void set_distances(const std::string& id, const Vector2d& a, const Vector2d& u) {
    const auto x = out_.plants.numbers("x_m"), y = out_.plants.numbers("y_m");
    auto across = out_.plants.numbers("across_m");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (out_.plants.text("row_id", i) == id && !std::isnan(across[i]))
        across[i] = u.x() * (y[i] - a.y()) - u.y() * (x[i] - a.x());
    out_.plants.set("across_m", across);
  }

  // Rows whose plants are what they were, their plants and their lines, from the tables as they were.
  void keep_the_rest() {
    std::map<std::string, std::string> name;  // of a kept row by its name before
    std::set<std::string> kept;
    for (const auto& row : field_.rows)
      if (!row.replanted) {
        name[row.found_id] = row.id;
        kept.insert(row.id);
      }
    const Table measured = out_.rows;
    for (const auto part : {&FoundRows::rows, &FoundRows::plants, &FoundRows::lines}) {
      const Table old = renamed(before_.*part, name), all = joined(old, out_.*part);
      std::map<std::string, std::vector<std::size_t>> of_old, of_new;
      for (std::size_t i = 0; i < all.rows(); ++i)
        (i < old.rows() ? of_old : of_new)[all.text("row_id", i)].push_back(i);
      std::vector<std::size_t> order;
      for (const auto& id : ids_of(measured)) {
        const auto& from = (kept.contains(id) ? of_old : of_new)[id];
        order.insert(order.end(), from.begin(), from.end());
      }
      out_.*part = all.subset(order);
    }
    for (const char* column : {"block", "row_in_block", "to_next_m"})
      if (measured.has(column)) out_.rows.set(column, *measured.find(column));
  }

  // The rows of a table whose name goes on, under the new one.
  Table renamed(const Table& table, const std::map<std::string, std::string>& name) const {
    std::vector<std::size_t> picked;
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < table.rows(); ++i)
      if (const auto it = name.find(table.text("row_id", i)); it != name.end()) {
        picked.push_back(i);
        ids.push_back(it->second);
      }
    Table out = table.subset(picked);
    out.set("row_id", ids_as(std::move(ids), numbers_));
    return out;
  }

  const EditableRows& field_;
  const FoundRows& before_;
  const RowEditOptions& o_;
  const Run& run_;
  bool numbers_ = true;
  FoundRows out_;
};

}  // namespace

FoundRows edited_tables(const EditableRows& field, const FoundRows& before, const RowEditOptions& options,
                        const Run& run) {
  return Composer(field, before, options, run).compose();
}

}  // namespace bole::rows
