#include "cloud/core/regions/point_edits.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cloud/core/regions/region_json.h"

namespace bole {
inline namespace cloud {
namespace {

using Action = PointEdit::Action;

constexpr std::size_t points_at_once = 100'000;

// In the order of PointEdit::Action.
const std::array<EditAction, 4>& actions() {
  static const std::array<EditAction, 4> table{{
      {"to_tree", {"tree"}, {"only_tree", "only_free", "only_class"}},
      {"to_no_tree", {}, {"only_tree", "only_free", "only_class"}},
      {"to_ground", {}, {}},
      {"to_noise", {}, {}},
  }};
  return table;
}

bool flag_in(const EditJson& value, const std::string& key) {
  if (!value.is_boolean()) throw bad_input(key + " is " + value.dump(), "true or false");
  return value.get<bool>();
}

EditJson object_of(const PointEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}};
  if (edit.action == Action::to_tree) o["tree"] = edit_json(edit.tree);
  put_region(o, edit.region);
  if (edit.only_tree) o["only_tree"] = edit_json(*edit.only_tree);
  if (edit.only_free) o["only_free"] = true;
  if (edit.only_class) o["only_class"] = *edit.only_class;
  put_edit_record(o, edit);
  return o;
}

struct Held {
  std::int64_t points = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
};

Held held_by(const PointRegion& region, const PointCloud& cloud, const Run& run) {
  const RegionTest test(region);
  return tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, cloud.size(), points_at_once), Held{},
      [&](const auto& range, Held held) {
        for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i)
          if (const Eigen::Vector3d p = cloud.position(i); test.contains(p)) {
            ++held.points;
            held.sum += p.head<2>();
          }
        return held;
      },
      [](const Held& a, const Held& b) {
        return Held{a.points + b.points, a.sum + b.sum};
      });
}

}  // namespace

std::string_view action_name(Action action) { return actions()[static_cast<std::size_t>(action)].name; }

std::vector<PointEdit> parse_point_edits(std::string_view text) {
  std::vector<PointEdit> edits;
  read_edits(text, actions(), region_keys, [&](std::size_t action, const EditJson& object) {
    auto& edit = edits.emplace_back();
    edit.action = static_cast<Action>(action);
    static_cast<EditRecord&>(edit) = edit_record(object);
    edit.region = region_in(object);
    const auto has = [&](const char* key) { return object.contains(key); };
    if (has("tree")) edit.tree = edit_place(object["tree"], "tree");
    if (has("only_tree")) edit.only_tree = edit_place(object["only_tree"], "only_tree");
    if (has("only_free")) edit.only_free = flag_in(object["only_free"], "only_free");
    if (has("only_class")) edit.only_class = static_cast<int>(edit_number(object["only_class"], "only_class", 0, 255));
    if (edit.only_tree && edit.only_free)
      throw bad_input("only_tree and only_free are both given", "points of one tree, or of none");
  });
  return edits;
}

std::string to_json(const std::vector<PointEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

Table point_edit_table(const std::vector<PointEdit>& edits, const PointCloud& cloud, const Run& run) {
  std::vector<std::int64_t> number, points;
  std::vector<std::string> action, author, time, reason, selection;
  std::vector<double> x, y;
  for (const auto& edit : edits) {
    const auto held = held_by(edit.region, cloud, run);
    run.check_cancel();
    const bool of_tree = edit.action == Action::to_tree;
    const Eigen::Vector2d at = of_tree ? edit.tree : Eigen::Vector2d(held.sum / static_cast<double>(held.points));
    number.push_back(static_cast<std::int64_t>(number.size()) + 1);
    action.emplace_back(action_name(edit.action));
    x.push_back(at.x());
    y.push_back(at.y());
    points.push_back(held.points);
    author.push_back(edit.author);
    time.push_back(edit.time);
    reason.push_back(edit.reason);
    selection.push_back(object_of(edit).dump());
  }
  Table table;
  table.set("edit", std::move(number));
  table.set("action", std::move(action));
  table.set("x_m", std::move(x));
  table.set("y_m", std::move(y));
  table.set("points", std::move(points));
  table.set("author", std::move(author));
  table.set("time", std::move(time));
  table.set("reason", std::move(reason));
  table.set("selection", std::move(selection));
  return table;
}

std::vector<PointEdit> point_edits_in(const Table& table) {
  std::string list;
  for (const auto& edit : table.texts("selection")) list += (list.empty() ? "[" : ",") + edit;
  return list.empty() ? std::vector<PointEdit>() : parse_point_edits(list + "]");
}

std::vector<std::uint8_t> given_classes(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run) {
  if (std::ranges::none_of(edits, &PointEdit::gives_class)) return {};
  struct Step {
    RegionTest test;
    std::uint8_t to;
  };
  std::vector<Step> steps;
  for (const auto& edit : edits)
    if (!edit.has_condition())
      steps.push_back({RegionTest(edit.region), edit.action == Action::to_ground  ? ground_class
                                                : edit.action == Action::to_noise ? noise_class
                                                                                  : std::uint8_t{0}});
  std::vector<std::uint8_t> given(cloud.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), points_at_once), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i) {
      const Eigen::Vector3d p = cloud.position(i);
      for (const auto& step : steps)
        if (step.test.contains(p)) given[i] = step.to;
    }
  });
  run.check_cancel();
  return given;
}

}  // namespace cloud
}  // namespace bole
