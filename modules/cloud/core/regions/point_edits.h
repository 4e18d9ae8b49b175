// Points that a person gave to a tree, to no tree, to the ground or to noise: a list of selections by geometry that is
// kept beside the pipeline and applied anew after every run.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/run.h"
#include "cloud/core/regions/point_region.h"
#include "cloud/edit_list.h"
#include "cloud/table.h"

namespace bole {
inline namespace cloud {

// Trees are named by their place in plan at breast height, metres, since ids change when a run is repeated.
struct PointEdit : EditRecord {
  enum class Action { to_tree, to_no_tree, to_ground, to_noise };

  Action action = Action::to_noise;
  PointRegion region;
  Eigen::Vector2d tree = Eigen::Vector2d::Zero();  // to_tree
  // Conditions of to_tree and to_no_tree: only points of one tree, of none, or of a class.
  std::optional<Eigen::Vector2d> only_tree;
  bool only_free = false;
  std::optional<int> only_class;

  bool gives_class() const { return action == Action::to_ground || action == Action::to_noise; }
  bool has_condition() const { return only_tree || only_free || only_class; }
};

std::string_view action_name(PointEdit::Action action);  // "to_tree", ...

// A JSON list of objects, for instance
//   [{"action": "to_tree", "tree": [3.2, 27.9], "path": [[3.0, 27.5, 8.1], [3.4, 27.2, 8.6]], "radius_m": 0.3,
//     "only_free": true, "author": "A. Smith", "time": "2026-05-02T10:15:00Z", "reason": "a branch of it"},
//    {"action": "to_noise", "centre": [1, 2, 12], "size_m": [2, 2, 1]}]
// with a region as in region_json.h. Throws Error{bad_input} that names the edit by its number: text that is no JSON,
// unknown actions or keys, what an action needs and lacks, outlines that cross themselves, conditions on what is not
// known yet where ground and noise are told apart (trees and classes).
std::vector<PointEdit> parse_point_edits(std::string_view json);

// The same list back: parse_point_edits(to_json(edits)) gives `edits`.
std::string to_json(const std::vector<PointEdit>& edits);

// One row for each edit: edit (its number), action, x_m, y_m (of the tree; else the middle of the points), points (in
// the selection), author, time, reason, and `selection`, the edit as JSON, from which point_edits_in() reads the list.
// Throw Error{cancelled} when asked to, point_edits_in() Error{bad_input} for a table without that column.
Table point_edit_table(const std::vector<PointEdit>& edits, const PointCloud& cloud, const Run& run);
std::vector<PointEdit> point_edits_in(const Table& table);

inline constexpr std::uint8_t ground_class = 2, noise_class = 7;  // ASPRS

// By point the class that a person gave: the last of the edits that holds it counts, and one that gives the point to a
// tree or to no tree without a condition takes it back. 0: none. Empty where no edit gives a class.
std::vector<std::uint8_t> given_classes(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run);

}  // namespace cloud
}  // namespace bole
