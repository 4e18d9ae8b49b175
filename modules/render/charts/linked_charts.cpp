#include "render/charts/linked_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cloud/stem_rows.h"
#include "render/charts/columns.h"
#include "render/charts/dbh_charts.h"
#include "render/charts/row_profile.h"
#include "render/draw/axes.h"

namespace bole::render {
namespace {

constexpr double class_cm = 4, dot_mm = 0.8;
const Color chosen = hex(0x0073e6);  // the colour of the selected tree in all views

Frame frame_for(const ChartSize& size, const Interval& x, const Interval& y) {
  return {{axis_space_left_mm, 3, size.width_mm - 3, size.height_mm - axis_space_below_mm}, x, y};
}

Figure sheet(const std::string& name, const ChartSize& size) {
  Figure figure;
  figure.name = name;
  figure.width_mm = size.width_mm;
  figure.height_mm = size.height_mm;
  return figure;
}

Interval range_of(const std::vector<double>& values, double least) {
  double hi = least;
  for (const double v : values) hi = std::max(hi, v);
  return nice_interval({0, 1.05 * hi}, 5);
}

struct Dot {
  std::int64_t tree = 0;
  double x = 0, y = 0;
  Color color;
  bool hollow = false;
};

void draw_linked_dots(Canvas& canvas, const Frame& frame, const std::vector<Dot>& dots,
                      std::optional<std::int64_t> selected) {
  for (const auto& dot : dots)
    canvas.circle(frame.map(dot.x, dot.y), dot_mm, dot.hollow ? ink::paper : dot.color.with_alpha(0.8),
                  Stroke{dot.hollow ? dot.color : ink::paper, dot.hollow ? 0.25 : 0.1});
  for (const auto& dot : dots)
    if (selected && dot.tree == *selected) {
      canvas.circle(frame.map(dot.x, dot.y), 1.7, {}, Stroke{chosen, 0.5});
      TextStyle label{7, chosen, true};
      label.halo_mm = 0.4;
      canvas.text(frame.map(dot.x, dot.y) + Eigen::Vector2d(2.3, -0.8), std::to_string(dot.tree), label);
    }
}

std::vector<ChartMark> marks_of(const Frame& frame, const std::vector<Dot>& dots) {
  std::vector<ChartMark> marks;
  for (const auto& dot : dots) {
    const auto p = frame.map(dot.x, dot.y);
    marks.push_back({{dot.tree}, {p.x(), p.y(), p.x(), p.y()}});
  }
  return marks;
}

void say_empty(Canvas& canvas, const std::string& text) {
  canvas.text(canvas.sheet().centre(), text, TextStyle{8, ink::muted}.aligned(HAlign::centre, VAlign::middle));
}

}  // namespace

std::optional<std::int64_t> LinkedChart::tree_at(const Eigen::Vector2d& mm, double reach_mm,
                                                 std::optional<std::int64_t> selected) const {
  const ChartMark* nearest = nullptr;
  for (const auto& mark : marks) {
    const Eigen::Vector2d inside(std::clamp(mm.x(), mark.box.x0, mark.box.x1),
                                 std::clamp(mm.y(), mark.box.y0, mark.box.y1));
    if (const double d = (mm - inside).norm(); d <= reach_mm && !mark.trees.empty()) {
      nearest = &mark;
      reach_mm = d;
    }
  }
  if (nearest == nullptr) return {};
  auto it = selected ? std::ranges::find(nearest->trees, *selected) : nearest->trees.end();
  if (it != nearest->trees.end()) ++it;
  return it == nearest->trees.end() ? nearest->trees.front() : *it;
}

LinkedChart diameter_histogram(const Table& stems, const ChartSize& size, std::optional<std::int64_t> selected) {
  const auto dbh = numbers_or_nan(stems, "dbh_cm");
  const auto ids = stems.integers("tree_id");
  std::map<long, std::vector<std::int64_t>> classes;
  for (std::size_t i = 0; i < dbh.size(); ++i)
    if (std::isfinite(dbh[i])) classes[std::lround(std::floor(dbh[i] / class_cm))].push_back(ids[i]);
  LinkedChart chart{sheet("dbh_histogram", size), {}};
  if (classes.empty()) {
    chart.figure.draw = [](Canvas& canvas) { say_empty(canvas, "No diameters yet"); };
    return chart;
  }
  std::size_t most = 1;
  for (const auto& [k, trees] : classes) most = std::max(most, trees.size());
  const double lo = static_cast<double>(classes.begin()->first) * class_cm,
               hi = static_cast<double>(classes.rbegin()->first + 1) * class_cm;
  const Frame frame = frame_for(size, {lo - 0.3 * class_cm, hi + 0.3 * class_cm},
                                {0, std::max(nice_interval({0, 1.05 * static_cast<double>(most)}, 5).hi, 2.0)});
  std::optional<std::size_t> chosen_bar;
  for (const auto& [k, trees] : classes) {
    const double x = static_cast<double>(k) * class_cm;
    const auto a = frame.map(x + 0.04 * class_cm, static_cast<double>(trees.size())),
               b = frame.map(x + 0.96 * class_cm, 0);
    if (selected && std::ranges::find(trees, *selected) != trees.end()) chosen_bar = chart.marks.size();
    chart.marks.push_back({trees, {a.x(), a.y(), b.x(), b.y()}});
  }
  chart.figure.draw = [frame, chosen_bar, marks = chart.marks](Canvas& canvas) {
    const AxesStyle axes{"DBH (cm)", "Stems"};
    draw_grid(canvas, frame, axes);
    for (std::size_t i = 0; i < marks.size(); ++i)
      canvas.rectangle(marks[i].box, chosen_bar == i ? chosen : mix(ink::paper, ink::primary, 0.6));
    draw_axes(canvas, frame, axes);
  };
  return chart;
}

LinkedChart height_over_diameter(const Table& stems, const ChartSize& size, std::optional<std::int64_t> selected) {
  const auto dbh = numbers_or_nan(stems, "dbh_cm"), height = known_heights(stems),
             seen = numbers_or_nan(stems, "height_seen");
  const auto ids = stems.integers("tree_id");
  const auto quality = texts_or_empty(stems, "quality");
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (std::isfinite(dbh[i] + height[i]))
      dots.push_back({ids[i], dbh[i], height[i], quality_color(quality[i]), seen[i] == 0});
  LinkedChart chart{sheet("height_over_diameter", size), {}};
  if (dots.empty()) {
    chart.figure.draw = [](Canvas& canvas) { say_empty(canvas, "No heights yet"); };
    return chart;
  }
  std::vector<double> xs, ys;
  for (const auto& dot : dots) {
    xs.push_back(dot.x);
    ys.push_back(dot.y);
  }
  const Frame frame = frame_for(size, range_of(xs, 10), range_of(ys, 5));
  chart.marks = marks_of(frame, dots);
  chart.figure.draw = [frame, dots, selected](Canvas& canvas) {
    const AxesStyle axes{"DBH (cm)", "Height (m)"};
    draw_grid(canvas, frame, axes);
    draw_linked_dots(canvas, frame, dots, selected);
    draw_axes(canvas, frame, axes);
  };
  return chart;
}

LinkedChart estimated_over_field(const Table& matches, const ChartSize& size, std::optional<std::int64_t> selected) {
  std::vector<Dot> dots;
  std::vector<double> estimate, reference;
  if (matches.has("kind") && matches.has("tree_id")) {
    const auto kind = texts_or_empty(matches, "kind");
    const auto dbh = numbers_or_nan(matches, "dbh_cm"), field = numbers_or_nan(matches, "ref_dbh_cm"),
               ids = matches.numbers("tree_id");
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (kind[i] == "matched" && std::isfinite(dbh[i] + field[i] + ids[i])) {
        dots.push_back({static_cast<std::int64_t>(ids[i]), field[i], dbh[i], ink::primary, false});
        estimate.push_back(dbh[i]);
        reference.push_back(field[i]);
      }
  }
  LinkedChart chart{sheet("estimated_over_field", size), {}};
  if (dots.empty()) {
    chart.figure.draw = [](Canvas& canvas) { say_empty(canvas, "No field measurements are matched"); };
    return chart;
  }
  auto all = estimate;
  all.insert(all.end(), reference.begin(), reference.end());
  const auto [lo, hi] = std::ranges::minmax(all);
  const Interval range = nice_interval(Interval{lo, hi}.grown(0.05), 6);
  const Frame frame = frame_for(size, range, range);
  chart.marks = marks_of(frame, dots);
  const auto s = error_statistics(estimate, reference);
  chart.figure.draw = [frame, range, dots, selected, s](Canvas& canvas) {
    const AxesStyle axes{"Field DBH (cm)", "Estimated DBH (cm)"};
    draw_grid(canvas, frame, axes);
    canvas.line(frame.map(range.lo, range.lo), frame.map(range.hi, range.hi), Stroke{ink::muted, 0.25, {1.4, 1.0}});
    draw_linked_dots(canvas, frame, dots, selected);
    draw_axes(canvas, frame, axes);
    canvas.text(
        {frame.box.x0 + 2, frame.box.y0 + 1.5},
        "n " + std::to_string(s.count) + "   bias " + fixed(s.bias, 2) + " cm   RMSE " + fixed(s.rmse, 2) + " cm",
        TextStyle{7}.aligned(HAlign::left, VAlign::top));
  };
  return chart;
}

std::span<const ChartType> linked_charts() {
  static const Table no_table;
  static constexpr ChartType charts[] = {
      {"diameters", "Diameters",
       [](const ChartTables& tables, const ChartSize& size, SelectedTree selected) {
         return tables.stems ? diameter_histogram(*tables.stems, size, selected) : LinkedChart();
       }},
      {"heights", "Height over diameter",
       [](const ChartTables& tables, const ChartSize& size, SelectedTree selected) {
         return tables.stems ? height_over_diameter(*tables.stems, size, selected) : LinkedChart();
       }},
      {"field", "Estimated over field",
       [](const ChartTables& tables, const ChartSize& size, SelectedTree selected) {
         return estimated_over_field(tables.matches ? *tables.matches : no_table, size, selected);
       }},
      {"plant_distances", "Distances between plants",
       [](const ChartTables& tables, const ChartSize& size, SelectedTree selected) {
         return plant_distances({tables.row.begin(), tables.row.end()}, size, selected);
       }},
  };
  return charts;
}

}  // namespace bole::render
