#include "survey/core/revisit/revisit_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cloud/table_columns.h"

namespace bole::survey {
namespace {

constexpr double near_m = 6, low_share = 0.7, rejected_m = 0.5, duplicate_m = 0.25;
constexpr int min_near = 3;

std::vector<Eigen::Vector2d> places_of(const SurveyedStand& s) {
  std::vector<Eigen::Vector2d> at;
  for (const auto& t : s.trees) at.push_back(t.at);
  return at;
}

// Half the usual distance of neighbours: so far beyond its outermost trees a survey still covers the ground.
double margin_of(const StandHull& hull, std::size_t trees) {
  constexpr double max_margin_m = 2;
  return trees > 0 ? std::min(max_margin_m, std::sqrt(hull.area_m2() / static_cast<double>(trees)) / 2) : 0;
}

bool any_near(const std::vector<Eigen::Vector2d>& places, const Eigen::Vector2d& at, double reach_m) {
  return std::ranges::any_of(places, [&](const Eigen::Vector2d& p) { return (p - at).norm() < reach_m; });
}

bool doubtful(const SurveyedStand& s, std::size_t i) {
  const auto quality = texts_or_empty(s.table, "quality"), state = texts_or_empty(s.table, "state");
  return quality[s.rows[i]] == "poor" || state[s.rows[i]] == "check";
}

// A tree without a partner that stands where a matched one stands.
bool duplicate(const SurveyedStand& s, const std::vector<std::uint8_t>& matched, std::size_t i) {
  for (std::size_t k = 0; k < s.trees.size(); ++k)
    if (k != i && matched[k] != 0 && (s.trees[k].at - s.trees[i].at).norm() < duplicate_m) return true;
  return false;
}

}  // namespace

UnmatchedTrees::UnmatchedTrees(const SurveyedStand& first, const SurveyedStand& second,
                               const std::vector<TreePair>& pairs, const KindLimits& limits)
    : first_(first),
      second_(second),
      limits_(limits),
      hull_first_(places_of(first)),
      hull_second_(places_of(second)),
      margin_first_m_(margin_of(hull_first_, first.trees.size())),
      margin_second_m_(margin_of(hull_second_, second.trees.size())),
      matched_first_(first.trees.size(), 0),
      matched_second_(second.trees.size(), 0) {
  for (const auto& p : pairs) matched_first_[p.first] = matched_second_[p.second] = 1;
}

double UnmatchedTrees::share_near(const SurveyedStand& stand, const std::vector<std::uint8_t>& matched,
                                  const StandHull& other, const Eigen::Vector2d& at) const {
  int all = 0, partnered = 0;
  for (std::size_t i = 0; i < stand.trees.size(); ++i) {
    const auto& t = stand.trees[i];
    if ((t.at - at).norm() > near_m || t.at == at || !other.contains(t.at, 0)) continue;
    ++all;
    partnered += matched[i] != 0;
  }
  return all < min_near ? 1.0 : static_cast<double>(partnered) / all;
}

double UnmatchedTrees::matched_share() const {
  int all = 0, partnered = 0;
  for (std::size_t i = 0; i < first_.trees.size(); ++i)
    if (hull_second_.contains(first_.trees[i].at, 0)) {
      ++all;
      partnered += matched_first_[i] != 0;
    }
  return all > 0 ? static_cast<double>(partnered) / all : 0;
}

Kind UnmatchedTrees::in_first(std::size_t i) const {
  if (matched_first_[i] != 0) return {"matched", ""};
  const auto& t = first_.trees[i];
  if (duplicate(first_, matched_first_, i))
    return {"duplicate_first", "stands where another stem of the first survey is matched"};
  if (!hull_second_.contains(t.at, margin_second_m_))
    return {"outside_second", "beyond the trees of the second survey"};
  if (any_near(second_.rejected, t.at, rejected_m))
    return {"missed_in_second", "the second survey rejected a candidate here"};
  if (any_near(places_of(second_), t.at, duplicate_m))
    return {"missed_in_second", "a stem stands here whose diameter does not go with this one"};
  if (t.dbh_cm < second_.min_dbh_cm + first_.half_cm[i])
    return {"below_in_second",
            fmt::format("about as thin as the thinnest stem of the second survey ({:.1f} cm)", second_.min_dbh_cm)};
  if (const double share = share_near(first_, matched_first_, hull_second_, t.at); share < low_share)
    return {"missed_in_second", fmt::format("only {:.0f} % of the trees around it were found again", 100 * share)};
  if (doubtful(first_, i)) return {"gone", "felled, fallen, or no tree: the first survey was not sure of it"};
  if (!hull_second_.contains(t.at, 0))
    return {"gone", "at the edge of the second survey: look whether it reached here"};
  return {"gone", "its neighbours were found again"};
}

Kind UnmatchedTrees::in_second(std::size_t j) const {
  if (matched_second_[j] != 0) return {"matched", ""};
  const auto& t = second_.trees[j];
  if (duplicate(second_, matched_second_, j))
    return {"duplicate_second", "stands where another stem of the second survey is matched"};
  if (!hull_first_.contains(t.at, margin_first_m_)) return {"outside_first", "beyond the trees of the first survey"};
  if (any_near(first_.rejected, t.at, rejected_m))
    return {"missed_in_first", "the first survey rejected a candidate here"};
  if (any_near(places_of(first_), t.at, duplicate_m))
    return {"missed_in_first", "a stem stands here whose diameter does not go with this one"};
  const double threshold = std::max(first_.min_dbh_cm, limits_.min_dbh_cm);
  if (t.dbh_cm > threshold + limits_.growth_cm + second_.half_cm[j])
    return {"missed_in_first", fmt::format("too thick to have grown past {:.1f} cm since", threshold)};
  if (t.dbh_cm < limits_.min_dbh_cm) return {"below", "thinner than the trees that count"};
  if (const double share = share_near(second_, matched_second_, hull_first_, t.at); share < low_share)
    return {"missed_in_first",
            fmt::format("only {:.0f} % of the trees around it were in the first survey", 100 * share)};
  return {"ingrowth", "thin enough to have grown in since"};
}

}  // namespace bole::survey
