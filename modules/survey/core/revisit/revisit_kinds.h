// What became of each tree between two surveys.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "survey/core/revisit/align_stands.h"
#include "survey/core/revisit/stand_hull.h"

namespace bole::survey {

// One of the surveys, its kept stems in the axes of the first.
struct SurveyedStand {
  const Table& table;
  std::vector<std::size_t> rows;  // of the table
  std::vector<StandTree> trees;
  std::vector<double> half_cm;  // half widths of the 95 % intervals
  std::vector<Eigen::Vector2d> rejected;
  double min_dbh_cm = 0;  // of the trees it has
};

struct Kind {
  std::string name, why;
};

struct KindLimits {
  double growth_cm = 0;  // possible between the surveys
  double min_dbh_cm = 0;
};

// What the trees of each survey that have no partner are; empty for those that have one.
class UnmatchedTrees {
 public:
  UnmatchedTrees(const SurveyedStand& first, const SurveyedStand& second, const std::vector<TreePair>& pairs,
                 const KindLimits& limits);

  Kind in_first(std::size_t i) const;
  Kind in_second(std::size_t j) const;
  // Of the trees of the first survey that the second covers, the share that has a partner.
  double matched_share() const;

 private:
  // Of the trees near `at` in `stand` that the other survey covers, the share with a partner.
  double share_near(const SurveyedStand& stand, const std::vector<std::uint8_t>& matched, const StandHull& other,
                    const Eigen::Vector2d& at) const;

  const SurveyedStand &first_, &second_;
  KindLimits limits_;
  StandHull hull_first_, hull_second_;
  double margin_first_m_, margin_second_m_;
  std::vector<std::uint8_t> matched_first_, matched_second_;
};

}  // namespace bole::survey
