#include "report/core/plot_metrics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "render/charts/columns.h"
#include "render/draw/axes.h"

namespace bole {
namespace {

constexpr double m2_per_ha = 10000;
constexpr double dominant_per_ha = 100;

double basal_area_m2(double dbh_cm) { return std::numbers::pi / 4 * dbh_cm * dbh_cm / 10000; }

struct Counted {
  double dbh_cm, height_m;
};

void take_diameters(const std::vector<Counted>& stems, PlotMetrics& m) {
  const double n = static_cast<double>(stems.size());
  double sum = 0, squares = 0;
  m.least_dbh_cm = m.most_dbh_cm = stems.front().dbh_cm;
  for (const auto& s : stems) {
    sum += s.dbh_cm, squares += s.dbh_cm * s.dbh_cm;
    m.basal_area_m2 += basal_area_m2(s.dbh_cm);
    m.least_dbh_cm = std::min(m.least_dbh_cm, s.dbh_cm), m.most_dbh_cm = std::max(m.most_dbh_cm, s.dbh_cm);
  }
  m.mean_dbh_cm = sum / n;
  m.quadratic_mean_dbh_cm = std::sqrt(squares / n);
  double spread = 0;
  for (const auto& s : stems) spread += std::pow(s.dbh_cm - m.mean_dbh_cm, 2);
  m.sd_dbh_cm = stems.size() > 1 ? std::sqrt(spread / (n - 1)) : std::nan("");
}

void take_heights(std::vector<Counted> stems, PlotMetrics& m) {
  std::erase_if(stems, [](const Counted& s) { return !std::isfinite(s.height_m); });
  m.heights = stems.size();
  if (stems.empty()) return;
  double sum = 0, weighted = 0, weight = 0;
  for (const auto& s : stems) sum += s.height_m, weighted += s.height_m * basal_area_m2(s.dbh_cm), weight += basal_area_m2(s.dbh_cm);
  m.mean_height_m = sum / static_cast<double>(stems.size());
  m.lorey_height_m = weighted / weight;
  if (!std::isfinite(m.area_m2)) return;
  m.dominant_stems = std::min(stems.size(), std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(dominant_per_ha * m.area_m2 / m2_per_ha))));
  std::stable_sort(stems.begin(), stems.end(), [](const Counted& a, const Counted& b) { return a.dbh_cm > b.dbh_cm; });
  m.dominant_height_m =
      std::accumulate(stems.begin(), stems.begin() + static_cast<std::ptrdiff_t>(m.dominant_stems), 0.0, [](double total, const Counted& s) { return total + s.height_m; }) / static_cast<double>(m.dominant_stems);
}

std::vector<DiameterClass> classes_of(const std::vector<Counted>& stems, double class_cm, double area_m2) {
  struct Heights {
    double sum = 0;
    std::size_t count = 0;
  };
  std::map<long, std::pair<DiameterClass, Heights>> by_class;
  for (const auto& s : stems) {
    const long k = std::lround(std::floor(s.dbh_cm / class_cm));
    auto& [c, heights] = by_class[k];
    c.lo_cm = static_cast<double>(k) * class_cm, c.hi_cm = c.lo_cm + class_cm;
    ++c.stems;
    c.basal_area_m2 += basal_area_m2(s.dbh_cm);
    if (std::isfinite(s.height_m)) heights.sum += s.height_m, ++heights.count;
  }
  std::vector<DiameterClass> classes;
  for (auto& [k, entry] : by_class) {
    auto& [c, heights] = entry;
    c.stems_per_ha = static_cast<double>(c.stems) * m2_per_ha / area_m2;
    c.basal_area_m2_per_ha = c.basal_area_m2 * m2_per_ha / area_m2;
    c.mean_height_m = heights.count > 0 ? heights.sum / static_cast<double>(heights.count) : std::nan("");
    classes.push_back(c);
  }
  return classes;
}

