#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "modules/render/small_survey.h"
#include "render/offscreen/offscreen.h"
#include "render/scene/map_figure.h"
#include "render/scene/thin.h"

namespace bole {
namespace {

TEST(Map, WriteThemForTheEye) {
  const char* dir = std::getenv("BOLE_FIGURES_DIR");
  if (dir == nullptr) GTEST_SKIP() << "BOLE_FIGURES_DIR is not set";
  use_backend(Backend::automatic);
  testing_data::SurveyOptions size;
  size.points_per_tree = 40000;
  size.ground_points = 800000;
  const auto s = testing_data::make_small_survey(size);
  const MapData data{&s.points, &s.stems, &s.sections, &s.trajectory, {PlotArea::Shape::rectangle, {0, 0}, 20, 20}, true};
  MapOptions options;
  const auto write = [&](const Figure& f) { write_file(std::filesystem::path(dir) / (f.name + ".png"), figure_png(f, options.dpi)); };
  options.dpi = 200;
  const auto start = std::chrono::steady_clock::now();
  const auto lap = [&](const char* what) { std::printf("%s %.2f s\n", what, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()); };
  write(map_figure(data, options, 180));
  lap("height");
  options.color = PointColor::tree;
  write(map_figure(data, options, 180));
  lap("tree");
  options.view = MapView::top;
  write(map_figure(data, options, 180));
  lap("top");
  write(hero_figure(data, 240, options.dpi));
  lap("hero");
}

}  // namespace
}  // namespace bole
