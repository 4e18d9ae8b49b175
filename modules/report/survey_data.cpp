#include "report/survey_data.h"

#include <algorithm>
#include <variant>

#include "base/option_text.h"
#include "cloud/known_facts.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"

namespace bole::report {
namespace {

using Member = std::variant<const Table * SurveyData::*, const PointCloud * SurveyData::*, const Raster * SurveyData::*,
                            const Trajectory * SurveyData::*>;

struct Input {
  const char* port;
  Member member;
  const char* help;
  bool optional = true;
};

const std::vector<Input>& survey_inputs() {
  using S = SurveyData;
  static const std::vector<Input> all{
      {"stems", &S::stems, "Stems with x_m, y_m and dbh_cm.", false},
      {"plot", &S::plot, "Which trees count, from survey.plot; all of them when absent."},
      {"plot_values", &S::plot_values, "Values of the plot, from inventory.plot_values."},
      {"diameter_classes", &S::diameter_classes, "Values by diameter class, from inventory.plot_values."},
      {"height_curve", &S::height_curve, "Height curve, from inventory.plot_values."},
      {"tree_values", &S::tree_values, "Height and volume of each tree, from inventory.plot_values."},
      {"points", &S::points, "The map, coloured by height_above_ground, intensity and tree_id where it has them."},
      {"slice", &S::slice, "Points around breast height, for the slice sheet."},
      {"dem", &S::dem, "Terrain model."},
      {"slope", &S::slope, "Slope of the terrain."},
      {"canopy", &S::canopy, "Canopy height model."},
      {"trajectory", &S::trajectory, "The trajectory of the scanner."},
      {"reference_trajectory", &S::reference_trajectory, "The true trajectory, in the same axes."},
      {"reference_stems", &S::reference_stems, "Reference trees, as they were given."},
      {"sections", &S::sections, "Fitted cross-sections."},
      {"rejected", &S::rejected, "Candidates that are no stems, with their reasons."},
      {"edits", &S::edits, "What a person changed, from stems.edit."},
      {"targets", &S::targets, "Reflective targets of the plot frame."},
      {"control", &S::control, "Control points with residuals, from survey.georeference."},
      {"matches", &S::matches, "Stems matched with a reference."},
      {"summary", &S::summary, "Measures of the evaluation beside published ones."},
      {"loops", &S::loops, "Loop closures, from slam.run or slam.edit_loops."},
      {"odometry", &S::odometry, "What slam.run found for each frame."},
      {"loop_candidates", &S::loop_candidates, "All loop closures that were tried, from the same stage."},
      {"pose_graph", &S::pose_graph, "Edges of the pose graph, from the same stage."},
      {"loop_edits", &S::loop_edits, "What a person decided about loop closures, from slam.edit_loops."},
      {"check", &S::check, "Findings of the check of the map, from survey.check."},
      {"check_cells", &S::check_cells, "Measures of every cell, from survey.check."},
      {"check_stems", &S::check_stems, "Measures at every stem, from survey.check."},
      {"check_boundary", &S::check_boundary, "Trees on the boundary, from survey.check."}};
  return all;
}

DataKind kind_of(const Member& member) {
  struct Kind {
    DataKind operator()(const Table* SurveyData::*) const { return DataKind::table; }
    DataKind operator()(const PointCloud* SurveyData::*) const { return DataKind::cloud; }
    DataKind operator()(const Raster* SurveyData::*) const { return DataKind::raster; }
    DataKind operator()(const Trajectory* SurveyData::*) const { return DataKind::trajectory; }
  };
  return std::visit(Kind{}, member);
}

template <class T>
void take(const DataSet& inputs, const char* port, const T* SurveyData::*member, SurveyData& data) {
  data.*member = inputs.get<T>(port).get();
}

Axes axes_of(const SurveyData& data) {
  if (const auto axes = fact_text(data.stems->facts, facts::axes)) return axes_from_name(*axes);
  return data.points != nullptr ? data.points->axes : Axes::unknown;
}

}  // namespace

bool SurveyData::poses_given() const {
  const auto given = [](const auto* data) { return data != nullptr && pose_origin(data->facts) == PoseOrigin::given; };
  return given(trajectory) || given(points) || given(stems);
}

Table SurveyData::kept_stems() const { return stems->subset(kept_rows(*stems)); }

Table SurveyData::stems_in_plot() const {
  const Table kept = kept_stems();
  const auto x = numbers_or_nan(kept, "x_m"), y = numbers_or_nan(kept, "y_m");
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < kept.rows(); ++i)
    if (rule.area.contains(x[i], y[i])) inside.push_back(i);
  return kept.subset(inside);
}

double SurveyData::class_width_cm() const {
  constexpr double usual = 4;
  if (plot_values == nullptr) return usual;
  const auto it = plot_values->facts.find("class_width_cm");
  return it == plot_values->facts.end() ? usual : number_from_text(it->second).value_or(usual);
}

std::string SurveyData::crs_wkt() const {
  if (place) return place->crs_wkt;
  if (axes != Axes::global) return {};
  if (points != nullptr && !points->crs_wkt.empty()) return points->crs_wkt;
  return fact_text(stems->facts, facts::crs).value_or("");
}

std::vector<pipeline::Port> survey_ports() {
  std::vector<pipeline::Port> ports;
  for (const auto& input : survey_inputs())
    ports.push_back({input.port, kind_of(input.member), input.help, input.optional, {}});
  return ports;
}

SurveyData survey_data(const DataSet& inputs) {
  SurveyData data;
  for (const auto& input : survey_inputs())
    if (!input.optional || inputs.has(input.port))
      std::visit([&](auto member) { take(inputs, input.port, member, data); }, input.member);
  data.axes = axes_of(data);
  data.place = global_frame_of(data.stems->facts);
  if (data.plot != nullptr) data.rule = counting_rule(*data.plot);
  data.own_stems = std::make_shared<const Table>(with_counted(*data.stems, data.rule));
  data.stems = data.own_stems.get();
  return data;
}

}  // namespace bole::report
