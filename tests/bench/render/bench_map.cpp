// How long the drawing of a plot takes: choosing the points of a large cloud, a map, a sheet of slices.
#include <benchmark/benchmark.h>

#include "modules/render/small_survey.h"
#include "render/charts/slice_sheet.h"
#include "render/maps/stem_map.h"
#include "render/offscreen/offscreen.h"
#include "render/scene/map_figure.h"
#include "render/scene/thin.h"

namespace bole {
namespace {

testing_data::SmallSurvey survey_of(std::int64_t points) {
  testing_data::SurveyOptions options;
  options.trees = 80, options.plot_m = 32;
  options.points_per_tree = static_cast<int>(points * 3 / 4 / 80), options.ground_points = static_cast<int>(points / 4);
  return testing_data::make_small_survey(options);
}

void thin(benchmark::State& state) {
  const auto survey = survey_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(render::thin_for_drawing(survey.points, {}, 2'500'000));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(survey.points.size()));
}
BENCHMARK(thin)->Arg(3'000'000)->Iterations(1)->Unit(benchmark::kMillisecond);

void map_180_mm_300_dpi(benchmark::State& state) {
  render::use_backend(render::Backend::automatic);
  const auto survey = survey_of(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(render::figure_png(
        render::map_figure(
            {&survey.points, &survey.stems, &survey.sections, &survey.trajectory, rectangle_area({0, 0}, 32, 32), true},
            {}, 180),
        300));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(survey.points.size()));
}
BENCHMARK(map_180_mm_300_dpi)->Arg(3'000'000)->Iterations(1)->Unit(benchmark::kMillisecond);

void slice_sheet_of_80_trees(benchmark::State& state) {
  const auto survey = survey_of(1'000'000);
  for (auto _ : state)
    for (const auto& page : render::slice_sheets(survey.stems, survey.slice, 180))
      benchmark::DoNotOptimize(render::figure_png(page, 300));
}
BENCHMARK(slice_sheet_of_80_trees)->Iterations(1)->Unit(benchmark::kMillisecond);

void stem_map_of_80_trees(benchmark::State& state) {
  const auto survey = survey_of(10'000);
  for (auto _ : state)
    benchmark::DoNotOptimize(render::figure_svg(render::stem_map(
        {&survey.stems, rectangle_area({0, 0}, 32, 32), &survey.targets, &survey.trajectory, &survey.matches, true},
        180)));
}
BENCHMARK(stem_map_of_80_trees)->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bole
