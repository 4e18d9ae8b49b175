#include "report/compare/compare_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "cloud/table_columns.h"
#include "render/charts/dbh_charts.h"
#include "render/charts/position_charts.h"
#include "render/charts/slice_pairs.h"
#include "render/charts/trajectory_charts.h"
#include "render/maps/paths_on_cloud.h"
#include "render/maps/position_map.h"
#include "report/compare/compare_clouds.h"
#include "report/compare/loop_figure.h"

namespace bole::report {
namespace {

// A series of a figure with the table that it is drawn from.
struct Series {
  std::string name;
  render::Color color;
  std::shared_ptr<const Table> trees;
};

std::vector<std::size_t> rows_where(const Table& table, const std::function<bool(std::size_t)>& keep) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (keep(i)) rows.push_back(i);
  return rows;
}

std::vector<render::MatchGroup> groups_of(const std::vector<Series>& all) {
  std::vector<render::MatchGroup> groups;
  for (const auto& s : all) groups.push_back({s.name, s.color, s.trees.get()});
  return groups;
}

class Figures {
 public:
  Figures(const CompareData& data, const CompareReportOptions& options, const Run& run)
      : d_(data), o_(options), run_(run) {
    for (std::size_t i = 0; i < d_.compared->rows(); ++i) {
      const auto& plot = d_.compared->texts("plot")[i];
      if (std::ranges::find(plots_, plot) == plots_.end()) plots_.push_back(plot);
      if (d_.compared->integers("agrees")[i] != 0) agrees_.insert(static_cast<std::int64_t>(i) + 1);
    }
    against_ = against();
  }

  std::vector<ComparePlan> plans() {
    const auto pooled = series({});
    if (has_matches(pooled)) add_errors(pooled, "");
    for (std::size_t k = 0; k < plots_.size(); ++k) {
      const auto of_plot = series(plots_[k]);
      const std::string suffix = plots_.size() > 1 ? fmt::format("_{}", k + 1) : std::string();
      if (plots_.size() > 1 && has_matches(of_plot)) add_errors(of_plot, suffix, plots_[k]);
      if (!of_plot.empty()) add_map(of_plot, suffix, plots_[k]);
      add_clouds(plots_[k], suffix);
      add_loops(plots_[k], suffix);
    }
    return std::move(plans_);
  }

 private:
  // A run where the figures hold no errors against a reference.
  std::string against() const {
    std::set<std::string> all;
    for (const auto& text : d_.trees->texts("against")) all.insert(text);
    if (all.empty() || all.contains("reference")) return {};
    return all.size() == 1 ? *all.begin() : "the first run";
  }

  // The trees of one plot by run, of all plots by system; lists that disagree with their reference are left out.
  std::vector<Series> series(const std::string& plot) const {
    const auto& plots = d_.trees->texts("plot");
    const auto& names = d_.trees->texts(plot.empty() && plots_.size() > 1 ? "system" : "name");
    const auto runs = d_.trees->integers("run");
    std::vector<Series> out;
    std::vector<std::string> order;
    for (std::size_t i = 0; i < d_.trees->rows(); ++i)
      if ((plot.empty() || plots[i] == plot) && agrees_.contains(runs[i]) &&
          std::ranges::find(order, names[i]) == order.end())
        order.push_back(names[i]);
    for (std::size_t k = 0; k < order.size(); ++k)
      out.push_back({order[k], render::series_color(k),
                     std::make_shared<Table>(d_.trees->subset(rows_where(*d_.trees, [&](std::size_t i) {
                       return names[i] == order[k] && (plot.empty() || plots[i] == plot) && agrees_.contains(runs[i]);
                     })))});
    return out;
  }

  static bool has_matches(const std::vector<Series>& all) {
    return std::ranges::any_of(all, [](const Series& s) {
      const auto& kind = s.trees->texts("kind");
      return std::ranges::find(kind, "matched") != kind.end();
    });
  }

  void add(const std::string& what, const std::string& suffix, const std::string& plot,
           const std::function<std::vector<render::Figure>()>& make) {
    plans_.push_back({what + (plot.empty() ? "" : " of " + plot), [=] {
                        auto figures = make();
                        for (auto& f : figures) {
                          f.name += suffix;
                          if (!plot.empty()) f.title += ": " + plot;
                        }
                        return figures;
                      }});
  }

  void add_errors(const std::vector<Series>& all, const std::string& suffix, const std::string& plot = {}) {
    const double half = 0.55 * o_.figure_width;
    add("position errors", suffix, plot,
        [all, half] { return std::vector{render::position_errors(groups_of(all), half)}; });
    add("diameters", suffix, plot,
        [all, half, against = against_] { return std::vector{render::dbh_scatter(groups_of(all), half, against)}; });
    add("diameter errors", suffix, plot,
        [all, half] { return std::vector{render::dbh_error_boxes(groups_of(all), half)}; });
  }

  void add_map(const std::vector<Series>& all, const std::string& suffix, const std::string& plot) {
    add("positions", suffix, plots_.size() > 1 ? plot : "", [all, this, plot] {
      return std::vector{render::position_map(groups_of(all), area_of(plot), o_.figure_width, o_.enlarge.value_or(0))};
    });
  }

  std::vector<std::size_t> runs_of(const std::string& plot) const {
    return rows_where(*d_.compared, [&](std::size_t i) { return d_.compared->texts("plot")[i] == plot; });
  }

