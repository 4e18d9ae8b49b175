#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "survey/core/check/judge_map.h"

namespace bole::survey {
namespace {

std::string id_of(const Table& stems, std::size_t row) {
  return stems.has("tree_id") ? stems.text("tree_id", row, 0) : std::to_string(row + 1);
}

// "12, 15, 31 and 4 more".
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > most ? text + fmt::format(" and {} more", names.size() - most) : text;
}

bool in_region(const CheckedMap& map, const StemMeasure& s) { return map.area.contains(s.at); }

void judge_pairs(const CheckedMap& map, CheckFindings& out) {
  constexpr double touching = 0.9;  // of the sum of two radii: twins that touch are no error
  std::vector<std::string> pairs;
  std::optional<Eigen::Vector2d> place;
  for (std::size_t i = 0; i < map.stems.size(); ++i)
    for (std::size_t j = i + 1; j < map.stems.size(); ++j) {
      const auto &a = map.stems[i], &b = map.stems[j];
      if (!in_region(map, a) && !in_region(map, b)) continue;
      if (!((a.at - b.at).norm() < touching * (a.dbh_cm + b.dbh_cm) / 200)) continue;
      pairs.push_back(id_of(*map.in.stems, a.row) + " and " + id_of(*map.in.stems, b.row));
      if (!place) place = a.at;
    }
  map.report.counts["pairs_too_close"] = std::ssize(pairs);
  if (!pairs.empty())
    out.add(Severity::look, "stems_overlap",
            fmt::format("{} pairs of stems stand in each other ({}): one tree twice, or a fork below breast height",
                        pairs.size(), listed(pairs)),
            place);
}

bool ground_near(const CheckGrid& grid, const Eigen::Vector2d& at, std::uint32_t needed) {
  constexpr double near_m = 1;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      if (const auto c = grid.index(at + near_m / 4 * Eigen::Vector2d(i, j)))
        if (grid.cells[*c].ground_points >= needed) return true;
  return false;
}

void judge_ground(const CheckedMap& map, CheckFindings& out) {
  if (!map.grid.has_heights) return;
  std::vector<std::string> without;
  std::optional<Eigen::Vector2d> place;
  std::size_t inside = 0;
  for (const auto& s : map.stems) {
    if (!in_region(map, s)) continue;
    ++inside;
    if (ground_near(map.grid, s.at, static_cast<std::uint32_t>(map.options.min_ground_points))) continue;
    without.push_back(id_of(*map.in.stems, s.row));
    if (!place) place = s.at;
  }
  map.report.counts["stems_without_ground"] = std::ssize(without);
  if (without.empty()) return;
  const double share = 100 * static_cast<double>(without.size()) / static_cast<double>(inside);
  out.add(share > map.options.max_without_ground_pct ? Severity::look : Severity::note, "stems_without_ground",
          fmt::format("no ground was seen within 1 m of {} of {} stems ({}): their breast height and height rest on "
                      "terrain that was filled in",
                      without.size(), inside, listed(without)),
          place);
}

void judge_tops(const CheckedMap& map, CheckFindings& out) {
  if (!map.in.stems->has("height_seen")) return;
  const auto seen = numbers_or_nan(*map.in.stems, "height_seen");
  std::size_t inside = 0, without = 0;
  for (const auto& s : map.stems) {
    if (!in_region(map, s)) continue;
    ++inside;
    without += !(seen[s.row] > 0);
  }
  map.report.counts["heights_without_tops"] = static_cast<std::int64_t>(without);
  if (without > 0)
    out.add(Severity::note, "heights_without_tops",
            fmt::format("the tops of {} of {} stems were not seen: their heights are lower bounds", without, inside));
}

void judge_empty_stems(const CheckedMap& map, CheckFindings& out) {
  if (map.in.points == nullptr || !map.grid.has_heights) return;
  std::vector<std::string> empty;
  std::optional<Eigen::Vector2d> place;
  constexpr std::size_t min_points = 5;
  for (const auto& s : map.stems)
    if (in_region(map, s) && s.points < min_points) {
      empty.push_back(id_of(*map.in.stems, s.row));
      if (!place) place = s.at;
    }
  if (!empty.empty())
    out.add(Severity::look, "stems_without_points",
            fmt::format("the cloud shows no bark where {} stems of the table stand ({}): table and map do not belong "
                        "together there",
                        empty.size(), listed(empty)),
            place);
}

// The horizontal distance to the outline, negative outside.
double inside_m(const PlotArea& area, const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p,
                Eigen::Vector2d& nearest) {
  if (area.shape == PlotArea::Shape::circle) {  // exact, not by its 180 points
    const Eigen::Vector2d d = p - area.centre;
    nearest = area.centre + area.width_m / 2 * (d.norm() > 0 ? Eigen::Vector2d(d.normalized()) : Eigen::Vector2d(1, 0));
    return area.width_m / 2 - d.norm();
  }
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d along = outline[(i + 1) % outline.size()] - a;
    const double t = std::clamp((p - a).dot(along) / std::max(1e-12, along.squaredNorm()), 0.0, 1.0);
    const Eigen::Vector2d q = a + t * along;
    if (const double d = (p - q).norm(); d < best) {
      best = d;
      nearest = q;
    }
  }
  return area.contains(p) ? best : -best;
}

class Boundary {
 public:
  Boundary(const CheckedMap& map, CheckFindings& findings)
      : map_(map), out_(findings), outline_(map.area.outline()), stems_(*map.in.stems) {}

