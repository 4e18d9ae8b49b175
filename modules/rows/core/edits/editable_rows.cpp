#include "rows/core/edits/editable_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/angles.h"
#include "rows/core/rows/joined_tables.h"
#include "rows/core/rows/line_fit.h"

namespace bole::rows {
namespace {

using Action = RowEdit::Action;
using Eigen::Vector2d;

// Distance from a segment.
double from_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double s = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - s * d).norm();
}

double distance_from(const Points2& course, const Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < course.size(); ++i)
    nearest = std::min(nearest, from_segment(p, course[i - 1], course[i]));
  return nearest;
}

Vector2d chord_of(const EditableRow& row) { return row.course.back() - row.course.front(); }

void give_ends(EditableRow& row, const Vector2d& from, const Vector2d& to) {
  const Vector2d d = to - from;
  row.ends = RowEnds{from, to};
  row.course = {from, to};
  row.angle_rad = std::atan2(d.y(), d.x());
  row.edited = true;
}

class Change {
 public:
  Change(EditableRows& field, const RowEdit& edit, const RowEditOptions& options)
      : rows_(field.rows), plants_(field.plants), e_(edit), o_(options) {}

  EditOutcome apply() {
    if (e_.action == Action::add) {
      add();
      return std::move(outcome_);
    }
    const auto k = row_at(e_.at);
    outcome_.row_id = rows_[k].id;
    check_unchanged(rows_[k]);
    switch (e_.action) {
      case Action::move:
        give_ends(rows_[k], *e_.from, *e_.to);
        break;
      case Action::remove:
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      case Action::split:
        split(k);
        break;
      case Action::merge:
        merge(k);
        break;
      case Action::renumber:
        if (rows_[k].id != e_.row_id) refuse_taken(e_.row_id);
        rows_[k].id = e_.row_id;
        rows_[k].edited = true;
        break;
      default:  // a note changes nothing
        break;
    }
    return std::move(outcome_);
  }

 private:
  std::size_t row_at(const Vector2d& p) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < rows_.size(); ++i) near.emplace_back(distance_from(rows_[i].course, p), i);
    std::ranges::sort(near);
    if (near.empty() || !(near[0].first <= o_.match_distance))
      throw EditConflict{fmt::format("no row within {:g} m of ({:.2f}, {:.2f})", o_.match_distance, p.x(), p.y()) +
                         (near.empty() ? "" : fmt::format(", the nearest passes {:.2f} m away", near[0].first))};
    if (near.size() > 1 && near[1].first <= o_.match_distance && near[1].first < 2 * near[0].first)
      throw EditConflict{fmt::format("rows {} and {} both pass near ({:.2f}, {:.2f})", rows_[near[0].second].id,
                                     rows_[near[1].second].id, p.x(), p.y())};
    return near[0].second;
  }

  std::string free_id() const {
    long largest = 0;
    for (const auto& row : rows_)
      if (is_whole_number(row.id)) largest = std::max(largest, std::stol(row.id));
    return std::to_string(largest + 1);
  }

  void refuse_taken(const std::string& id) const {
    if (std::ranges::find(rows_, id, &EditableRow::id) != rows_.end())
      throw EditConflict{"there is a row " + id + " already"};
  }

  void check_unchanged(const EditableRow& row) {
    if (!e_.was_angle_deg ||
        row_angle_difference(row.angle_rad, *e_.was_angle_deg * rad_per_deg) <= o_.angle_tolerance_deg * rad_per_deg)
      return;
    outcome_.note = fmt::format("the row ran at {:.2f} deg and now runs at {:.2f} deg", *e_.was_angle_deg,
                                row_angle(row.angle_rad) / rad_per_deg);
  }

  // A drawn row takes the plants in no row that stand near it.
  void add() {
    EditableRow row;
    row.id = e_.row_id.empty() ? free_id() : e_.row_id;
    refuse_taken(row.id);
    std::vector<bool> taken(plants_.size(), false);
    for (const auto& other : rows_)
      for (const int p : other.plants) taken[static_cast<std::size_t>(p)] = true;
    for (std::size_t p = 0; p < plants_.size(); ++p)
      if (!taken[p] && from_segment(plants_[p], *e_.from, *e_.to) <= o_.reach)
        row.plants.push_back(static_cast<int>(p));
    give_ends(row, *e_.from, *e_.to);
    row.replanted = true;
    outcome_.row_id = row.id;
    rows_.push_back(std::move(row));
  }

  void split(std::size_t k) {
    auto& row = rows_[k];
    const Vector2d d = chord_of(row).normalized();
    EditableRow before, after;
    for (const int p : row.plants)
      ((plants_[static_cast<std::size_t>(p)] - e_.at).dot(d) < 0 ? before : after).plants.push_back(p);
    if (!row.plants.empty() && (before.plants.empty() || after.plants.empty()))
      throw EditConflict{"all plants of row " + row.id + " stand on one side of the cut"};
    for (const auto& v : row.course) ((v - e_.at).dot(d) < 0 ? before : after).course.push_back(v);
    if (before.course.empty() || after.course.empty())
      throw EditConflict{"the cut lies beyond the ends of row " + row.id};
    before.course.push_back(e_.at);
    after.course.insert(after.course.begin(), e_.at);
    before.angle_rad = after.angle_rad = row.angle_rad;
    if (row.ends) {  // both parts keep to the line that was given
      const Vector2d foot = row.course.front() + (e_.at - row.course.front()).dot(d) * d;
      give_ends(before, row.course.front(), foot);
      give_ends(after, foot, row.course.back());
    }
    before.id = row.id;
    after.id = free_id();
    before.edited = after.edited = before.replanted = after.replanted = true;
    row = std::move(before);
    rows_.push_back(std::move(after));
  }

  void merge(std::size_t k) {
    std::vector<std::size_t> others;
    for (const auto& place : e_.with) {
      const auto j = row_at(place);
      if (j == k || std::ranges::find(others, j) != others.end())
        throw EditConflict{"row " + rows_[j].id + " is named twice"};
      others.push_back(j);
    }
    auto& row = rows_[k];
    for (const auto j : others) {
      row.plants.insert(row.plants.end(), rows_[j].plants.begin(), rows_[j].plants.end());
      row.course.insert(row.course.end(), rows_[j].course.begin(), rows_[j].course.end());
    }
    const Vector2d d = chord_of(row);
    std::ranges::stable_sort(row.course, [&](const auto& a, const auto& b) { return a.dot(d) < b.dot(d); });
    row.ends.reset();
    row.edited = row.replanted = true;
    // Drawn rows without plants have nothing to be measured by.
    if (row.plants.size() < 2) give_ends(row, Vector2d(row.course.front()), Vector2d(row.course.back()));
    std::ranges::sort(others, std::greater<>());
    for (const auto j : others) rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(j));
  }

  std::vector<EditableRow>& rows_;
  const Points2& plants_;
  const RowEdit& e_;
  const RowEditOptions& o_;
  EditOutcome outcome_;
};

}  // namespace

