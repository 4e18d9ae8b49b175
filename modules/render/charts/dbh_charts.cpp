#include "render/charts/dbh_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "base/option.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

struct Pairs {
  std::vector<double> estimate, reference;
};

Pairs matched_pairs(const Table& matches) {
  Pairs pairs;
  const auto kind = texts_or_empty(matches, "kind");
  const auto dbh = numbers_or_nan(matches, "dbh_cm"), ref = numbers_or_nan(matches, "ref_dbh_cm");
  for (std::size_t i = 0; i < matches.rows(); ++i)
    if ((kind[i] == "matched" || kind[i].empty()) && std::isfinite(dbh[i]) && std::isfinite(ref[i])) {
      pairs.estimate.push_back(dbh[i]);
      pairs.reference.push_back(ref[i]);
    }
  return pairs;
}

// Linear between order statistics, as most programs do (type 7).
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  return i + 1 < sorted.size() ? std::lerp(sorted[i], sorted[i + 1], at - static_cast<double>(i)) : sorted.back();
}

void draw_statistics(Canvas& canvas, const Eigen::Vector2d& at, const std::vector<std::string>& lines, HAlign h) {
  double y = at.y();
  for (const auto& line : lines) {
    canvas.text({at.x(), y}, line, TextStyle{7.5}.aligned(h, VAlign::top));
    y += 3.9;
  }
}

struct Series {
  std::string name;
  Color color;
  Pairs pairs;
};

std::vector<Series> series_of(const std::vector<MatchGroup>& groups) {
  std::vector<Series> out;
  for (const auto& g : groups) out.push_back({g.name, g.color, matched_pairs(*g.matches)});
  return out;
}

std::vector<std::string> dbh_statistics(const Pairs& pairs) {
  const auto s = error_statistics(pairs.estimate, pairs.reference);
  return {
      "n = " + std::to_string(s.count), "bias = " + fixed(s.bias, 2) + " cm (" + fixed(s.relative_bias_pct, 1) + " %)",
      "RMSE = " + fixed(s.rmse, 2) + " cm (" + fixed(s.relative_rmse_pct, 1) + " %)", "R² = " + fixed(s.r_squared, 3)};
}

void draw_dbh_scatter(Canvas& canvas, const std::vector<Series>& all, const std::string& reference_label) {
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& series : all)
    for (const auto* values : {&series.pairs.estimate, &series.pairs.reference})
      for (const double v : *values) range = {std::min(range.lo, v), std::max(range.hi, v)};
  range = nice_interval(range.grown(0.03), 6);
  const double side = canvas.width_mm() - axis_space_left_mm - 3;
  const Frame frame{{axis_space_left_mm, 3, axis_space_left_mm + side, 3 + side}, range, range};
  AxesStyle axes{reference_label, "Estimated DBH (cm)"};
  draw_grid(canvas, frame, axes);
  canvas.line(frame.map(range.lo, range.lo), frame.map(range.hi, range.hi), Stroke{ink::muted, 0.25, {1.4, 1.0}});
  TextStyle beside{7, ink::muted};
  beside.angle_rad = std::numbers::pi / 4;
  canvas.text(frame.map(range.lo, range.lo) + Eigen::Vector2d(4.2, -3), "1:1",
              beside.aligned(HAlign::left, VAlign::baseline));
  for (const auto& series : all)
    for (std::size_t i = 0; i < series.pairs.estimate.size(); ++i)
      canvas.circle(frame.map(series.pairs.reference[i], series.pairs.estimate[i]), 0.75, series.color.with_alpha(0.65),
                    Stroke{ink::paper, 0.1});
  draw_axes(canvas, frame, axes);
  const double x = frame.box.x0 + 2.5;
  double y = frame.box.y0 + 2.2;
  for (const auto& series : all) {
    if (!series.name.empty()) {
      draw_symbol(canvas, Symbol::disc, {x + 1, y + 1.5}, 1.8, series.color);
      canvas.text({x + 3, y}, series.name, TextStyle{7.5, ink::text, true}.aligned(HAlign::left, VAlign::top));
      y += 3.9;
    }
    const auto lines = dbh_statistics(series.pairs);
    draw_statistics(canvas, {series.name.empty() ? x : x + 3, y}, lines, HAlign::left);
    y += 3.9 * static_cast<double>(lines.size()) + 1.2;
  }
}

