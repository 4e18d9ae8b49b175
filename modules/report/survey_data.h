// What the report is about: the connected inputs of the stage, and what follows from them and the options.
#pragma once

#include "cloud/data.h"
#include "render/charts/plot_area.h"
#include "report/report_options.h"

namespace bole {

// A null pointer where an input is not connected.
struct SurveyData {
  const Table* stems = nullptr;
  const PointCloud* points = nullptr;
  const PointCloud* slice = nullptr;
  const Raster* dem = nullptr;
  const Trajectory* trajectory = nullptr;
  const Trajectory* reference_trajectory = nullptr;
  const Table* sections = nullptr;
  const Table* rejected = nullptr;
  const Table* targets = nullptr;
  const Table* matches = nullptr;
  const Table* summary = nullptr;

  PlotArea area;
  Axes axes = Axes::unknown;  // of the stems
  bool north_known() const { return axes == Axes::plot || axes == Axes::global; }
};

SurveyData survey_data(const DataSet& inputs, const ReportOptions& options);

// The boundary that the options ask for. "auto": the square of plot_size in plot axes, whose origin is the centre
// target, else none. A plot's size is a design value: the measured distance of the targets does not set it.
PlotArea plot_area(const ReportOptions& options, Axes axes);

}  // namespace bole
