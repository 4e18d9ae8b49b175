#include "features/figure_export/figure_source.h"

#include <algorithm>

#include "pipeline/document.h"
#include "render/maps/row_map.h"
#include "report/survey_figures.h"

namespace bole::desktop {
namespace {

const std::string row_map_name = "row map";

const pipeline::StageNode* report_of(const pipeline::PipelineDocument* document) {
  if (document == nullptr) return nullptr;
  const auto& stages = document->stages();
  const auto* options = &option_table(static_cast<const report::ReportOptions*>(nullptr));
  const auto it = std::ranges::find_if(stages, [&](const auto& node) { return node.type->options == options; });
  return it == stages.end() ? nullptr : &*it;
}

DataSet inputs_of(const pipeline::PipelineDocument& document, const pipeline::StageNode& report,
                  const Results& results) {
  DataSet data;
  for (const auto& [port, source] : document.joints(report)) {
    const auto from = results.find(source.id);
    if (from == results.end()) continue;
    if (const auto it = from->second.all().find(source.port); it != from->second.all().end())
      data.set(port, it->second);
  }
  return data;
}

DataSet shown(const Survey& survey) {
  DataSet data;
  const auto put = [&](const char* port, const auto& value) {
    if (value) data.set(port, Data(value));
  };
  put("stems", survey.stems);
  put("points", survey.points);
  put("slice", survey.slice);
  put("sections", survey.sections);
  put("matches", survey.matches);
  put("trajectory", survey.walk);
  return data;
}

// Plants of rows have no diameters.
bool draws_stems(const DataSet& data) { return data.has("stems") && data.table("stems").has("dbh_cm"); }

}  // namespace

FigureSource::FigureSource(const pipeline::PipelineDocument* document, const Results& results, const Survey& survey,
                           std::vector<OfferedFigure> offered)
    : survey_(survey), offered_(std::move(offered)) {
  if (const auto* report = report_of(document)) {
    options_ = report->options.as<report::ReportOptions>();
    data_ = inputs_of(*document, *report, results);
  }
  if (!data_.has("stems")) data_ = shown(survey);
  if (draws_stems(data_)) {
    const auto data = report::survey_data(data_);
    const Run run;
    for (const auto& plan : report::survey_figures(data, options_, run)) names_.push_back(plan.name);
  }
  if (survey_.rows && survey_.plants && survey_.lines) names_.push_back(row_map_name);
  for (const auto& figure : offered_) names_.push_back(figure.name.toStdString());
}

report::ReportOptions FigureSource::with(double width_mm, double dpi) const {
  auto options = options_;
  options.figure_width = width_mm;
  options.dpi = dpi;
  return options;
}

std::vector<render::Figure> FigureSource::make(const std::string& name, double width_mm, double dpi,
                                               const Run& run) const {
  if (name == row_map_name) {
    const auto& facts = survey_.rows->facts;
    const auto axes = facts.find("axes");
    const bool north = axes != facts.end() && (axes->second == "plot" || axes->second == "global");
    return {render::row_map(
        {survey_.rows.get(), survey_.plants.get(), survey_.lines.get(), survey_.strays.get(), north}, width_mm)};
  }
  for (const auto& figure : offered_)
    if (figure.name.toStdString() == name) return {figure.make(width_mm)};
  const auto options = with(width_mm, dpi);
  const auto data = report::survey_data(data_);
  const auto plans = report::survey_figures(data, options, run);
  const auto plan = std::ranges::find(plans, name, &report::FigurePlan::name);
  if (plan == plans.end()) throw bad_input("there is no figure '" + name + "'", "one of the list");
  return plan->make();
}

std::string figure_bytes(const render::Figure& figure, FigureFormat format, double dpi) {
  if (format == FigureFormat::svg) return render::figure_svg(figure);
  if (format == FigureFormat::pdf) return render::figure_pdf(figure);
  return render::figure_png(figure, dpi);
}

}  // namespace bole::desktop
