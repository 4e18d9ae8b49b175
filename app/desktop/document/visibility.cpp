#include "document/visibility.h"

#include <algorithm>

namespace bole::desktop {
namespace {

bool holds(const Results& results, const std::shared_ptr<const PointCloud>& points) {
  return std::ranges::any_of(results, [&](const auto& stage) {
    return std::ranges::any_of(stage.second.all(), [&](const auto& port) {
      const auto* cloud = std::get_if<std::shared_ptr<const PointCloud>>(&port.second);
      return cloud != nullptr && *cloud == points;
    });
  });
}

}  // namespace

void Visibility::show(const std::string& stage, ViewKind view, bool on) {
  auto& hidden = hidden_[static_cast<std::size_t>(view)];
  if (on ? hidden.erase(stage) == 0 : !hidden.insert(stage).second) return;
  Q_EMIT changed();
}

void Visibility::show_all() {
  hidden_ = {};
  outcome_ = {};
  results_.clear();
  indices_.clear();
  Q_EMIT changed();
}

void Visibility::take(const vtkbridge::RunOutcome& outcome, const Results& results) {
  outcome_ = outcome;
  results_ = results;
  std::erase_if(indices_, [&](const auto& entry) { return !holds(results, entry.first); });
}

std::shared_ptr<const PointIndex> Visibility::index_of(const std::shared_ptr<const PointCloud>& points,
                                                       const Survey& all) const {
  auto& index = indices_[points];
  if (!index) index = std::make_shared<const PointIndex>(points, all.points, all.index);
  return index;
}

Survey Visibility::survey_for(ViewKind view, const Survey& all) const {
  if (hidden(view).empty() || results_.empty()) return all;
  Results rest = results_;
  for (const auto& stage : hidden(view)) rest.erase(stage);
  return survey_of(outcome_, rest, all, [&](const auto& points) { return index_of(points, all); });
}

}  // namespace bole::desktop
