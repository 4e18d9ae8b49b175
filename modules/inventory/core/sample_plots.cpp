#include "inventory/core/sample_plots.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/option_text.h"
#include "base/random.h"
#include "inventory/core/measures.h"

namespace bole::inventory {

namespace {

constexpr std::uint64_t place_stream = 41, distance_stream = 42;

struct Tree {
  Eigen::Vector2d at;  // in axes along the sides of the stand, from its middle
  double basal_area_m2;
};

// The trees of the stand that count, in axes of its own.
struct Stand {
  double width_m, length_m;
  Eigen::Vector2d centre;
  double bearing_rad;
  std::vector<Tree> trees;

  double area_m2() const { return width_m * length_m; }
  Eigen::Vector2d outside(const Eigen::Vector2d& p) const { return Eigen::Rotation2Dd(-bearing_rad) * p + centre; }
};

Stand rectangular_stand(const Table& stems, const CountingRule& rule) {
  if (rule.area.shape != PlotArea::Shape::rectangle)
    throw bad_input("the stand is no rectangle", "a rectangle around all trees that are known",
                    "Set width and length of survey.plot");
  Stand stand{rule.area.width_m, rule.area.length_m, rule.area.centre, rule.area.bearing_rad, {}};
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Eigen::Vector2d p(x[i], y[i]);
    if (!p.allFinite() || !std::isfinite(dbh[i]) || !rule.counts(p, dbh[i])) continue;
    stand.trees.push_back({Eigen::Rotation2Dd(stand.bearing_rad) * (p - stand.centre), basal_area_m2(dbh[i])});
  }
  if (stand.trees.empty())
    throw bad_input(fmt::format("none of {} stems is in the stand", stems.rows()), "trees that count",
                    "Look at the place and size of the stand and at min_dbh");
  return stand;
}

std::vector<double> radii_of(const std::string& list, const Stand& stand) {
  std::string words = list;
  std::ranges::replace(words, ',', ' ');
  std::istringstream stream(words);
  std::vector<double> radii;
  const double most = std::min(stand.width_m, stand.length_m) / 2;
  for (std::string word; stream >> word;) {
    const double radius = number_from_text(word).value_or(0);
    if (!(radius > 0) || !(radius < most))
      throw bad_input("radii is '" + list + "': '" + word + "' is no radius",
                      fmt::format("numbers of metres below {:g}, so that a plot fits into the stand", most),
                      "Write for instance \"5 10\"");
    radii.push_back(radius);
  }
  if (radii.empty()) throw bad_input("radii is empty", "at least one radius in metres", "Write for instance \"5 10\"");
  return radii;
}

struct Counted {
  double stems = 0, basal_area_m2 = 0;
};

struct PlotResult {
  Eigen::Vector2d at;
  double inside = 1;  // share of its area
  Counted counted;
  double stems_per_ha = 0, basal_area_per_ha = 0;
};

class Sampler {
 public:
  Sampler(const Stand& stand, const SampleOptions& options) : stand_(stand), o_(options) {}

  PlotResult plot(int number, double radius_m, EdgeMethod edge) const {
    Random random(static_cast<std::uint64_t>(o_.seed), place_stream, static_cast<std::uint64_t>(number));
    const double margin = edge == EdgeMethod::inside ? radius_m : 0;
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
    PlotResult plot;
    plot.at = {u * (stand_.width_m / 2 - margin), v * (stand_.length_m / 2 - margin)};
    const double whole = std::numbers::pi * radius_m * radius_m;
    plot.inside = circle_in_rectangle_m2(plot.at, radius_m, stand_.width_m, stand_.length_m) / whole;
    plot.counted = counted(number, plot.at, radius_m);
    if (edge == EdgeMethod::mirage)
      for (const auto& image : images(plot.at, radius_m)) {
        const auto again = counted(number, image, radius_m);
        plot.counted.stems += again.stems;
        plot.counted.basal_area_m2 += again.basal_area_m2;
      }
    const double area = edge == EdgeMethod::area ? plot.inside * whole : whole;
    plot.stems_per_ha = plot.counted.stems / area * m2_per_ha;
    plot.basal_area_per_ha = plot.counted.basal_area_m2 / area * m2_per_ha;
    return plot;
  }

