#include "survey/core/check/check_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "survey/core/check/judge_map.h"

namespace bole::survey {
namespace {

Table cells_table(const CheckGrid& grid) {
  std::vector<double> x, y, density, span, walk, thickness, spread;
  std::vector<std::int64_t> points, ground, directions;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const auto& c = grid.cells[i];
    if (!c.inside) continue;
    const auto at = grid.middle(i);
    x.push_back(at.x());
    y.push_back(at.y());
    points.push_back(c.points);
    ground.push_back(c.ground_points);
    density.push_back(c.points / (grid.cell_m * grid.cell_m));
    directions.push_back(c.directions);
    span.push_back(c.view_span_deg);
    walk.push_back(c.walk_m);
    thickness.push_back(c.thickness_cm);
    spread.push_back(c.pass_spread_cm);
  }
  Table t;
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  t.set("points", std::move(points));
  t.set("points_per_m2", std::move(density));
  if (grid.has_heights) {
    t.set("ground_points", std::move(ground));
    t.set("ground_thickness_cm", std::move(thickness));
  }
  if (grid.has_views) {
    t.set("directions", std::move(directions));
    t.set("view_span_deg", std::move(span));
  }
  if (grid.has_passes && grid.has_heights) t.set("pass_spread_cm", std::move(spread));
  if (std::ranges::any_of(walk, [](double v) { return std::isfinite(v); })) t.set("walk_m", std::move(walk));
  t.facts["cell_m"] = number_text(grid.cell_m);
  return t;
}

Table stems_table(const std::vector<StemMeasure>& stems) {
  std::vector<double> x, y, wall, spread;
  std::vector<std::int64_t> points;
  for (const auto& s : stems) {
    x.push_back(s.at.x());
    y.push_back(s.at.y());
    points.push_back(static_cast<std::int64_t>(s.points));
    wall.push_back(s.wall_cm);
    spread.push_back(s.pass_spread_cm);
  }
  Table t;
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  t.set("points", std::move(points));
  t.set("wall_cm", std::move(wall));
  t.set("pass_spread_cm", std::move(spread));
  return t;
}

}  // namespace

SurveyCheck check_survey(const CheckInputs& in, const CheckOptions& options, const Run& run) {
  if (in.points == nullptr && in.stems == nullptr)
    throw bad_input("neither points nor stems are connected", "at least one of them",
                    "Connect a cloud or a stem table");
  SurveyCheck out;
  const CountingRule rule = in.plot != nullptr ? counting_rule(*in.plot) : CountingRule{};
  const auto heights = heights_of(in, run);
  const auto passes = in.points != nullptr ? passes_of(*in.points) : std::vector<std::int32_t>{};
  run.report(0.1, "Measuring the cells");
  const auto grid = measure_cells(in, rule.area, heights, passes, options, run);
  run.report(0.5, "Measuring the stems");
  const auto stems = measure_stems(in, grid, heights, passes, run);
  run.report(0.8, "Looking for stems that are not in the table");
  const auto missed = missed_stems(in, grid, heights, options.min_missed_dbh_cm, run);
  CheckFindings findings(grid.centre);
  const CheckedMap map{in, options, grid, rule.area, rule, stems, out.report};
  judge_cover(map, findings);
  judge_sharpness(map, findings);
  judge_loops(map, findings);
  judge_axes(map, findings);
  judge_stems(map, missed, findings);
  out.boundary = judge_boundary(map, findings);
  findings.tell(out.report);
  out.findings = findings.table();
  out.cells = cells_table(grid);
  out.stems = stems_table(stems);
  const auto inside = grid.inside_cells();
  out.report.counts["cells"] = static_cast<std::int64_t>(inside);
  out.report.metrics["checked_area"] = {static_cast<double>(inside) * grid.cell_m * grid.cell_m, Unit::square_metre};
  const auto n =
      std::ranges::count_if(out.report.findings, [](const Finding& f) { return f.severity != Severity::note; });
  out.report.message =
      fmt::format("{}: {} reasons in {:.0f} m2", findings.verdict(), n, out.report.metrics["checked_area"].value);
  return out;
}

}  // namespace bole::survey