struct ErrorClass {
  double lo_cm = 0;
  std::vector<double> errors;  // sorted
};

std::vector<ErrorClass> error_classes(const Pairs& pairs, double class_cm) {
  std::map<long, ErrorClass> by_class;
  for (std::size_t i = 0; i < pairs.estimate.size(); ++i) {
    const long k = std::lround(std::floor(pairs.reference[i] / class_cm));
    by_class[k].lo_cm = static_cast<double>(k) * class_cm;
    by_class[k].errors.push_back(pairs.estimate[i] - pairs.reference[i]);
  }
  std::vector<ErrorClass> classes;
  for (auto& [k, c] : by_class) {
    std::sort(c.errors.begin(), c.errors.end());
    classes.push_back(std::move(c));
  }
  return classes;
}

void draw_box(Canvas& canvas, const Frame& frame, double x, const std::vector<double>& errors, const Color& color) {
  const double half = 0.26, q1 = quantile(errors, 0.25), q3 = quantile(errors, 0.75), reach = 1.5 * (q3 - q1);
  const Stroke outline{color, 0.25};
  if (errors.size() >= 4) {
    const double lo = *std::lower_bound(errors.begin(), errors.end(), q1 - reach),
                 hi = *(std::upper_bound(errors.begin(), errors.end(), q3 + reach) - 1);
    canvas.line(frame.map(x, lo), frame.map(x, q1), outline);
    canvas.line(frame.map(x, q3), frame.map(x, hi), outline);
    for (const double end : {lo, hi}) canvas.line(frame.map(x - half / 2, end), frame.map(x + half / 2, end), outline);
    const auto a = frame.map(x - half, q3), b = frame.map(x + half, q1);
    canvas.rectangle({a.x(), a.y(), b.x(), b.y()}, mix(ink::paper, color, 0.18), outline);
  }
  const double median = quantile(errors, 0.5);
  canvas.line(frame.map(x - half, median), frame.map(x + half, median), Stroke{color, 0.55});
  std::vector<Eigen::Vector2d> dots;
  for (std::size_t i = 0; i < errors.size(); ++i)
    dots.push_back(frame.map(x + 0.13 * (static_cast<double>(i * 7 % 5) - 2) / 2, errors[i]));
  canvas.dots(dots, 0.8, ink::text.with_alpha(0.55));
}

// Of the errors, so that panels beside each other have one.
Interval error_range(const std::vector<std::vector<ErrorClass>>& panels) {
  double most = 0.5;
  for (const auto& classes : panels)
    for (const auto& c : classes) most = std::max({most, std::abs(c.errors.front()), std::abs(c.errors.back())});
  return nice_interval({-1.08 * most, 1.08 * most}, 6);
}

void draw_boxes(Canvas& canvas, const Box& box, const std::vector<ErrorClass>& classes,
                const std::vector<double>& starts, double class_cm, const Interval& y, const Color& color) {
  const Frame frame{box, {-0.5, static_cast<double>(starts.size()) - 0.5}, y};
  AxesStyle axes{"Reference DBH class (cm)", "DBH error (cm)"};
  axes.x_axis = false;
  draw_grid(canvas, frame, axes);
  canvas.line(frame.map(frame.x.lo, 0), frame.map(frame.x.hi, 0), Stroke{ink::muted, 0.25});
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double x = static_cast<double>(i);
    const auto c = std::ranges::find(classes, starts[i], &ErrorClass::lo_cm);
    if (c != classes.end()) draw_box(canvas, frame, x, c->errors, color);
    const auto foot = frame.map(x, y.lo);
    canvas.line(foot, {foot.x(), foot.y() + 1.1}, Stroke{ink::axis, 0.22});
    canvas.text({foot.x(), foot.y() + 2}, number_text(starts[i]) + "–" + number_text(starts[i] + class_cm),
                TextStyle{7.5}.aligned(HAlign::centre, VAlign::top));
    canvas.text({foot.x(), frame.box.y0 + 1}, "n = " + std::to_string(c == classes.end() ? 0 : c->errors.size()),
                TextStyle{6.5, ink::muted}.aligned(HAlign::centre, VAlign::top));
  }
  draw_axes(canvas, frame, axes);
}

