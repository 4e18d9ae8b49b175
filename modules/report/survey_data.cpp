#include "report/survey_data.h"

namespace bole {
namespace {

template <class T>
const T* optional_input(const DataSet& inputs, std::string_view port) {
  return inputs.has(port) ? inputs.get<T>(port).get() : nullptr;
}

Axes axes_of(const SurveyData& data) {
  if (const auto it = data.stems->facts.find("axes"); it != data.stems->facts.end()) return axes_from_name(it->second);
  return data.points != nullptr ? data.points->axes : Axes::unknown;
}

}  // namespace

Table SurveyData::kept_stems() const {
  const auto* state = std::get_if<std::vector<std::string>>(stems->find("state"));
  if (state == nullptr) return *stems;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < state->size(); ++i)
    if ((*state)[i] != "rejected") kept.push_back(i);
  return stems->subset(kept);
}

std::string SurveyData::crs_wkt() const {
  if (axes != Axes::global) return {};
  if (points != nullptr && !points->crs_wkt.empty()) return points->crs_wkt;
  const auto fact = stems->facts.find("crs");
  return fact != stems->facts.end() ? fact->second : std::string();
}

SurveyData survey_data(const DataSet& inputs) {
  SurveyData data;
  data.stems = &inputs.table("stems");
  data.points = optional_input<PointCloud>(inputs, "points");
  data.slice = optional_input<PointCloud>(inputs, "slice");
  data.dem = optional_input<Raster>(inputs, "dem");
  data.slope = optional_input<Raster>(inputs, "slope");
  data.canopy = optional_input<Raster>(inputs, "canopy");
  data.trajectory = optional_input<Trajectory>(inputs, "trajectory");
  data.reference_trajectory = optional_input<Trajectory>(inputs, "reference_trajectory");
  data.sections = optional_input<Table>(inputs, "sections");
  data.rejected = optional_input<Table>(inputs, "rejected");
  data.edits = optional_input<Table>(inputs, "edits");
  data.targets = optional_input<Table>(inputs, "targets");
  data.matches = optional_input<Table>(inputs, "matches");
  data.summary = optional_input<Table>(inputs, "summary");
  data.loops = optional_input<Table>(inputs, "loops");
  data.odometry = optional_input<Table>(inputs, "odometry");
  data.axes = axes_of(data);
  if (inputs.has("plot")) data.rule = counting_rule(inputs.table("plot"));
  return data;
}

}  // namespace bole
