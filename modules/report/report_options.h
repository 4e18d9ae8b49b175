// What the report stage can be told.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::report {

// page: those of report.html, as they stand there. all: also further views of the map and the slice sheet, every figure
// as PNG at full resolution, SVG and PDF.
enum class FigureSet { page, all };
constexpr std::array<std::string_view, 2> choice_names(FigureSet) { return {"page", "all"}; }

// Of the map with all its columns: cloud.laz, cloud.las or cloud.copc.laz.
enum class CloudFormat { laz, las, copc };
constexpr std::array<std::string_view, 3> choice_names(CloudFormat) { return {"laz", "las", "copc"}; }

struct ReportOptions {
  std::string title = "Forest plot survey";
  double figure_width = 180;
  double dpi = 300;
  int point_budget = 2'500'000;
  std::string backend = "auto";
  bool tables = true;
  bool cloud = true;
  CloudFormat cloud_format = CloudFormat::laz;
  bool figures = true;
  FigureSet figure_set = FigureSet::page;
  bool hero = false;
  bool vector_figures = true;
  bool page = true;
};

const OptionTable& option_table(const ReportOptions*);

}  // namespace bole::report
