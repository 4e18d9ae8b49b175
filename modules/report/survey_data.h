// What the report is about: the connected inputs of the stage, and what follows from them and the options.
#pragma once

#include <memory>

#include "cloud/data.h"
#include "cloud/plot_area.h"

namespace bole::report {

// A null pointer where an input is not connected.
struct SurveyData {
  const Table* stems = nullptr;  // of survey_data(): with the column `counted`, 1 where plot values rest on the stem
  const PointCloud* points = nullptr;
  const PointCloud* slice = nullptr;
  const Raster* dem = nullptr;
  const Raster* slope = nullptr;
  const Raster* canopy = nullptr;
  const Trajectory* trajectory = nullptr;
  const Trajectory* reference_trajectory = nullptr;
  const Table* sections = nullptr;
  const Table* rejected = nullptr;
  const Table* edits = nullptr;
  const Table* targets = nullptr;
  const Table* matches = nullptr;
  const Table* summary = nullptr;
  const Table* loops = nullptr;  // of slam.run, as is odometry
  const Table* odometry = nullptr;

  CountingRule rule;
  std::shared_ptr<const Table> own_stems;  // what `stems` points to where a column was added
  Axes axes = Axes::unknown;               // of the stems
  bool north_known() const { return axes == Axes::plot || axes == Axes::global; }

  // Those that a person did not reject: what figures and meshes show.
  Table kept_stems() const;
  std::string crs_wkt() const;  // of the stems; empty where their axes are not global
};

SurveyData survey_data(const DataSet& inputs);

}  // namespace bole::report
