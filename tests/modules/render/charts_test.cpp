#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "modules/render/small_survey.h"
#include "render/charts/dbh_charts.h"
#include "render/charts/position_charts.h"
#include "render/charts/slice_sheet.h"
#include "render/charts/stem_map.h"

namespace bole {
namespace {

const testing_data::SmallSurvey& survey() {
  static const auto made = testing_data::make_small_survey();
  return made;
}

StemMapData map_data() {
  const auto& s = survey();
  return {&s.stems, {PlotArea::Shape::rectangle, {0, 0}, 20, 20}, &s.targets, &s.trajectory, &s.matches, true};
}

std::vector<Figure> all_charts() {
  const auto& s = survey();
  std::vector<Figure> figures{stem_map(map_data(), 160), dbh_scatter(s.matches, 85), dbh_error_boxes(s.matches, 85), dbh_histogram(s.stems.numbers("dbh_cm"), 85), position_errors(s.matches, 85), trajectory_plan(s.trajectory, &s.reference, 120), trajectory_plan(s.trajectory, nullptr, 120)};
  figures.back().name = "trajectory_time";
  for (auto& page : slice_sheets(s.stems, s.slice, 180)) figures.push_back(page);
  return figures;
}

// Set BOLE_FIGURES_DIR to look at them.
TEST(Charts, WriteThemForTheEye) {
  const char* dir = std::getenv("BOLE_FIGURES_DIR");
  if (dir == nullptr) GTEST_SKIP() << "BOLE_FIGURES_DIR is not set";
  for (const auto& figure : all_charts()) {
    write_file(std::filesystem::path(dir) / (figure.name + ".png"), figure_png(figure, 200));
    write_file(std::filesystem::path(dir) / (figure.name + ".svg"), figure_svg(figure));
    write_file(std::filesystem::path(dir) / (figure.name + ".pdf"), figure_pdf(figure));
  }
}

}  // namespace
}  // namespace bole