void draw_histogram(Canvas& canvas, const std::vector<double>& dbh, double class_cm) {
  std::map<long, int> counts;
  double sum = 0;
  for (const double d : dbh) ++counts[std::lround(std::floor(d / class_cm))], sum += d;
  if (counts.empty()) counts[0] = 0;
  int most = 1;
  for (const auto& [k, n] : counts) most = std::max(most, n);
  const double lo = static_cast<double>(counts.begin()->first) * class_cm,
               hi = static_cast<double>(counts.rbegin()->first + 1) * class_cm;
  const Frame frame{{axis_space_left_mm, 3, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm - 3},
                    {lo - 0.3 * class_cm, hi + 0.3 * class_cm},
                    {0, std::max(nice_interval({0, 1.2 * most}, 5).hi, 2.0)}};
  AxesStyle axes{"DBH (cm)", "Stems"};
  axes.x_axis = false;
  draw_grid(canvas, frame, axes);
  for (const auto& [k, n] : counts) {
    const double x = static_cast<double>(k) * class_cm;
    const auto a = frame.map(x + 0.04 * class_cm, n), b = frame.map(x + 0.96 * class_cm, 0);
    canvas.rectangle({a.x(), a.y(), b.x(), b.y()}, mix(ink::paper, ink::primary, 0.75));
  }
  const double mean = dbh.empty() ? 0 : sum / static_cast<double>(dbh.size());
  if (!dbh.empty()) canvas.line(frame.map(mean, 0), frame.map(mean, frame.y.hi), Stroke{ink::accent, 0.3, {1.4, 1.0}});
  for (const auto& [k, n] : counts) {
    const auto top = frame.map((static_cast<double>(k) + 0.5) * class_cm, n);
    TextStyle count{6.5, ink::muted};
    count.halo_mm = 0.5;  // over the line of the mean
    canvas.text({top.x(), top.y() - 0.9}, std::to_string(n), count.aligned(HAlign::centre, VAlign::baseline));
  }
  const auto classes = static_cast<int>(std::lround((hi - lo) / class_cm));
  const int every = std::max(1, static_cast<int>(std::ceil(7.0 * classes / frame.box.width())));
  for (int i = 0; i <= classes; i += every) {
    const auto p = frame.map(lo + i * class_cm, 0);
    canvas.line(p, {p.x(), p.y() + 1.1}, Stroke{ink::axis, 0.22});
    canvas.text({p.x(), p.y() + 2}, number_text(lo + i * class_cm),
                TextStyle{7.5}.aligned(HAlign::centre, VAlign::top));
  }
  if (!dbh.empty()) {
    const bool left = mean > (frame.x.lo + frame.x.hi) / 2;
    TextStyle style{7, ink::accent};
    style.halo_mm = 0.4;
    canvas.text(frame.map(mean, frame.y.hi) + Eigen::Vector2d(left ? -1.2 : 1.2, 0.5), "mean " + fixed(mean, 1) + " cm",
                style.aligned(left ? HAlign::right : HAlign::left, VAlign::top));
  }
  draw_axes(canvas, frame, axes);
}

}  // namespace