 private:
  Counted counted(int number, const Eigen::Vector2d& centre, double radius_m) const {
    Counted sum;
    for (std::size_t i = 0; i < stand_.trees.size(); ++i) {
      const auto& tree = stand_.trees[i];
      double distance = (tree.at - centre).norm() + o_.distance_bias;
      if (o_.distance_sd > 0)
        distance += o_.distance_sd * Random(static_cast<std::uint64_t>(o_.seed), distance_stream,
                                            static_cast<std::uint64_t>(number) * 1'000'003 + i)
                                         .normal();
      if (distance > radius_m) continue;
      sum.stems += 1;
      sum.basal_area_m2 += tree.basal_area_m2;
    }
    return sum;
  }

  // Centres of the mirror images of a plot that reaches beyond sides or corners.
  std::vector<Eigen::Vector2d> images(const Eigen::Vector2d& at, double radius_m) const {
    const auto mirrored = [&](double c, double half) {
      if (c + radius_m > half) return 2 * half - c;
      if (c - radius_m < -half) return -2 * half - c;
      return std::nan("");
    };
    const double x = mirrored(at.x(), stand_.width_m / 2), y = mirrored(at.y(), stand_.length_m / 2);
    std::vector<Eigen::Vector2d> found;
    if (std::isfinite(x)) found.emplace_back(x, at.y());
    if (std::isfinite(y)) found.emplace_back(at.x(), y);
    if (std::isfinite(x) && std::isfinite(y)) found.emplace_back(x, y);
    return found;
  }

  const Stand& stand_;
  const SampleOptions& o_;
};

// Mean and standard deviation (n - 1) of single plots, beside the truth, in percent of it.
struct Scatter {
  double mean = 0, bias_pct = 0, bias_se_pct = 0, sd_pct = 0;
};

Scatter scatter_of(const std::vector<double>& values, double truth) {
  const double n = static_cast<double>(values.size());
  Scatter s;
  for (const double v : values) s.mean += v / n;
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  const double sd = std::sqrt(squares / (n - 1));
  s.bias_pct = 100 * (s.mean - truth) / truth;
  s.sd_pct = 100 * sd / truth;
  s.bias_se_pct = s.sd_pct / std::sqrt(n);
  return s;
}

class Tables {
 public:
  void add_plot(double radius_m, EdgeMethod edge, const Stand& stand, const PlotResult& p) {
    const auto at = stand.outside(p.at);
    plots_.edge.emplace_back(choice_name(edge));
    plots_.add({{"radius_m", radius_m},
                {"x_m", at.x()},
                {"y_m", at.y()},
                {"inside_pct", 100 * p.inside},
                {"stems", p.counted.stems},
                {"stems_per_ha", p.stems_per_ha},
                {"basal_area_m2_per_ha", p.basal_area_per_ha}});
  }
  void add_summary(double radius_m, EdgeMethod edge, const std::vector<PlotResult>& plots, const Stand& stand) {
    std::vector<double> stems, basal_area;
    double partial = 0, squares = 0, basal = 0;
    for (const auto& p : plots) {
      stems.push_back(p.stems_per_ha);
      basal_area.push_back(p.basal_area_per_ha);
      partial += p.inside < 1 - 1e-9 ? 100.0 / static_cast<double>(plots.size()) : 0;
    }
    for (const auto& tree : stand.trees) {
      basal += tree.basal_area_m2;
      squares += tree.basal_area_m2 * tree.basal_area_m2;
    }
    const double per_ha = m2_per_ha / stand.area_m2(), share = std::numbers::pi * radius_m * radius_m / stand.area_m2();
    const double n = static_cast<double>(stand.trees.size());
    summary_.edge.emplace_back(choice_name(edge));
    summary_.add({{"radius_m", radius_m}, {"plots", static_cast<double>(plots.size())}, {"partial_pct", partial}});
    add_measure("stems_per_ha", n * per_ha, scatter_of(stems, n * per_ha), 100 / std::sqrt(share * n));
    add_measure("basal_area_m2_per_ha", basal * per_ha, scatter_of(basal_area, basal * per_ha),
                100 * std::sqrt(squares / share) / basal);
  }
  void move_to(SampleStudy& study) && {
    study.summary = std::move(summary_).table();
    study.plots = std::move(plots_).table();
  }

