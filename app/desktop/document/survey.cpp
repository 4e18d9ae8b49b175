#include "document/survey.h"

#include <algorithm>
#include <utility>

#include "pipeline/stage.h"

namespace bole::desktop {
namespace {

// A stage that only reads a file: what it gives may be a reference.
bool is_reader(const vtkbridge::StageOutcome& stage) {
  const auto* type = pipeline::StageRegistry::global().find(stage.record.type);
  return type && type->inputs.empty();
}

// The last output of a kind that a stage made under this port, else the last that was read.
template <class T>
std::shared_ptr<const T> latest(const vtkbridge::RunOutcome& outcome, const Results& results, const std::string& port,
                                bool read = false) {
  for (auto stage = outcome.stages.rbegin(); stage != outcome.stages.rend(); ++stage) {
    if (is_reader(*stage) != read) continue;
    const auto found = results.find(stage->record.id);
    if (found == results.end() || !found->second.has(port)) continue;
    if (const auto* p = std::get_if<std::shared_ptr<const T>>(&found->second.all().find(port)->second)) return *p;
  }
  return read ? nullptr : latest<T>(outcome, results, port, true);
}

// In the axes of the points: the same terrain may be given in those of the earth too.
std::shared_ptr<const Raster> terrain_below(const vtkbridge::RunOutcome& outcome, const Results& results, Axes axes) {
  for (auto stage = outcome.stages.rbegin(); stage != outcome.stages.rend(); ++stage) {
    const auto found = results.find(stage->record.id);
    if (found == results.end() || !found->second.has("dem")) continue;
    const auto* dem = std::get_if<std::shared_ptr<const Raster>>(&found->second.all().find("dem")->second);
    if (dem != nullptr && (*dem)->axes == axes) return *dem;
  }
  return {};
}

}  // namespace

std::optional<std::size_t> Survey::row_of(std::int64_t tree) const {
  if (!stems || !stems->has("tree_id")) return {};
  const auto ids = stems->integers("tree_id");
  const auto it = std::ranges::find(ids, tree);
  if (it == ids.end()) return {};
  return static_cast<std::size_t>(it - ids.begin());
}

namespace {

// Pictures are taken of a plant; a walk is made through a plot.
bool has_views(const vtkbridge::RunOutcome& outcome) {
  return std::ranges::any_of(outcome.stages, [](const vtkbridge::StageOutcome& stage) {
    const auto* type = pipeline::StageRegistry::global().find(stage.record.type);
    return type && std::ranges::any_of(type->outputs, [](const auto& port) { return port.kind == DataKind::views; });
  });
}

void take_poses(const vtkbridge::RunOutcome& outcome, const Results& results, Survey& survey) {
  survey.poses = latest<Trajectory>(outcome, results, "poses");
  if (!survey.poses || survey.poses->empty()) survey.poses = survey.walk;  // read from a file of its own
  survey.walk.reset();
  survey.view_matches = std::exchange(survey.matches, nullptr);
  survey.tracking = latest<Table>(outcome, results, "tracking");
  survey.contours = latest<Table>(outcome, results, "contours");
}

void take_plant(const vtkbridge::RunOutcome& outcome, const Results& results, Survey& survey) {
  survey.traits = latest<Table>(outcome, results, "traits");
  survey.stem = latest<Table>(outcome, results, "stem");
  survey.leaves = latest<Table>(outcome, results, "leaves");
  survey.internodes = latest<Table>(outcome, results, "internodes");
  survey.field = latest<Table>(outcome, results, "field");
  survey.edit_log = latest<Table>(outcome, results, "log");
}

}  // namespace

Survey survey_of(const vtkbridge::RunOutcome& outcome, const Results& results, const Survey& before,
                 const MakeIndex& make_index) {
  Survey survey;
  survey.points = latest<PointCloud>(outcome, results, "points");
  survey.slice = latest<PointCloud>(outcome, results, "slice");
  survey.stems = latest<Table>(outcome, results, "stems");
  survey.sections = latest<Table>(outcome, results, "sections");
  survey.matches = latest<Table>(outcome, results, "matches");
  survey.rows = latest<Table>(outcome, results, "rows");
  survey.plants = latest<Table>(outcome, results, "plants");
  survey.lines = latest<Table>(outcome, results, "lines");
  survey.strays = latest<Table>(outcome, results, "strays");
  survey.plot = latest<Table>(outcome, results, "plot");
  survey.walk = latest<Trajectory>(outcome, results, "trajectory");
  if (survey.points) survey.terrain = terrain_below(outcome, results, survey.points->axes);
  if (survey.points && survey.points == before.points && before.index)
    survey.index = before.index;
  else if (survey.points)
    survey.index = make_index(survey.points);
  if (has_views(outcome)) take_poses(outcome, results, survey);
  take_plant(outcome, results, survey);
  return survey;
}

}  // namespace bole::desktop
