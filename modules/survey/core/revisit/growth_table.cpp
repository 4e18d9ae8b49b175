#include "survey/core/revisit/growth_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/no_number.h"
#include "base/statistics.h"

namespace bole::survey {
namespace {

constexpr double m2_per_cm2 = std::numbers::pi / 40000;  // of a basal area by the square of a diameter

std::string id_of(const SurveyedStand& s, std::size_t i) {
  return s.table.has("tree_id") ? s.table.text("tree_id", s.rows[i], 0) : std::to_string(s.rows[i] + 1);
}

class Rows {
 public:
  Rows(const RevisitOptions& o, const std::optional<double>& years, GrowthSums& sums)
      : o_(o), years_(years), sums_(sums) {}

  void add_pair(const SurveyedStand& a, const SurveyedStand& b, const TreePair& p) {
    const auto &t = a.trees[p.first], &u = b.trees[p.second];
    add(id_of(a, p.first), id_of(b, p.second), {"matched", ""}, t.at);
    const double growth = u.dbh_cm - t.dbh_cm, half = std::hypot(a.half_cm[p.first], b.half_cm[p.second]);
    dbh1_.back() = t.dbh_cm;
    dbh2_.back() = u.dbh_cm;
    distance_.back() = p.distance_m;
    if (!std::isfinite(growth)) return;
    growth_.back() = growth;
    half_.back() = half;
    change_.back() = growth > half ? "grew" : growth < -half ? "shrank" : "none";
    sums_.grew += growth > half;
    sums_.shrank += growth < -half;
    const bool crossed = t.dbh_cm < o_.min_dbh_cm && u.dbh_cm >= o_.min_dbh_cm;
    ingrowth_.back() = crossed;
    sums_.crossed += crossed;
    sums_.counted_first += t.dbh_cm >= o_.min_dbh_cm;
    ++sums_.matched;
    sums_.growth_cm += growth;
    const double shared = std::pow(o_.shared_bias_cm, 2);
    const auto own = [&](double half_cm) { return std::max(0.0, std::pow(half_cm / z_95, 2) - shared); };
    const double own1 = own(a.half_cm[p.first]), own2 = own(b.half_cm[p.second]);
    sums_.variance_cm2 += own1 + own2;
    sums_.basal_first_m2 += m2_per_cm2 * t.dbh_cm * t.dbh_cm;
    sums_.basal_second_m2 += m2_per_cm2 * u.dbh_cm * u.dbh_cm;
    sums_.basal_variance_m4 += std::pow(2 * m2_per_cm2, 2) * (t.dbh_cm * t.dbh_cm * own1 + u.dbh_cm * u.dbh_cm * own2);
    sums_.basal_slope_m2_per_cm += 2 * m2_per_cm2 * std::hypot(t.dbh_cm, u.dbh_cm) / std::numbers::sqrt2;
  }

  void add_single(const SurveyedStand& s, std::size_t i, const Kind& kind, bool is_first) {
    const auto id = id_of(s, i);
    add(is_first ? id : "", is_first ? "" : id, kind, s.trees[i].at);
    (is_first ? dbh1_ : dbh2_).back() = s.trees[i].dbh_cm;
    ingrowth_.back() = kind.name == "ingrowth";
    sums_.missed += kind.name.starts_with("missed");
    ++sums_.of_kind[kind.name];
    if (kind.name == "gone" && s.trees[i].dbh_cm >= o_.min_dbh_cm) {
      ++sums_.gone;
      ++sums_.counted_first;
    }
  }

  Table table() const {
    Table t;
    t.set("tree_id", id1_);
    t.set("tree_id_second", id2_);
    t.set("kind", kind_);
    t.set("why", why_);
    t.set("x_m", x_);
    t.set("y_m", y_);
    t.set("dbh1_cm", dbh1_);
    t.set("dbh2_cm", dbh2_);
    t.set("growth_cm", growth_);
    t.set("growth_lo_cm", bound(-1, 1));
    t.set("growth_hi_cm", bound(1, 1));
    if (years_) {
      t.set("growth_cm_per_year", bound(0, *years_));
      t.set("growth_lo_cm_per_year", bound(-1, *years_));
      t.set("growth_hi_cm_per_year", bound(1, *years_));
    }
    t.set("change", change_);
    t.set("ingrowth", ingrowth_);
    t.set("distance_m", distance_);
    return t;
  }

 private:
  void add(std::string id1, std::string id2, const Kind& kind, const Eigen::Vector2d& at) {
    id1_.push_back(std::move(id1));
    id2_.push_back(std::move(id2));
    kind_.push_back(kind.name);
    why_.push_back(kind.why);
    x_.push_back(at.x());
    y_.push_back(at.y());
    for (auto* column : {&dbh1_, &dbh2_, &growth_, &half_, &distance_}) column->push_back(no_number);
    change_.emplace_back();
    ingrowth_.push_back(0);
  }