 private:
  struct Rows {
    std::vector<std::string> edge;
    std::vector<std::pair<std::string, std::vector<double>>> columns;
    void add(const std::vector<std::pair<std::string, double>>& values) {
      for (const auto& [name, value] : values) {
        auto it = std::ranges::find(columns, name, &std::pair<std::string, std::vector<double>>::first);
        if (it == columns.end()) it = columns.insert(columns.end(), {name, {}});
        it->second.push_back(value);
      }
    }
    Table table() && {
      Table t;
      t.set(columns.front().first, std::move(columns.front().second));
      t.set("edge", std::move(edge));
      for (std::size_t i = 1; i < columns.size(); ++i) t.set(columns[i].first, std::move(columns[i].second));
      return t;
    }
  };
  void add_measure(const std::string& name, double truth, const Scatter& s, double poisson_pct) {
    summary_.add({{name + "_true", truth},
                  {name + "_mean", s.mean},
                  {name + "_bias_pct", s.bias_pct},
                  {name + "_bias_se_pct", s.bias_se_pct},
                  {name + "_sd_pct", s.sd_pct},
                  {name + "_poisson_sd_pct", poisson_pct}});
  }
  Rows summary_, plots_;
};

// Integral of sqrt(r^2 - x^2) from 0 to x, |x| <= r.
double under_arc(double r, double x) {
  const double s = std::clamp(x / r, -1.0, 1.0);
  return r * r / 2 * (s * std::sqrt(std::max(0.0, 1 - s * s)) + std::asin(s));
}

// Area of the quarter {x' <= x, y' <= y} of a circle about the origin.
double corner_area(double r, double x, double y) {
  x = std::clamp(x, -r, r);
  y = std::clamp(y, -r, r);
  // Over x' from -r to x the height is that of the chord below y: min(y, c) + c, where y > -c.
  const double reach = std::sqrt(std::max(0.0, r * r - y * y));  // the line y meets the circle at +-reach
  const auto chord = [&](double from, double to) { return to > from ? under_arc(r, to) - under_arc(r, from) : 0; };
  const double middle_from = -reach, middle_to = std::min(x, reach);
  double area = 0;
  if (middle_to > middle_from) area += y * (middle_to - middle_from) + chord(middle_from, middle_to);
  if (y > 0) area += 2 * chord(-r, std::min(x, -reach)) + 2 * chord(reach, x);
  return area;
}

}  // namespace

double circle_in_rectangle_m2(const Eigen::Vector2d& centre, double radius_m, double width_m, double length_m) {
  const double x0 = -width_m / 2 - centre.x(), x1 = width_m / 2 - centre.x(), y0 = -length_m / 2 - centre.y(),
               y1 = length_m / 2 - centre.y(), r = radius_m;
  return corner_area(r, x1, y1) - corner_area(r, x0, y1) - corner_area(r, x1, y0) + corner_area(r, x0, y0);
}

SampleStudy sample_plots(const Table& stems, const CountingRule& rule, const SampleOptions& o, const Run& run) {
  const Stand stand = rectangular_stand(stems, rule);
  const auto radii = radii_of(o.radii, stand);
  const Sampler sampler(stand, o);
  Tables tables;
  constexpr std::array edges{EdgeMethod::ignore, EdgeMethod::inside, EdgeMethod::area, EdgeMethod::mirage};
  std::size_t done = 0;
  for (const double radius : radii)
    for (const auto edge : edges) {
      run.report(static_cast<double>(done++) / static_cast<double>(radii.size() * edges.size()), "sampling");
      std::vector<PlotResult> plots;
      for (int i = 0; i < o.plots; ++i) {
        if (i % 256 == 0) run.check_cancel();
        plots.push_back(sampler.plot(i, radius, edge));
        tables.add_plot(radius, edge, stand, plots.back());
      }
      tables.add_summary(radius, edge, plots, stand);
    }
  SampleStudy study;
  std::move(tables).move_to(study);
  auto& report = study.report;
  report.counts["trees"] = static_cast<std::int64_t>(stand.trees.size());
  report.counts["plots"] = static_cast<std::int64_t>(study.plots.rows());
  report.metrics["stand_area"] = {stand.area_m2(), Unit::square_metre};
  report.message = fmt::format("{} plots of {} sizes in {} trees on {:.0f} m2", study.plots.rows(), radii.size(),
                               stand.trees.size(), stand.area_m2());
  return study;
}

}  // namespace bole::inventory