  // The boundary of the first run of a plot that has one.
  PlotArea area_of(const std::string& plot) const {
    PlotArea area;
    if (d_.boundaries == nullptr) return area;
    const auto run = d_.boundaries->integers("run");
    const auto x = d_.boundaries->numbers("x_m"), y = d_.boundaries->numbers("y_m");
    for (const auto r : runs_of(plot)) {
      std::vector<Eigen::Vector2d> vertices;
      for (std::size_t i = 0; i < run.size(); ++i)
        if (run[i] == static_cast<std::int64_t>(r) + 1) vertices.emplace_back(x[i], y[i]);
      if (vertices.size() > 2) return polygon_area(std::move(vertices));
    }
    return area;
  }

  static Trajectory path_of(const Table* poses, std::size_t run) {
    Trajectory path;
    if (poses == nullptr || poses->rows() == 0) return path;
    const auto runs = poses->integers("run");
    const auto t = poses->numbers("time_s"), x = poses->numbers("x_m"), y = poses->numbers("y_m"),
               z = poses->numbers("z_m");
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i] != static_cast<std::int64_t>(run) + 1) continue;
      StampedPose pose;
      pose.time_s = t[i];
      pose.T_target_sensor.translation() = Eigen::Vector3d(x[i], y[i], z[i]);
      path.poses.push_back(pose);
    }
    return path;
  }

  std::vector<render::ComparedPath> paths_of(const std::vector<std::size_t>& runs) const {
    std::vector<render::ComparedPath> paths;
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (auto path = path_of(d_.poses, runs[k]); path.poses.size() > 1)
        paths.push_back({d_.compared->texts("name")[runs[k]], render::series_color(k), std::move(path)});
    return paths;
  }

  // Of the first of these runs that carries one.
  Trajectory reference_of(const std::vector<std::size_t>& runs) const {
    for (const auto r : runs)
      if (auto path = path_of(d_.reference_poses, r); path.poses.size() > 1) return path;
    return {};
  }

  bool in_plot_axes(const std::vector<std::size_t>& runs) const {
    return std::ranges::all_of(runs, [&](std::size_t r) {
      const auto& axes = d_.runs->texts("axes")[r];
      return axes == "plot" || axes == "global";
    });
  }

  void add_clouds(const std::string& plot, const std::string& suffix) {
    if (!o_.cloud_figures) return;
    const auto runs = runs_of(plot);
    const std::string named = plots_.size() > 1 ? plot : "";
    // Read once for both figures, by the first of them.
    auto clouds = std::make_shared<std::vector<CompareCloud>>();
    auto trees = std::make_shared<std::vector<ComparedPlace>>(compared_places(*d_.trees, runs, o_.slices));
    const auto read = [this, clouds, trees, runs, plot] {
      if (clouds->empty()) *clouds = read_compare_clouds(*d_.runs, runs, *trees, area_of(plot), run_);
    };
    add("paths on the cloud", suffix, named, [this, clouds, runs, read] {
      auto paths = paths_of(runs);
      if (paths.empty()) return std::vector<render::Figure>();
      const Trajectory truth = reference_of(runs);
      if (in_plot_axes(runs)) {
        read();
        if (!truth.empty()) paths.push_back({"reference", render::ink::text, truth});
        return std::vector{render::paths_on_cloud(paths, clouds->front().density, o_.figure_width)};
      }
      // Maps without targets have axes of their own: the cloud of one would not fit the path of another.
      const Trajectory& common = truth.empty() ? paths.front().path : truth;
      for (auto& p : paths) p.path = render::aligned_to(p.path, common);
      if (!truth.empty()) paths.push_back({"reference", render::ink::text, truth});
      auto figure = render::paths_on_cloud(paths, {}, o_.figure_width);
      figure.title = "Paths of the scanner";
      figure.caption = std::string("The path of each run from above, aligned with ") +
                       (truth.empty() ? "that of the first run" : "the reference") + " by the best rigid motion.";
      return std::vector{std::move(figure)};
    });
    add("slices", suffix, named, [this, clouds, trees, runs, read] {
      if (trees->empty()) return std::vector<render::Figure>();
      read();
      std::vector<render::SliceRun> names;
      for (std::size_t k = 0; k < runs.size(); ++k)
        names.push_back({d_.compared->texts("name")[runs[k]], render::series_color(k)});
      const auto slices = compared_slices(*clouds, *trees, runs);
      if (slices.empty()) return std::vector<render::Figure>();
      return std::vector{render::slices_side_by_side(names, slices, o_.figure_width)};
    });
  }

  // Where a run has closed loops: what they did to path and map, beside the other runs.
  void add_loops(const std::string& plot, const std::string& suffix) {
    const auto runs = runs_of(plot);
    if (!o_.cloud_figures || runs.size() < 2 || !any_loops(d_, runs)) return;
    add("loop closures", suffix, plots_.size() > 1 ? plot : "", [this, runs] {
      std::vector<ComparedRunPath> paths;
      for (const auto r : runs)
        if (auto path = path_of(d_.poses, r); path.poses.size() > 1)
          paths.push_back({r, render::series_color(paths.size()), std::move(path)});
      if (paths.size() < 2) return std::vector<render::Figure>();
      return std::vector{
          loop_figure(d_, std::move(paths), reference_of(runs), in_plot_axes(runs), o_.figure_width, run_)};
    });
  }

  const CompareData& d_;
  const CompareReportOptions& o_;
  const Run& run_;
  std::vector<std::string> plots_;
  std::set<std::int64_t> agrees_;
  std::string against_;
  std::vector<ComparePlan> plans_;
};

}  // namespace

std::vector<ComparePlan> compare_figures(const CompareData& data, const CompareReportOptions& options, const Run& run) {
  const auto figures = std::make_shared<Figures>(data, options, run);
  auto plans = figures->plans();
  for (auto& plan : plans)
    plan.make = [figures, make = std::move(plan.make)] { return make(); };  // keeps what it draws
  return plans;
}

}  // namespace bole::report
