#include "evaluation/core/evaluate_rows.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "evaluation/core/assignment.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {
namespace {

constexpr double parallel_deg = 15, right_share = 0.9;
using Eigen::Vector2d;

double angle_difference_deg(double a, double b) { return std::abs(std::remainder(a - b, 180.0)); }

double share(double part, double whole) { return whole > 0 ? 100 * part / whole : no_number; }

// y = a x + b, or x = a y + b where the plants reach further north than east.
double fitted_angle_deg(const std::vector<Vector2d>& points) {
  Vector2d mean = Vector2d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0, xy = 0, yy = 0;
  for (const auto& p : points) {
    const Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  if (points.size() < 2 || xx + yy <= 0) return no_number;
  return (xx >= yy ? std::atan2(xy, xx) : std::atan2(yy, xy)) / rad_per_deg;
}

class MatchTable {
 public:
  void add(const std::string& kind, const std::string& id, const std::string& ref, double angle, double ref_angle,
           double shared) {
    kind_.push_back(kind);
    id_.push_back(id);
    ref_.push_back(ref);
    angle_.push_back(angle);
    ref_angle_.push_back(ref_angle);
    const double error =
        std::isfinite(angle) && std::isfinite(ref_angle) ? std::remainder(angle - ref_angle, 180.0) : no_number;
    error_.push_back(error);
    shared_.push_back(shared);
  }
  // Angle errors of the matched rows.
  void measure(SummaryRows& summary) const {
    double sum = 0, least = no_number, most = no_number, square = 0, bias = 0;
    int n = 0;
    for (const double e : error_)
      if (std::isfinite(e)) {
        sum += std::abs(e);
        square += e * e;
        bias += e;
        ++n;
        least = std::isfinite(least) ? std::min(least, std::abs(e)) : std::abs(e);
        most = std::isfinite(most) ? std::max(most, std::abs(e)) : std::abs(e);
      }
    summary.add("angle_error_mean", n > 0 ? sum / n : no_number, "deg");
    summary.add("angle_error_min", least, "deg");
    summary.add("angle_error_max", most, "deg");
    summary.add("angle_error_rmse", n > 0 ? std::sqrt(square / n) : no_number, "deg");
    summary.add("angle_bias", n > 0 ? bias / n : no_number, "deg");
  }
  Table table() const {
    Table t;
    t.set("kind", kind_);
    t.set("row_id", id_);
    t.set("ref_id", ref_);
    t.set("angle_deg", angle_);
    t.set("ref_angle_deg", ref_angle_);
    t.set("angle_error_deg", error_);
    t.set("shared", shared_);
    return t;
  }

 private:
  std::vector<std::string> kind_, id_, ref_;
  std::vector<double> angle_, ref_angle_, error_, shared_;
};

// The two ends of each line, one after the other.
class LineTable {
 public:
  void add(const std::string& id, const Vector2d& a, const Vector2d& b) {
    for (const auto& p : {a, b}) {
      id_.push_back(id);
      x_.push_back(p.x());
      y_.push_back(p.y());
    }
  }
  // The line of least squares through plants, as far as they reach.
  void add(const std::string& id, const std::vector<Vector2d>& plants) {
    const double angle = fitted_angle_deg(plants) * rad_per_deg;
    if (!std::isfinite(angle)) return;
    const Vector2d along(std::cos(angle), std::sin(angle));
    Vector2d mean = Vector2d::Zero();
    for (const auto& p : plants) mean += p / static_cast<double>(plants.size());
    double first = 0, last = 0;
    for (const auto& p : plants) {
      first = std::min(first, along.dot(p - mean));
      last = std::max(last, along.dot(p - mean));
    }
    add(id, mean + first * along, mean + last * along);
  }
  Table table() const {
    Table t;
    t.set("row_id", id_);
    t.set("x_m", x_);
    t.set("y_m", y_);
    return t;
  }

 private:
  std::vector<std::string> id_;
  std::vector<double> x_, y_;
};

struct Plants {
  std::vector<Vector2d> at, missing;
  std::vector<std::string> row;
  std::map<std::string, std::vector<Vector2d>> rows;

  explicit Plants(const Table& t) {
    const auto x = t.numbers("x_m"), y = t.numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
      const Vector2d p(x[i], y[i]);
      if (t.has("state") && t.text("state", i) == "missing") {
        missing.push_back(p);
        continue;
      }
      at.push_back(p);
      row.push_back(t.text("row_id", i));
      if (!row.back().empty()) rows[row.back()].push_back(p);
    }
  }
};

// Plants of both lists that stand nearest to one another, one to one.
std::vector<Pairing> pairs_within(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b, double distance) {
  // A grid keeps large fields quick.
  const double cell = std::max(distance, 1e-6);
  std::map<std::pair<long, long>, std::vector<std::size_t>> grid;
  const auto key = [&](const Vector2d& p) {
    return std::pair(std::lround(std::floor(p.x() / cell)), std::lround(std::floor(p.y() / cell)));
  };
  for (std::size_t j = 0; j < b.size(); ++j) grid[key(b[j])].push_back(j);
  std::vector<Pairing> offered;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto [cx, cy] = key(a[i]);
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy)
        if (const auto it = grid.find({cx + dx, cy + dy}); it != grid.end())
          for (const auto j : it->second)
            if (const double d = (a[i] - b[j]).norm(); d <= distance) offered.push_back({i, j, d});
  }
  return assign_pairs(offered);
}