ErrorStatistics error_statistics(const std::vector<double>& estimate, const std::vector<double>& reference) {
  ErrorStatistics s;
  s.count = estimate.size();
  if (s.count == 0) return {0, std::nan(""), std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  const double n = static_cast<double>(s.count);
  double mean_e = 0, mean_r = 0, squares = 0, relative = 0, relative_squares = 0;
  for (std::size_t i = 0; i < s.count; ++i) {
    const double error = estimate[i] - reference[i];
    mean_e += estimate[i] / n;
    mean_r += reference[i] / n;
    squares += std::pow(error, 2);
    relative += error / reference[i];
    relative_squares += std::pow(error / reference[i], 2);
  }
  double ee = 0, rr = 0, er = 0;
  for (std::size_t i = 0; i < s.count; ++i) {
    ee += std::pow(estimate[i] - mean_e, 2);
    rr += std::pow(reference[i] - mean_r, 2);
    er += (estimate[i] - mean_e) * (reference[i] - mean_r);
  }
  s.bias = mean_e - mean_r;
  s.rmse = std::sqrt(squares / n);
  s.relative_bias_pct = 100 * relative / n;
  s.relative_rmse_pct = 100 * std::sqrt(relative_squares / n);
  s.r_squared = er * er / (ee * rr);
  return s;
}

Figure dbh_scatter(const Table& matches, double width_mm) {
  return dbh_scatter(std::vector<MatchGroup>{{"", ink::primary, &matches}}, width_mm, {});
}

Figure dbh_scatter(const std::vector<MatchGroup>& groups, double width_mm, const std::string& against) {
  Figure figure{"dbh_scatter",
                "Estimated against reference diameter",
                "Diameter at breast height of every matched tree; dashed: perfect agreement.",
                width_mm,
                3 + (width_mm - axis_space_left_mm - 3) + axis_space_below_mm + 1,
                true,
                {}};
  figure.draw = [all = series_of(groups),
                 label = (against.empty() ? "Reference DBH (cm)" : "DBH of " + against + " (cm)")](Canvas& canvas) {
    draw_dbh_scatter(canvas, all, label);
  };
  return figure;
}

Figure dbh_error_boxes(const Table& matches, double width_mm, double class_cm) {
  return dbh_error_boxes(std::vector<MatchGroup>{{"", ink::primary, &matches}}, width_mm, class_cm);
}

Figure dbh_error_boxes(const std::vector<MatchGroup>& groups, double width_mm, double class_cm) {
  const double title_mm = groups.size() > 1 ? 5 : 0, panel_mm = 0.72 * width_mm + title_mm;
  Figure figure{"dbh_errors",
                "Diameter error by class",
                "Estimated minus reference diameter by class of reference diameter: median, quartiles, whiskers to 1.5 "
                "times the distance between them, and every tree as a dot.",
                width_mm,
                panel_mm * static_cast<double>(groups.size()),
                true,
                {}};
  std::vector<std::vector<ErrorClass>> panels;
  std::set<double> starts;
  for (const auto& series : series_of(groups)) {
    panels.push_back(error_classes(series.pairs, class_cm));
    for (const auto& c : panels.back()) starts.insert(c.lo_cm);
  }
  std::vector<std::pair<std::string, Color>> titles;
  for (const auto& g : groups) titles.emplace_back(g.name, g.color);
  figure.draw = [panels = std::move(panels), starts = std::vector<double>(starts.begin(), starts.end()),
                 titles = std::move(titles), class_cm, title_mm, panel_mm](Canvas& canvas) {
    const auto y = error_range(panels);
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const double top = panel_mm * static_cast<double>(i);
      if (title_mm > 0)
        canvas.text({axis_space_left_mm, top + 1}, titles[i].first,
                    TextStyle{8, ink::text, true}.aligned(HAlign::left, VAlign::top));
      draw_boxes(
          canvas,
          {axis_space_left_mm, top + title_mm + 3, canvas.width_mm() - 3, top + panel_mm - axis_space_below_mm - 3},
          panels[i], starts, class_cm, y, titles[i].second);
    }
  };
  return figure;
}

Figure dbh_histogram(const std::vector<double>& dbh_cm, double width_mm, double class_cm) {
  std::vector<double> finite;
  std::copy_if(dbh_cm.begin(), dbh_cm.end(), std::back_inserter(finite), [](double d) { return std::isfinite(d); });
  Figure figure{
      "dbh_histogram",
      "Diameter distribution",
      "Stems per class of diameter at breast height (classes of " + number_text(class_cm) + " cm); dashed: their mean.",
      width_mm,
      0.66 * width_mm,
      true,
      {}};
  figure.draw = [finite = std::move(finite), class_cm](Canvas& canvas) { draw_histogram(canvas, finite, class_cm); };
  return figure;
}

}  // namespace bole::render
