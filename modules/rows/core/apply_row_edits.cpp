#include "rows/core/apply_row_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/error.h"
#include "rows/core/line_fit.h"

namespace bole::rows {
namespace {

constexpr double deg = std::numbers::pi / 180, nan = std::numeric_limits<double>::quiet_NaN();
using Action = RowEdit::Action;
using Eigen::Vector2d;

struct Conflict {
  std::string why;
};

struct Ends {
  Vector2d from, to;
};

struct EditableRow {
  std::string id;
  Points2 course;            // vertices of its guidance line
  std::vector<int> plants;   // indices into the plants of the editor
  std::optional<Ends> ends;  // given by a person
  bool edited = false;
};

struct EditablePlant {
  Vector2d at;
  std::string tree_id;
};

// Distance from a segment, and the share of the way along it.
std::pair<double, double> from_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double s = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return {(p - a - s * d).norm(), s};
}

double distance_from(const Points2& course, const Vector2d& p) {
  if (course.size() == 1) return (p - course[0]).norm();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < course.size(); ++i)
    least = std::min(least, from_segment(p, course[i - 1], course[i]).first);
  return least;
}

bool whole_number(const std::string& text) {
  return !text.empty() && text.size() < 18 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

class RowEditor {
 public:
  RowEditor(const FoundRows& found, const RowEditOptions& options, const Run& run)
      : found_(found), o_(options), run_(run) {
    take_rows();
    take_plants(found.plants, true);
    take_plants(found.strays, false);
  }

  EditedRows run(const std::vector<RowEdit>& edits) {
    Table log = empty_log();
    std::int64_t conflicts = 0;
    bool changed = false;
    Report report;
    for (std::size_t i = 0; i < edits.size(); ++i) {
      run_.check_cancel();
      std::string outcome = "applied", message;
      row_id_.clear(), said_.clear();
      try {
        apply(edits[i]);
        changed |= edits[i].action != Action::note, message = said_;
        if (!said_.empty()) report.warn(fmt::format("edit {} ({}): {}", i + 1, action_name(edits[i].action), said_));
      } catch (const Conflict& c) {
        outcome = "conflict", message = c.why, ++conflicts;
        report.warn(fmt::format("edit {} ({}) is not applied: {}", i + 1, action_name(edits[i].action), c.why));
      }
      add_line(log, i + 1, edits[i], outcome, message);
    }
    EditedRows out;
    out.found = changed ? measured() : found_;
    out.log = std::move(log);
    set_states(out.found.rows, changed);
    auto& r = out.found.report;
    r.warnings.insert(r.warnings.begin(), report.warnings.begin(), report.warnings.end());
    if (!report.warnings.empty()) r.status = Status::warning;
    r.counts["edits"] = std::ssize(edits), r.counts["conflicts"] = conflicts;
    r.counts["applied"] = std::ssize(edits) - conflicts,
    r.counts["rows"] = static_cast<std::int64_t>(out.found.rows.rows());
    r.message = edits.empty() ? "no edits"
                              : fmt::format("{} of {} edits applied",
                                            edits.size() - static_cast<std::size_t>(conflicts), edits.size());
    return out;
  }

 private:
  void take_rows() {
    const auto& t = found_.rows;
    const auto x0 = t.numbers("x0_m"), y0 = t.numbers("y0_m"), x1 = t.numbers("x1_m"), y1 = t.numbers("y1_m");
    for (std::size_t i = 0; i < t.rows(); ++i) {
      EditableRow row;
      row.id = t.text("row_id", i);
      row.course = {{x0[i], y0[i]}, {x1[i], y1[i]}};
      by_id_[row.id] = rows_.size();
      rows_.push_back(std::move(row));
    }
    const auto lx = found_.lines.numbers("x_m"), ly = found_.lines.numbers("y_m");
    std::map<std::string, Points2> courses;
    for (std::size_t i = 0; i < lx.size(); ++i) courses[found_.lines.text("row_id", i)].emplace_back(lx[i], ly[i]);
    for (auto& [id, course] : courses)
      if (const auto it = by_id_.find(id); it != by_id_.end() && course.size() > 1) rows_[it->second].course = course;
  }

  void take_plants(const Table& t, bool in_rows) {
    if (t.rows() == 0) return;
    const auto x = t.numbers("x_m"), y = t.numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (in_rows && t.text("state", i) != "present") continue;
      if (in_rows)
        if (const auto it = by_id_.find(t.text("row_id", i)); it != by_id_.end())
          rows_[it->second].plants.push_back(static_cast<int>(plants_.size()));
      plants_.push_back({{x[i], y[i]}, t.has("tree_id") ? t.text("tree_id", i) : std::string()});
    }
  }

  static Table empty_log() {
    Table t;
    t.set("edit", std::vector<std::int64_t>{});
    for (const char* name : {"action", "row_id"}) t.set(name, std::vector<std::string>{});
    t.set("x_m", std::vector<double>{}), t.set("y_m", std::vector<double>{});
    for (const char* name : {"outcome", "message", "author", "time", "reason"}) t.set(name, std::vector<std::string>{});
    return t;
  }

  void add_line(Table& log, std::size_t number, const RowEdit& e, const std::string& outcome,
                const std::string& message) const {
    Table grown;
    const auto push = [&]<class T>(const char* name, std::vector<T> values, T value) {
      values.push_back(std::move(value));
      grown.set(name, std::move(values));
    };
    const Vector2d at = e.action == Action::add ? *e.from : e.at;
    push("edit", log.integers("edit"), static_cast<std::int64_t>(number));
    push("action", log.texts("action"), std::string(action_name(e.action)));
    push("row_id", log.texts("row_id"), row_id_);
    push("x_m", log.numbers("x_m"), at.x()), push("y_m", log.numbers("y_m"), at.y());
    push("outcome", log.texts("outcome"), outcome), push("message", log.texts("message"), message);
    push("author", log.texts("author"), e.author), push("time", log.texts("time"), e.time);
    push("reason", log.texts("reason"), e.reason);
    log = std::move(grown);
  }

  std::size_t row_at(const Vector2d& p) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < rows_.size(); ++i) near.emplace_back(distance_from(rows_[i].course, p), i);
    std::ranges::sort(near);
    if (near.empty() || !(near[0].first <= o_.match_distance))
      throw Conflict{fmt::format("no row within {:g} m of ({:.2f}, {:.2f})", o_.match_distance, p.x(), p.y()) +
                     (near.empty() ? "" : fmt::format(", the nearest passes {:.2f} m away", near[0].first))};
    if (near.size() > 1 && near[1].first <= o_.match_distance && near[1].first < 2 * near[0].first)
      throw Conflict{fmt::format("rows {} and {} both pass near ({:.2f}, {:.2f})", rows_[near[0].second].id,
                                 rows_[near[1].second].id, p.x(), p.y())};
    return near[0].second;
  }

  std::string free_id() const {
    long most = 0;
    for (const auto& row : rows_)
      if (whole_number(row.id)) most = std::max(most, std::stol(row.id));
    return std::to_string(most + 1);
  }

  void refuse_taken(const std::string& id) const {
    if (std::ranges::any_of(rows_, [&](const auto& r) { return r.id == id; }))
      throw Conflict{"there is a row " + id + " already"};
  }

  void check_unchanged(const RowEdit& e, const EditableRow& row) {
    if (!e.was_angle_deg) return;
    const Vector2d d = row.course.back() - row.course.front();
    const double now = std::atan2(d.y(), d.x());
    if (row_angle_difference(now, *e.was_angle_deg * deg) > o_.doubt_deg * deg)
      said_ =
          fmt::format("the row ran at {:.2f} deg and now runs at {:.2f} deg", *e.was_angle_deg, row_angle(now) / deg);
  }

  void apply(const RowEdit& e) {
    if (e.action == Action::add) return add(e);
    const auto k = row_at(e.at);
    row_id_ = rows_[k].id;
    check_unchanged(e, rows_[k]);
    switch (e.action) {
      case Action::move:
        rows_[k].ends = Ends{*e.from, *e.to}, rows_[k].course = {*e.from, *e.to}, rows_[k].edited = true;
        return;
      case Action::remove:
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(k));
        return;
      case Action::split:
        return split(k, e.at);
      case Action::merge:
        return merge(k, e);
      case Action::renumber:
        if (rows_[k].id != e.row_id) refuse_taken(e.row_id);
        rows_[k].id = e.row_id, rows_[k].edited = true;
        return;
      default:
        return;
    }
  }

  // A drawn row takes the plants in no row that stand near it.
  void add(const RowEdit& e) {
    EditableRow row;
    row.id = e.row_id.empty() ? free_id() : e.row_id;
    refuse_taken(row.id);
    std::vector<bool> taken(plants_.size(), false);
    for (const auto& other : rows_)
      for (const int p : other.plants) taken[static_cast<std::size_t>(p)] = true;
    for (std::size_t p = 0; p < plants_.size(); ++p)
      if (!taken[p] && from_segment(plants_[p].at, *e.from, *e.to).first <= o_.reach)
        row.plants.push_back(static_cast<int>(p));
    row.ends = Ends{*e.from, *e.to}, row.course = {*e.from, *e.to}, row.edited = true;
    row_id_ = row.id;
    rows_.push_back(std::move(row));
  }

  void split(std::size_t k, const Vector2d& at) {
    auto& row = rows_[k];
    const Vector2d d = row.course.back() - row.course.front();
    EditableRow before, after;
    for (const int p : row.plants)
      ((plants_[static_cast<std::size_t>(p)].at - at).dot(d) < 0 ? before : after).plants.push_back(p);
    if (before.plants.empty() || after.plants.empty())
      throw Conflict{"all plants of row " + row.id + " stand on one side of the cut"};
    for (const auto& v : row.course) ((v - at).dot(d) < 0 ? before : after).course.push_back(v);
    before.course.push_back(at), after.course.insert(after.course.begin(), at);
    before.id = row.id, after.id = free_id();
    before.edited = after.edited = true;
    row = std::move(before);
    rows_.push_back(std::move(after));
  }

  void merge(std::size_t k, const RowEdit& e) {
    std::vector<std::size_t> others;
    for (const auto& place : e.with) {
      const auto j = row_at(place);
      if (j == k || std::ranges::find(others, j) != others.end())
        throw Conflict{"row " + rows_[j].id + " is named twice"};
      others.push_back(j);
    }
    auto& row = rows_[k];
    for (const auto j : others) {
      row.plants.insert(row.plants.end(), rows_[j].plants.begin(), rows_[j].plants.end());
      row.course.insert(row.course.end(), rows_[j].course.begin(), rows_[j].course.end());
    }
    const Vector2d d = row.course.back() - row.course.front();
    std::stable_sort(row.course.begin(), row.course.end(),
                     [&](const auto& a, const auto& b) { return a.dot(d) < b.dot(d); });
    row.ends.reset(), row.edited = true;
    std::ranges::sort(others, std::greater<>());
    for (const auto j : others) rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(j));
  }

  // The rows measured anew from their plants; given ends take precedence.
  FoundRows measured() const {
    std::vector<std::string> label(plants_.size()), tree;
    std::vector<double> x, y;
    for (const auto& p : plants_) x.push_back(p.at.x()), y.push_back(p.at.y()), tree.push_back(p.tree_id);
    bool numbers = true, planted = false;
    for (const auto& row : rows_) {
      numbers &= whole_number(row.id), planted |= !row.plants.empty();
      for (const int p : row.plants) label[static_cast<std::size_t>(p)] = row.id;
    }
    Table stems;
    stems.set("x_m", x), stems.set("y_m", y);
    if (numbers) {
      std::vector<double> ids;
      for (const auto& l : label) ids.push_back(l.empty() ? nan : std::stod(l));
      stems.set("row_id", ids);
    } else {
      stems.set("row_id", label);
    }
    if (std::ranges::any_of(tree, [](const auto& t) { return !t.empty(); })) stems.set("tree_id", tree);
    stems.facts = found_.rows.facts;
    FoundRows out;
    if (planted) {
      RowOptions options;
      options.fit = o_.fit;
      out = find_rows(stems, options, run_);
    } else {
      out.rows = found_.rows.subset({}), out.plants = found_.plants.subset({}), out.lines = found_.lines.subset({});
      out.strays = stems;
      out.strays.remove("row_id");
    }
    for (const auto& row : rows_)
      if (row.ends) give_ends(out, row, numbers);
    return out;
  }

  // Row `row` of the tables gets the ends that a person gave; a row without plants is added.
  static void give_ends(FoundRows& out, const EditableRow& row, bool numbers) {
    std::size_t k = 0;
    while (k < out.rows.rows() && out.rows.text("row_id", k) != row.id) ++k;
    if (k == out.rows.rows()) out.rows = with_blank(out.rows, row.id, numbers);
    const Vector2d d = row.ends->to - row.ends->from;
    const double angle = row_angle(std::atan2(d.y(), d.x()));
    const bool turned = Vector2d(std::cos(angle), std::sin(angle)).dot(d) < 0;
    const Vector2d a = turned ? row.ends->to : row.ends->from, b = turned ? row.ends->from : row.ends->to;
    const auto put = [&](const char* name, double value) {
      if (!out.rows.has(name)) return;
      auto values = out.rows.numbers(name);
      values[k] = value;
      out.rows.set(name, values);
    };
    put("angle_deg", angle / deg), put("x0_m", a.x()), put("y0_m", a.y()), put("x1_m", b.x()), put("y1_m", b.y());
    put("length_m", d.norm()), put("sagitta_m", 0);
    for (const char* name : {"angle_se_deg", "angle_lo_deg", "angle_hi_deg", "rms_m"}) put(name, nan);
    auto shape = out.rows.texts("shape");
    shape[k] = "straight", out.rows.set("shape", shape);
    // Its guidance line is the straight one between the ends.
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < out.lines.rows(); ++i)
      if (out.lines.text("row_id", i) != row.id) others.push_back(i);
    Table lines = out.lines.subset(others);
    for (int end = 0; end < 2; ++end) lines = with_blank(lines, row.id, numbers);
    auto lx = lines.numbers("x_m"), ly = lines.numbers("y_m");
    const std::size_t n = lx.size();
    lx[n - 2] = a.x(), ly[n - 2] = a.y(), lx[n - 1] = b.x(), ly[n - 1] = b.y();
    lines.set("x_m", lx), lines.set("y_m", ly);
    auto number = lines.integers("number");
    number[n - 2] = 1, number[n - 1] = 2, lines.set("number", number);
    out.lines = std::move(lines);
  }

  // The table with one more row of NaN, 0 and "", and its row_id.
  static Table with_blank(const Table& t, const std::string& id, bool numbers) {
    Table grown;
    grown.facts = t.facts;
    for (const auto& column : t.columns())
      std::visit(
          [&]<class T>(std::vector<T> values) {
            if constexpr (std::is_same_v<T, double>)
              values.push_back(nan);
            else
              values.push_back(T());
            if (column.name == "row_id") {
              if constexpr (std::is_same_v<T, std::string>) values.back() = id;
              if constexpr (std::is_same_v<T, std::int64_t>)
                if (numbers) values.back() = std::stoll(id);
              if constexpr (std::is_same_v<T, double>)
                if (numbers) values.back() = std::stod(id);
            }
            grown.set(column.name, std::move(values));
          },
          column.values);
    return grown;
  }

  void set_states(Table& rows, bool changed) const {
    std::vector<std::string> state(rows.rows(), "auto");
    if (changed)
      for (std::size_t i = 0; i < rows.rows(); ++i)
        for (const auto& row : rows_)
          if (row.id == rows.text("row_id", i) && row.edited) state[i] = "edited";
    rows.set("state", state);
  }

  const FoundRows& found_;
  const RowEditOptions& o_;
  const Run& run_;
  std::vector<EditableRow> rows_;
  std::vector<EditablePlant> plants_;
  std::map<std::string, std::size_t> by_id_;
  std::string row_id_, said_;
};

}  // namespace

