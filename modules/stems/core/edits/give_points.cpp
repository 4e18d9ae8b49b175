#include "stems/core/edits/give_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <limits>

#include "base/arrays.h"

namespace bole::stems {
namespace {

struct GiveStep {
  RegionTest test;
  std::int32_t to = 0;
  std::optional<std::int32_t> only_tree;
  std::optional<int> only_class;
};

// Nothing where a tree that is named is not there; `out` says which.
std::optional<GiveStep> step_of(const PointEdit& edit, const std::vector<TreePlace>& trees, GivenPoints& out) {
  GiveStep step{RegionTest(edit.region), 0, {}, edit.only_class};
  if (edit.action == PointEdit::Action::to_tree) {
    const auto id = tree_at(trees, edit.tree);
    if (!id) return {};
    step.to = *id;
  }
  if (edit.only_free) step.only_tree = 0;
  if (edit.only_tree) {
    step.only_tree = tree_at(trees, *edit.only_tree);
    out.lacks_condition = !step.only_tree;
    if (out.lacks_condition) return {};
  }
  return step;
}

}  // namespace

std::optional<std::int32_t> tree_at(const std::vector<TreePlace>& trees, const Eigen::Vector2d& at, double reach_m) {
  double nearest = std::numeric_limits<double>::infinity(), second = nearest;
  std::int32_t id = 0;
  for (const auto& tree : trees) {
    const double d = (tree.at - at).norm();
    if (d < nearest) {
      second = nearest;
      nearest = d;
      id = tree.id;
    } else {
      second = std::min(second, d);
    }
  }
  if (!(nearest <= reach_m) || (second <= reach_m && second < 2 * nearest)) return {};
  return id;
}

std::vector<GivenPoints> give_points(const PointCloud& cloud, const std::vector<PointEdit>& edits,
                                     const std::vector<TreePlace>& trees, PointLabels& labels, const Run& run,
                                     std::vector<std::uint8_t>* given) {
  std::vector<GivenPoints> out(edits.size());
  const auto classes = given_classes(cloud, edits, run);
  const auto* class_of =
      cloud.has(arrays::classification) ? &cloud.values<std::uint8_t>(arrays::classification) : nullptr;
  if (given != nullptr) given->assign(cloud.size(), 0);
  for (std::size_t k = 0; k < edits.size(); ++k) {
    if (edits[k].gives_class()) continue;
    const auto step = step_of(edits[k], trees, out[k]);
    if (!step) continue;
    const auto takes = [&](std::size_t i) {
      if (!classes.empty() && classes[i] != 0) return false;
      if (step->only_tree && labels.tree_id[i] != *step->only_tree) return false;
      if (step->only_class && (class_of == nullptr || (*class_of)[i] != *step->only_class)) return false;
      return step->test.contains(cloud.position(i));
    };
    out[k].tree = step->to;
    out[k].points = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, cloud.size(), 100'000), std::int64_t{0},
        [&](const auto& range, std::int64_t n) {
          for (std::size_t i = range.begin(); i < range.end() && !run.cancelled(); ++i) {
            if (!takes(i)) continue;
            ++n;
            if (labels.tree_id[i] != step->to) labels.stem[i] = 0;
            labels.tree_id[i] = step->to;
            if (given != nullptr) (*given)[i] = 1;
          }
          return n;
        },
        std::plus<>());
    run.check_cancel();
  }
  return out;
}

PointCloud without_given_classes(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run) {
  const auto classes = given_classes(cloud, edits, run);
  if (classes.empty()) return cloud;
  auto positions = cloud.positions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (classes[i] != 0) positions[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  PointCloud out = cloud;
  out.set_positions(std::move(positions));
  return out;
}

}  // namespace bole::stems
