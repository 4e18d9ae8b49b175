// The trees of a stem table or field list, as an evaluation takes them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole::evaluation {

struct ListedTree {
  std::int64_t id = 0;
  std::string name;  // the id of a list that names its trees in words, as it stands there
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double dbh = 0, low = 0, high = 0;  // centimetres; NaN where not known
  double height = 0;                  // metres
  bool height_seen = true;
  std::string species;  // empty where not known
};

// Needs x_m, y_m, dbh_cm; tree_id, dbh_lo_cm, dbh_hi_cm, height_m, height_seen and species where
// present. Ids that are no whole
// numbers are kept as names and numbered above the others. Trees without a place are left out and told in `warnings`;
// `what`: whose they are. Throws Error{bad_input} when a column is absent or no row has a place.
std::vector<ListedTree> trees_of(const Table& table, const std::string& what, std::vector<std::string>& warnings);

// What a person rejected is no stem.
Table without_rejected(const Table& stems);

}  // namespace bole::evaluation