bool rejected(const std::vector<std::string>& state, std::size_t i) { return state[i] == "rejected"; }

}  // namespace

std::vector<std::size_t> counted_stems(const Table& stems, const PlotArea& area, double least_dbh_cm) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  const auto state = texts_or_empty(stems, "state");
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < dbh.size(); ++i)
    if (!rejected(state, i) && std::isfinite(dbh[i]) && dbh[i] >= least_dbh_cm && area.contains(x[i], y[i])) rows.push_back(i);
  return rows;
}

PlotMetrics plot_metrics(const Table& stems, const PlotArea& area, double least_dbh_cm, double class_cm) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PlotMetrics m;
  m.area_m2 = area.area_m2();
  m.mean_dbh_cm = m.sd_dbh_cm = m.quadratic_mean_dbh_cm = m.least_dbh_cm = m.most_dbh_cm = m.mean_height_m = m.lorey_height_m = m.dominant_height_m = nan;
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm"), height = numbers_or_nan(stems, "height_m");
  const auto state = texts_or_empty(stems, "state");
  for (std::size_t i = 0; i < dbh.size(); ++i) {
    if (rejected(state, i) || !std::isfinite(dbh[i])) continue;
    if (!area.contains(x[i], y[i]))
      ++m.outside;
    else if (dbh[i] < least_dbh_cm)
      ++m.too_thin;
  }
  std::vector<Counted> counted;
  for (const auto i : counted_stems(stems, area, least_dbh_cm)) counted.push_back({dbh[i], height[i]});
  m.stems = counted.size();
  if (!counted.empty()) {
    take_diameters(counted, m);
    take_heights(counted, m);
  }
  m.stems_per_ha = static_cast<double>(m.stems) * m2_per_ha / m.area_m2;
  m.basal_area_m2_per_ha = m.basal_area_m2 * m2_per_ha / m.area_m2;
  m.classes = classes_of(counted, class_cm, m.area_m2);
  return m;
}

std::vector<MetricRow> metric_rows(const PlotMetrics& m, double least_dbh_cm) {
  const std::string heights = std::to_string(m.heights) + " of " + std::to_string(m.stems) + " stems have a height";
  return {
      {"Plot area", fixed(m.area_m2, 1), "m²", "horizontal"},
      {"Stems", std::to_string(m.stems), "",
       "DBH of at least " + fixed(least_dbh_cm, 1) + " cm and centre at breast height inside the plot; " + std::to_string(m.outside) + " outside, " + std::to_string(m.too_thin) + " thinner"},
      {"Stem density", fixed(m.stems_per_ha, 0), "1/ha", "stems / area"},
      {"Basal area", fixed(m.basal_area_m2, 3), "m²", "sum of π/4 · DBH²"},
      {"Basal area per hectare", fixed(m.basal_area_m2_per_ha, 2), "m²/ha", "basal area / area"},
      {"Mean DBH", fixed(m.mean_dbh_cm, 2), "cm", "arithmetic; range " + fixed(m.least_dbh_cm, 1) + " to " + fixed(m.most_dbh_cm, 1) + " cm"},
      {"Standard deviation of DBH", fixed(m.sd_dbh_cm, 2), "cm", "with n − 1"},
      {"Quadratic mean diameter", fixed(m.quadratic_mean_dbh_cm, 2), "cm", "√(mean of DBH²)"},
      {"Mean height", fixed(m.mean_height_m, 1), "m", heights},
      {"Lorey's height", fixed(m.lorey_height_m, 1), "m", "heights weighted by basal area; " + heights},
      {"Dominant height", fixed(m.dominant_height_m, 1), "m",
       m.dominant_stems > 0 ? "mean height of the 100 thickest stems per hectare: " + std::to_string(m.dominant_stems) + " on this plot" : "mean height of the 100 thickest stems per hectare"},
  };
}

}  // namespace bole