RowEvaluation by_plants(const Table& estimate, const Table& reference, const EvaluationOptions& o) {
  const Plants found(estimate), truth(reference);
  std::map<std::string, std::map<std::string, int>> votes;  // found row, reference row, plants
  std::map<std::string, int> matched_in;
  for (const auto& pair : pairs_within(found.at, truth.at, o.match_distance_m)) {
    const auto& row = found.row[pair.left];
    const auto& ref = truth.row[pair.right];
    if (!row.empty() && !ref.empty()) ++votes[row][ref], ++matched_in[row];
  }
  MatchTable table;
  LineTable lines;
  SummaryRows summary(o.published_plot);
  std::size_t right = 0, assigned = 0, standing = 0;
  std::map<std::string, bool> used;
  for (const auto& [id, plants] : found.rows) {
    const auto most = std::ranges::max_element(votes[id], {}, [](const auto& v) { return v.second; });
    const bool has = most != votes[id].end() && !used[most->first];
    const double size = static_cast<double>(plants.size());
    const double of = has ? static_cast<double>(truth.rows.at(most->first).size()) : 1;
    if (has && most->second >= right_share * size && most->second >= right_share * of) {
      used[most->first] = true;
      ++right;
      assigned += static_cast<std::size_t>(most->second);
      table.add("matched", id, most->first, fitted_angle_deg(plants), fitted_angle_deg(truth.rows.at(most->first)),
                most->second / of);
    } else {
      table.add("false", id, "", fitted_angle_deg(plants), no_number, 0);
    }
  }
  for (const auto& [id, plants] : truth.rows) {
    standing += plants.size();
    lines.add(id, plants);
    if (!used[id]) table.add("missed", "", id, no_number, fitted_angle_deg(plants), 0);
  }
  summary.add("rows", static_cast<double>(truth.rows.size()), "");
  summary.add("rows_found", static_cast<double>(found.rows.size()), "");
  summary.add("row_recall", share(static_cast<double>(right), static_cast<double>(truth.rows.size())), "%");
  summary.add("row_precision", share(static_cast<double>(right), static_cast<double>(found.rows.size())), "%");
  summary.add("plants_in_their_row", share(static_cast<double>(assigned), static_cast<double>(standing)), "%");
  const auto gaps = pairs_within(found.missing, truth.missing, o.match_distance_m).size();
  summary.add("missing_found", share(static_cast<double>(gaps), static_cast<double>(truth.missing.size())), "%");
  summary.add("missing_listed_right", share(static_cast<double>(gaps), static_cast<double>(found.missing.size())), "%");
  table.measure(summary);
  return {summary.table(), table.table(), lines.table()};
}