bool is_whole_number(const std::string& id) {
  if (id.empty() || id.size() > 17 || (id.size() > 1 && id[0] == '0')) return false;
  return std::ranges::all_of(id, [](char c) { return c >= '0' && c <= '9'; });
}

EditableRows editable_rows(const FoundRows& found) {
  EditableRows out;
  const auto& t = found.rows;
  const auto x0 = t.numbers("x0_m"), y0 = t.numbers("y0_m"), x1 = t.numbers("x1_m"), y1 = t.numbers("y1_m");
  const auto angle = t.numbers("angle_deg");
  std::map<std::string, std::size_t> by_id;
  for (std::size_t i = 0; i < t.rows(); ++i) {
    by_id[t.text("row_id", i)] = i;
    out.rows.push_back(
        {t.text("row_id", i), {{x0[i], y0[i]}, {x1[i], y1[i]}}, angle[i] * rad_per_deg, {}, {}, t.text("row_id", i)});
  }
  std::map<std::string, Points2> courses;
  const auto lx = found.lines.numbers("x_m"), ly = found.lines.numbers("y_m");
  for (std::size_t i = 0; i < lx.size(); ++i) courses[found.lines.text("row_id", i)].emplace_back(lx[i], ly[i]);
  for (auto& [id, course] : courses)
    if (const auto it = by_id.find(id); it != by_id.end() && course.size() > 1) out.rows[it->second].course = course;

  std::vector<std::size_t> present;
  const auto& state = found.plants.texts("state");
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (state[i] != "present") continue;
    if (const auto it = by_id.find(found.plants.text("row_id", i)); it != by_id.end())
      out.rows[it->second].plants.push_back(static_cast<int>(present.size()));
    present.push_back(i);
  }
  out.sources = joined(found.plants.subset(present), found.strays);
  for (const char* name : {"row_id", "number", "state", "across_m"})
    if (out.sources.has(name)) out.sources.remove(name);
  const auto x = out.sources.numbers("x_m"), y = out.sources.numbers("y_m");
  for (std::size_t i = 0; i < x.size(); ++i) out.plants.emplace_back(x[i], y[i]);
  return out;
}

EditOutcome apply_row_edit(EditableRows& rows, const RowEdit& edit, const RowEditOptions& options) {
  return Change(rows, edit, options).apply();
}

}  // namespace bole::rows
