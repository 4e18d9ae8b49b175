#include "report/survey_data.h"

#include <cmath>
#include <optional>

#include "render/charts/columns.h"

namespace bole {
namespace {

template <class T>
const T* optional_input(const DataSet& inputs, std::string_view port) {
  return inputs.has(port) ? inputs.get<T>(port).get() : nullptr;
}

std::optional<Eigen::Vector2d> target_named(const Table& targets, std::string_view name) {
  const auto names = texts_or_empty(targets, "name");
  const auto x = numbers_or_nan(targets, "x_m"), y = numbers_or_nan(targets, "y_m");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name && std::isfinite(x[i]) && std::isfinite(y[i])) return Eigen::Vector2d(x[i], y[i]);
  return {};
}

Axes axes_of(const SurveyData& data) {
  if (const auto it = data.stems->facts.find("axes"); it != data.stems->facts.end()) return axes_from_name(it->second);
  return data.points != nullptr ? data.points->axes : Axes::unknown;
}

}  // namespace

PlotArea plot_area(const ReportOptions& options, Axes axes, const Table* targets) {
  if (options.plot_shape == "none") return {};
  if (options.plot_shape != "auto") return {options.plot_shape == "circle" ? PlotArea::Shape::circle : PlotArea::Shape::rectangle, {options.plot_x, options.plot_y}, options.plot_size, options.plot_size};
  if (axes != Axes::plot || targets == nullptr) return {};
  const auto centre = target_named(*targets, "centre"), north = target_named(*targets, "north");
  if (!centre || !north) return {};
  // The north target stands on the middle of the plot's northern side (SPEC A9).
  const double side = std::round(20 * (*north - *centre).norm()) / 10;
  return {PlotArea::Shape::rectangle, *centre, side, side};
}

SurveyData survey_data(const DataSet& inputs, const ReportOptions& options) {
  SurveyData data;
  data.stems = &inputs.table("stems");
  data.points = optional_input<PointCloud>(inputs, "points");
  data.slice = optional_input<PointCloud>(inputs, "slice");
  data.dem = optional_input<Raster>(inputs, "dem");
  data.trajectory = optional_input<Trajectory>(inputs, "trajectory");
  data.reference_trajectory = optional_input<Trajectory>(inputs, "reference_trajectory");
  data.sections = optional_input<Table>(inputs, "sections");
  data.rejected = optional_input<Table>(inputs, "rejected");
  data.targets = optional_input<Table>(inputs, "targets");
  data.matches = optional_input<Table>(inputs, "matches");
  data.summary = optional_input<Table>(inputs, "summary");
  data.axes = axes_of(data);
  data.area = plot_area(options, data.axes, data.targets);
  return data;
}

}  // namespace bole