  Table judge() {
    const auto base_x = numbers_or_nan(stems_, "base_x_m"), base_y = numbers_or_nan(stems_, "base_y_m");
    for (const auto& s : map_.stems) {
      if (!(s.dbh_cm >= map_.rule.min_dbh_cm)) continue;
      const double radius = s.dbh_cm / 200;
      const bool foot = map_.options.boundary_rule == BoundaryRule::base && std::isfinite(base_x[s.row]);
      const Eigen::Vector2d at = foot ? Eigen::Vector2d(base_x[s.row], base_y[s.row]) : s.at;
      Eigen::Vector2d nearest = at;
      const double distance = inside_m(map_.area, outline_, at, nearest);
      const double limit = limit_m(at, nearest, distance, radius), doubt_m = 2 * map_.options.position_se_cm / 100;
      const bool in = distance >= limit, counted = map_.area.contains(s.at);
      basal_ += (in ? 1 : 0) * radius * radius;
      if (std::abs(distance) > radius + doubt_m && in == counted) continue;
      add(s, distance, in, std::abs(distance - limit) < doubt_m, counted);
    }
    tell();
    return table();
  }

 private:
  // How far inside the centre must lie at least.
  double limit_m(const Eigen::Vector2d& at, const Eigen::Vector2d& nearest, double distance, double radius) const {
    switch (map_.options.boundary_rule) {
      case BoundaryRule::whole:
        return radius;
      case BoundaryRule::any_part:
        return -radius;
      case BoundaryRule::half: {
        // Outwards at the nearest edge; the southern and the western one take what touches them.
        const Eigen::Vector2d outwards = distance >= 0 ? nearest - at : at - nearest;
        const bool south_or_west =
            std::abs(outwards.x()) > std::abs(outwards.y()) ? outwards.x() < 0 : outwards.y() < 0;
        return south_or_west ? -radius : radius;
      }
      default:
        return 0;
    }
  }

  void add(const StemMeasure& s, double distance, bool in, bool doubt, bool counted) {
    rows_.push_back(s.row);
    inside_.push_back(distance);
    in_.push_back(in);
    doubt_.push_back(doubt);
    if (doubt) {
      doubtful_ += std::pow(s.dbh_cm / 200, 2);
      names_.push_back(id_of(stems_, s.row));
      if (!place_) place_ = s.at;
    }
    if (in != counted) differ_.push_back(id_of(stems_, s.row) + (in ? " (in)" : " (out)"));
  }

  void tell() {
    map_.report.counts["trees_on_boundary"] = std::ssize(rows_);
    map_.report.counts["trees_in_doubt"] = std::ssize(names_);
    const std::string rule(choice_name(map_.options.boundary_rule));
    if (!names_.empty()) {
      const double share = basal_ > 0 ? 100 * doubtful_ / basal_ : 100;
      out_.add(share > map_.options.max_doubtful_pct ? Severity::look : Severity::note, "boundary_trees",
               fmt::format("{} trees stand so near the boundary that in or out is in doubt ({}; rule: {}): {:.1f} % of "
                           "the basal area. Decide them by tape",
                           names_.size(), listed(names_), rule, share),
               place_);
    }
    if (!differ_.empty())
      out_.add(Severity::look, "boundary_rule_differs",
               fmt::format("by the rule {} {} trees fall otherwise than in the values of the plot, which count by the "
                           "centre at breast height: {}. Reject those that are out (stems.edit), and add the others",
                           rule, differ_.size(), listed(differ_)));
  }

  Table table() const {
    Table t = stems_.subset(rows_);
    for (const auto& column : std::vector<Table::NamedColumn>(t.columns()))
      if (column.name != "tree_id" && column.name != "x_m" && column.name != "y_m" && column.name != "dbh_cm")
        t.remove(column.name);
    t.set("inside_m", inside_);
    t.set("in", in_);
    t.set("in_doubt", doubt_);
    t.facts["boundary_rule"] = std::string(choice_name(map_.options.boundary_rule));
    return t;
  }

  const CheckedMap& map_;
  CheckFindings& out_;
  std::vector<Eigen::Vector2d> outline_;
  const Table& stems_;
  std::vector<std::size_t> rows_;
  std::vector<double> inside_;
  std::vector<std::int64_t> in_, doubt_;
  std::vector<std::string> names_, differ_;
  std::optional<Eigen::Vector2d> place_;
  double basal_ = 0, doubtful_ = 0;
};

}  // namespace

void judge_stems(const CheckedMap& map, const std::vector<MissedStem>& missed, CheckFindings& out) {
  if (map.in.stems == nullptr) return out.skip("stems", "there is no stem table");
  if (map.stems.empty()) {
    out.add(Severity::look, "no_stems", "the table has no stem in the plot");
    return;
  }
  judge_pairs(map, out);
  judge_ground(map, out);
  judge_tops(map, out);
  judge_empty_stems(map, out);
  map.report.counts["structures_without_stem"] = std::ssize(missed);
  if (missed.empty()) return;
  const auto& thickest = *std::ranges::max_element(missed, {}, &MissedStem::dbh_cm);
  out.add(
      Severity::look, "stems_left_out",
      fmt::format("{} upright round structures have no stem in the table (the thickest about {:.0f} cm): trees may be "
                  "left out",
                  missed.size(), thickest.dbh_cm),
      thickest.at);
}

Table judge_boundary(const CheckedMap& map, CheckFindings& out) {
  if (map.in.stems == nullptr || map.area.shape == PlotArea::Shape::none) {
    out.skip("trees on the boundary", map.in.stems == nullptr ? "there is no stem table" : "the plot has no boundary");
    return {};
  }
  return Boundary(map, out).judge();
}

}  // namespace bole::survey