  std::vector<double> bound(double sign, double years) const {
    std::vector<double> values(growth_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = (growth_[i] + sign * half_[i]) / years;
    return values;
  }

  const RevisitOptions& o_;
  const std::optional<double>& years_;
  GrowthSums& sums_;
  std::vector<std::string> id1_, id2_, kind_, why_, change_;
  std::vector<double> x_, y_, dbh1_, dbh2_, growth_, half_, distance_;
  std::vector<std::int64_t> ingrowth_;
};

struct Values {
  std::vector<std::string> measure, unit;
  std::vector<double> value, lo, hi;
  void add(const std::string& name, double v, const std::string& u, double half = no_number) {
    add_between(name, v, u, v - half, v + half);
  }
  void add_between(const std::string& name, double v, const std::string& u, double from, double to) {
    measure.push_back(name);
    value.push_back(v);
    unit.push_back(u);
    lo.push_back(from);
    hi.push_back(to);
  }
};

// Wilson's 95 % interval of a share.
std::pair<double, double> share_interval(double k, double n) {
  const double z2 = z_95 * z_95, middle = (k + z2 / 2) / (n + z2),
               half = z_95 / (n + z2) * std::sqrt(k * (n - k) / n + z2 / 4);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace

Table growth_table(const SurveyedStand& first, const SurveyedStand& second, const std::vector<TreePair>& pairs,
                   const UnmatchedTrees& kinds, const RevisitOptions& options, const std::optional<double>& years,
                   GrowthSums& sums) {
  Rows rows(options, years, sums);
  for (const auto& p : pairs) rows.add_pair(first, second, p);
  for (std::size_t i = 0; i < first.trees.size(); ++i)
    if (const auto kind = kinds.in_first(i); kind.name != "matched") rows.add_single(first, i, kind, true);
  for (std::size_t j = 0; j < second.trees.size(); ++j)
    if (const auto kind = kinds.in_second(j); kind.name != "matched") rows.add_single(second, j, kind, false);
  return rows.table();
}

Table value_table(const GrowthSums& s, const RevisitOptions& o, const std::optional<double>& years) {
  Values v;
  const auto n = static_cast<double>(s.matched);
  const double shared = std::numbers::sqrt2 * o.shared_bias_cm;  // of the difference of two surveys
  v.add("trees_found_again", n, "");
  if (s.matched > 0) {
    const double half = z_95 * std::hypot(std::sqrt(s.variance_cm2) / n, shared);
    v.add("mean_growth", s.mean_growth_cm(), "cm", half);
    if (years) v.add("mean_growth_per_year", s.mean_growth_cm() / *years, "cm/year", half / *years);
    const double basal = s.basal_second_m2 - s.basal_first_m2,
                 basal_half = z_95 * std::hypot(std::sqrt(s.basal_variance_m4), s.basal_slope_m2_per_cm * shared);
    v.add("basal_area_growth", basal, "m2", basal_half);
    if (years) v.add("basal_area_growth_per_year", basal / *years, "m2/year", basal_half / *years);
  }
  v.add("grew", static_cast<double>(s.grew), "");
  v.add("shrank", static_cast<double>(s.shrank), "");
  const auto count = [&](const char* kind) {
    const auto it = s.of_kind.find(kind);
    return it == s.of_kind.end() ? 0.0 : static_cast<double>(it->second);
  };
  v.add("ingrowth", count("ingrowth") + static_cast<double>(s.crossed), "");
  v.add("gone", static_cast<double>(s.gone), "");
  if (s.counted_first > 0) {
    const double k = static_cast<double>(s.gone), all = static_cast<double>(s.counted_first);
    const auto [lo, hi] = share_interval(k, all);
    v.add_between("mortality", 100 * k / all, "%", 100 * lo, 100 * hi);
    if (years) {
      const auto yearly = [&](double share) { return 100 * (1 - std::pow(1 - share, 1 / *years)); };
      v.add_between("mortality_per_year", yearly(k / all), "%/year", yearly(lo), yearly(hi));
    }
  }
  for (const char* kind : {"missed_in_first", "missed_in_second", "below_in_second", "edge_of_first", "edge_of_second",
                           "outside_first", "outside_second"})
    v.add(kind, count(kind), "");
  Table t;
  t.set("measure", v.measure);
  t.set("value", v.value);
  t.set("unit", v.unit);
  t.set("lo", v.lo);
  t.set("hi", v.hi);
  return t;
}

}  // namespace bole::survey
