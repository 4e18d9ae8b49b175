#include "report/compare/compare_clouds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/no_number.h"
#include "cloud/table_columns.h"
#include "io/core/clouds/cloud_reader.h"

namespace bole::report {
namespace {

constexpr double half_slice_m = 0.05, margin_m = 1.5;
constexpr int max_panel_points = 2500;

// The trees of the table by their place in the reference (or in the run that stands for it).
std::map<std::pair<double, double>, ComparedPlace> places_of(const Table& trees, const std::vector<std::size_t>& runs) {
  std::map<std::pair<double, double>, ComparedPlace> places;
  const auto run = trees.integers("run");
  const auto x = trees.numbers("x_m"), y = trees.numbers("y_m"), rx = trees.numbers("ref_x_m"),
             ry = trees.numbers("ref_y_m"), dbh = trees.numbers("dbh_cm"), ref = trees.numbers("ref_dbh_cm");
  const auto &kind = trees.texts("kind"), &name = trees.texts("ref_tree"), &against = trees.texts("against");
  for (std::size_t i = 0; i < trees.rows(); ++i) {
    const auto k =
        static_cast<std::size_t>(std::ranges::find(runs, static_cast<std::size_t>(run[i] - 1)) - runs.begin());
    if (kind[i] != "matched" || k == runs.size()) continue;
    auto& place = places[{rx[i], ry[i]}];
    place.stems.resize(runs.size());
    place.name = name[i];
    place.reference = {rx[i], ry[i]};
    place.reference_dbh_m = against[i] == "reference" ? ref[i] / 100 : no_number;
    place.stems[k] = {true, {x[i], y[i]}, dbh[i] / 100};
    if (against[i] != "reference") place.stems[0] = {true, {rx[i], ry[i]}, ref[i] / 100};
  }
  return places;
}

double usual_dbh(const ComparedPlace& p) {
  if (std::isfinite(p.reference_dbh_m)) return p.reference_dbh_m;
  for (const auto& s : p.stems)
    if (s.found && std::isfinite(s.dbh_m)) return s.dbh_m;
  return 0;
}

std::vector<float> heights_of(const PointCloud& cloud) {
  if (!cloud.has(arrays::height_above_ground)) return {};
  const auto& column = cloud.column(arrays::height_above_ground.name);
  std::vector<float> heights(cloud.size());
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = static_cast<float>(column_value(column, i));
  return heights;
}

// What is drawn of the plot: its boundary with a margin, else everything.
io::CloudReadOptions part_of(const PlotArea& area) {
  io::CloudReadOptions options;
  const auto outline = area.outline();
  if (outline.empty()) return options;
  Eigen::Vector2d lo = outline.front(), hi = lo;
  for (const auto& p : outline) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  options.bounds =
      fmt::format("{},{},{},{}", lo.x() - margin_m, lo.y() - margin_m, hi.x() + margin_m, hi.y() + margin_m);
  return options;
}

render::PlanDensity density_of(const PointCloud& cloud) {
  Eigen::Vector2d lo = Eigen::Vector2d::Constant(1e300), hi = -lo;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector2d p = cloud.position(i).head<2>();
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  if (cloud.empty()) return {};
  auto plan = render::plan_density(lo, hi, 0.03);
  for (std::size_t i = 0; i < cloud.size(); ++i) plan.add(cloud.position(i).head<2>());
  return plan;
}

PointCloud slice_of(const PointCloud& cloud, const std::vector<ComparedPlace>& places, double breast_height_m) {
  const auto heights = heights_of(cloud);
  std::vector<std::uint32_t> picked;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::abs(heights[i] - breast_height_m) > half_slice_m) continue;
    const Eigen::Vector2d p = cloud.position(i).head<2>();
    if (std::ranges::any_of(places,
                            [&](const ComparedPlace& place) { return (p - place.reference).norm() < margin_m; }))
      picked.push_back(static_cast<std::uint32_t>(i));
  }
  return cloud.subset(picked);
}

}  // namespace

std::vector<ComparedPlace> compared_places(const Table& trees, const std::vector<std::size_t>& runs, int most) {
  std::vector<ComparedPlace> all;
  for (auto& [at, place] : places_of(trees, runs)) all.push_back(std::move(place));
  const auto found_in = [](const ComparedPlace& p) {
    return std::ranges::count(p.stems, true, &ComparedPlace::Stem::found);
  };
  std::ptrdiff_t best = 0;
  for (const auto& p : all) best = std::max(best, found_in(p));
  std::erase_if(all, [&](const ComparedPlace& p) { return found_in(p) < best; });
  std::ranges::stable_sort(all, {}, usual_dbh);
  std::vector<ComparedPlace> out;
  const auto n = std::min(all.size(), static_cast<std::size_t>(std::max(0, most)));
  for (std::size_t k = 0; k < n; ++k) out.push_back(all[(2 * k + 1) * all.size() / (2 * n)]);
  return out;
}

std::vector<CompareCloud> read_compare_clouds(const Table& runs, const std::vector<std::size_t>& of,
                                              const std::vector<ComparedPlace>& places, const PlotArea& area,
                                              const Run& run) {
  std::vector<CompareCloud> out(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) {
    run.check_cancel();
    const auto& file = runs.texts("cloud")[of[k]];
    if (file.empty()) continue;
    const auto cloud = io::read_cloud(file, part_of(area), run).cloud;
    if (k == 0) out[k].density = density_of(cloud);
    out[k].slice = slice_of(cloud, places, runs.numbers("breast_height_m")[of[k]]);
  }
  return out;
}

std::vector<render::ComparedTree> compared_slices(const std::vector<CompareCloud>& clouds,
                                                  const std::vector<ComparedPlace>& places,
                                                  const std::vector<std::size_t>& runs) {
  std::vector<render::ComparedTree> out;
  for (const auto& place : places) out.push_back({place.name, place.reference_dbh_m, {}});
  bool any = false;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Table stems;
    std::vector<double> x, y, dbh;
    for (const auto& place : places) {
      const auto& s = place.stems[k];
      x.push_back(s.found ? s.at.x() : place.reference.x());
      y.push_back(s.found ? s.at.y() : place.reference.y());
      dbh.push_back(s.found ? 100 * s.dbh_m : no_number);
    }
    stems.set("x_m", std::move(x));
    stems.set("y_m", std::move(y));
    stems.set("dbh_cm", std::move(dbh));
    auto panels = render::slice_panels(stems, clouds[k].slice, max_panel_points);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& s = places[i].stems[k];
      any = any || panels[i].found > 0;
      const Eigen::Vector2d to_reference =
          s.found ? Eigen::Vector2d(places[i].reference - s.at) : Eigen::Vector2d::Zero();
      out[i].slices.push_back({std::move(panels[i]), s.found, to_reference});
    }
  }
  return any ? out : std::vector<render::ComparedTree>();
}

}  // namespace bole::report