struct Line {
  std::string id;
  Vector2d a, b;
  double angle_deg;
};

std::vector<Line> lines_of(const Table& t, bool stated_angles) {
  const auto x0 = t.numbers("x0_m"), y0 = t.numbers("y0_m"), x1 = t.numbers("x1_m"), y1 = t.numbers("y1_m");
  const auto stated = stated_angles ? t.numbers("angle_deg") : std::vector<double>();
  std::vector<Line> lines;
  for (std::size_t i = 0; i < x0.size(); ++i) {
    const Vector2d a(x0[i], y0[i]), b(x1[i], y1[i]);
    if (!a.allFinite() || !b.allFinite() || !((b - a).norm() > 0)) continue;
    const double own = std::atan2(b.y() - a.y(), b.x() - a.x()) / rad_per_deg;
    lines.push_back({t.text("row_id", i), a, b, stated_angles && std::isfinite(stated[i]) ? stated[i] : own});
  }
  return lines;
}

RowEvaluation by_lines(const Table& estimate, const Table& reference, const EvaluationOptions& o) {
  const bool stated = estimate.has("angle_deg") && reference.has("angle_deg");
  const auto found = lines_of(estimate, stated), truth = lines_of(reference, stated);
  std::vector<Pairing> offered;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < truth.size(); ++j) {
      if (angle_difference_deg(found[i].angle_deg, truth[j].angle_deg) > parallel_deg) continue;
      const Vector2d u = (found[i].b - found[i].a).normalized(), d = 0.5 * (truth[j].a + truth[j].b) - found[i].a;
      const double across = std::abs(u.x() * d.y() - u.y() * d.x()), along = d.dot(u);
      if (across <= o.match_distance_m && along >= 0 && along <= (found[i].b - found[i].a).norm())
        offered.push_back({i, j, across});
    }
  MatchTable table;
  SummaryRows summary(o.published_plot);
  std::vector<bool> left(found.size(), false), right(truth.size(), false);
  const auto pairs = assign_pairs(offered);
  for (const auto& p : pairs) {
    left[p.left] = right[p.right] = true;
    table.add("matched", found[p.left].id, truth[p.right].id, found[p.left].angle_deg, truth[p.right].angle_deg, 1);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!left[i]) table.add("false", found[i].id, "", found[i].angle_deg, no_number, 0);
  for (std::size_t j = 0; j < truth.size(); ++j)
    if (!right[j]) table.add("missed", "", truth[j].id, no_number, truth[j].angle_deg, 0);
  LineTable lines;
  for (const auto& line : truth) lines.add(line.id, line.a, line.b);
  const auto n = static_cast<double>(pairs.size());
  summary.add("rows", static_cast<double>(truth.size()), "");
  summary.add("rows_found", static_cast<double>(found.size()), "");
  summary.add("row_recall", share(n, static_cast<double>(truth.size())), "%");
  summary.add("row_precision", share(n, static_cast<double>(found.size())), "%");
  table.measure(summary);
  return {summary.table(), table.table(), lines.table()};
}

}  // namespace

RowEvaluation evaluate_rows(const Table& estimate, const Table& reference, const EvaluationOptions& options) {
  const auto is_lines = [](const Table& t) {
    return t.has("row_id") && t.has("x0_m") && t.has("y0_m") && t.has("x1_m") && t.has("y1_m");
  };
  const auto is_plants = [](const Table& t) { return t.has("row_id") && t.has("x_m") && t.has("y_m"); };
  if (is_lines(estimate) && is_lines(reference)) return by_lines(estimate, reference, options);
  if (is_plants(estimate) && is_plants(reference)) return by_plants(estimate, reference, options);
  throw bad_input("the two tables are not of one kind",
                  "both rows (row_id, x0_m, y0_m, x1_m, y1_m) or both plants (row_id, x_m, y_m)",
                  "Compare rows.csv with rows.csv, or plants.csv with plants.csv");
}

}  // namespace bole::evaluation
