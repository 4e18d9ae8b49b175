// What the report is about: the connected inputs of the stage report.plot, and what follows from them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cloud/core/global_frame.h"
#include "cloud/data.h"
#include "cloud/plot_area.h"
#include "pipeline/stage.h"

namespace bole::report {

// A null pointer where an input is not connected. A new input is a member here and a row of the table in
// survey_data.cpp, which declares the port and fills the member.
struct SurveyData {
  const Table* stems = nullptr;  // of survey_data(): with the column `counted`, 1 where plot values rest on the stem
  const Table* plot = nullptr;
  const Table* plot_values = nullptr;
  const Table* diameter_classes = nullptr;
  const Table* height_curve = nullptr;
  const Table* tree_values = nullptr;
  const PointCloud* points = nullptr;
  const PointCloud* slice = nullptr;
  const Raster* dem = nullptr;
  const Raster* slope = nullptr;
  const Raster* canopy = nullptr;
  const Trajectory* trajectory = nullptr;
  const Trajectory* reference_trajectory = nullptr;
  const Table* reference_stems = nullptr;
  const Table* sections = nullptr;
  const Table* rejected = nullptr;
  const Table* edits = nullptr;
  const Table* targets = nullptr;
  const Table* control = nullptr;
  const Table* matches = nullptr;
  const Table* summary = nullptr;
  const Table* loops = nullptr;
  const Table* odometry = nullptr;
  const Table* check = nullptr;  // findings of survey.check, and its tables
  const Table* check_cells = nullptr;
  const Table* check_stems = nullptr;
  const Table* check_boundary = nullptr;
  const Table* loop_candidates = nullptr;
  const Table* pose_graph = nullptr;
  const Table* loop_edits = nullptr;

  CountingRule rule;                       // of `plot`; every tree without one
  std::shared_ptr<const Table> own_stems;  // what `stems` points to
  Axes axes = Axes::unknown;               // of the stems
  std::optional<GlobalFrame> place;        // of local axes, where the stems were georeferenced
  bool north_known() const { return axes == Axes::plot || axes == Axes::global; }

  // The trajectory was an input of the run, not computed by it.
  bool poses_given() const;
  // Those that a person did not reject: what figures and meshes show.
  Table kept_stems() const;
  // Of these, those in the plot.
  Table stems_in_plot() const;
  // Of diameter classes: that of the plot values, 4 cm where they are not connected.
  double class_width_cm() const;
  // Of exported coordinates: of the place, or of the stems; empty where their place on the earth is not known.
  std::string crs_wkt() const;
};

// The input ports of report.plot.
std::vector<pipeline::Port> survey_ports();

SurveyData survey_data(const DataSet& inputs);

}  // namespace bole::report
