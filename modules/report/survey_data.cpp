#include "report/survey_data.h"

#include <algorithm>

#include "report/core/plot_metrics.h"

namespace bole::report {
namespace {

template <class T>
const T* optional_input(const DataSet& inputs, std::string_view port) {
  return inputs.has(port) ? inputs.get<T>(port).get() : nullptr;
}

Axes axes_of(const SurveyData& data) {
  if (const auto it = data.stems->facts.find("axes"); it != data.stems->facts.end()) return axes_from_name(it->second);
  return data.points != nullptr ? data.points->axes : Axes::unknown;
}

bool has_numbers(const Table& table, std::string_view column) {
  const auto* values = table.find(column);
  return values != nullptr && !std::holds_alternative<std::vector<std::string>>(*values);
}

std::shared_ptr<const Table> with_counted(const Table& stems, const CountingRule& rule) {
  const auto columns = {"x_m", "y_m", "dbh_cm"};
  if (!std::ranges::all_of(columns, [&](const char* c) { return has_numbers(stems, c); })) return nullptr;
  std::vector<std::int64_t> counted(stems.rows(), 0);
  for (const auto i : counted_stems(stems, rule)) counted[i] = 1;
  auto out = std::make_shared<Table>(stems);
  out->set("counted", std::move(counted));
  return out;
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
  if ((data.own_stems = with_counted(*data.stems, data.rule))) data.stems = data.own_stems.get();
  return data;
}

}  // namespace bole::report
