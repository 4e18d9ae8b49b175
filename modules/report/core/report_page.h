// The report as one HTML page that needs nothing beside it: pictures, style and the few lines of script are inside.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/table.h"
#include "report/core/plot_metrics.h"

namespace bole::report {

struct ReportPicture {
  std::string title, caption;
  std::string media_type;  // "image/svg+xml" or "image/png"
  std::string bytes;
  bool wide = true;  // over the whole page; else two side by side
};

struct ReportContent {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  // "Made on", "Axes", ...
  PlotMetrics metrics;
  CountingRule rule;  // stems outside are counted and not listed
  const Table* stems = nullptr;
  const Table* rejected = nullptr;
  const Table* edits = nullptr;
  const Table* summary = nullptr;  // evaluation
  const Table* loops = nullptr;    // of slam.run
  const Table* odometry = nullptr;
  bool poses_given = false;  // the walk was an input of the run
  std::vector<ReportPicture> pictures;
  std::vector<std::string> warnings;
  std::shared_ptr<const RunRecord> record;
  std::vector<std::pair<std::string, std::string>> versions;  // program, libraries
  std::vector<std::string> files;                             // written beside the report
};

std::string report_html(const ReportContent& content);

}  // namespace bole::report
