// Which figures a survey has.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/run.h"
#include "render/draw/figure.h"
#include "report/report_options.h"
#include "report/survey_data.h"

namespace bole::report {

// chart: lines and text, as vectors on the page too. sheet: drawings of many points, as pixels on the page. map: a 3-D
// scene, as pixels; it needs something that can render.
enum class FigureKind { chart, sheet, map };

// A figure still to be made: making may take seconds (3-D maps) and may throw.
struct FigurePlan {
  std::string name;                                   // for messages
  std::function<std::vector<render::Figure>()> make;  // one, or the pages of a sheet
  FigureKind kind = FigureKind::chart;
  bool wide = true;        // over the whole page of the report
  bool on_page = true;     // in report.html; the others are drawn only where all figures are asked for
  double dpi = 0;          // of the PNG; 0: that of the options
  bool asked_for = false;  // by an option of its own: drawn whatever the set of figures

  double share() const;  // of the time that all figures take, roughly
};

// Those that the connected inputs allow, in the order of the report. `data`, `options` and `run` must outlive the
// plans.
std::vector<FigurePlan> survey_figures(const SurveyData& data, const ReportOptions& options, const Run& run);

}  // namespace bole::report