const OptionTable& option_table(const RowEditOptions*) {
  using S = RowEditOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"edits",
                             &S::edits,
                             TextKind::json,
                             {},
                             Tier::basic,
                             "The edits as a JSON list, applied after those of the file."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::basic, "A file with a JSON list of edits."},
      Option<S, double>{"match_distance",
                        &S::match_distance,
                        Unit::metre,
                        {0.01, 100},
                        Tier::advanced,
                        "An edit belongs to the nearest row when that passes no further away than this."},
      Option<S, double>{"reach",
                        &S::reach,
                        Unit::metre,
                        {0, 100},
                        Tier::advanced,
                        "A drawn row takes the plants in no row that stand no further from it."},
      Option<S, double>{"doubt_deg",
                        &S::doubt_deg,
                        Unit::degree,
                        {0, 90},
                        Tier::advanced,
                        "A direction that differs by more than this from was_angle_deg of an edit is told."},
      Option<S, std::string>{"fit",
                             &S::fit,
                             TextKind::choice,
                             {"least_squares", "orthogonal"},
                             Tier::advanced,
                             "How changed rows are fitted; see rows.from_stems."},
  });
  return table;
}

EditedRows apply_row_edits(const FoundRows& found, const std::vector<RowEdit>& edits, const RowEditOptions& options,
                           const Run& run) {
  return RowEditor(found, options, run).run(edits);
}

}  // namespace bole::rows
