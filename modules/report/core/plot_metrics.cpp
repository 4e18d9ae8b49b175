#include "report/core/plot_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "base/option.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"

namespace bole::report {
namespace {

constexpr double m2_per_ha = 10000;
constexpr double dominant_per_ha = 100;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double basal_area_m2(double dbh_cm) { return std::numbers::pi / 4 * dbh_cm * dbh_cm / 10000; }

using Counted = SizedStem;

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

void take_dominant_height(std::vector<Counted> stems, PlotMetrics& m) {
  m.dominant_stems = std::min(
      stems.size(),
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(dominant_per_ha * m.area_m2 / m2_per_ha))));
  std::stable_sort(stems.begin(), stems.end(), [](const Counted& a, const Counted& b) { return a.dbh_cm > b.dbh_cm; });
  stems.resize(m.dominant_stems);
  std::erase_if(stems, [](const Counted& s) { return !std::isfinite(s.height_m); });
  m.dominant_tops = stems.size();
  if (stems.empty() || 2 * m.dominant_tops < m.dominant_stems) return;
  m.dominant_height_m = std::accumulate(stems.begin(), stems.end(), 0.0,
                                        [](double total, const Counted& s) { return total + s.height_m; }) /
                        static_cast<double>(stems.size());
}

void take_heights(const std::vector<Counted>& stems, PlotMetrics& m) {
  double sum = 0, weighted = 0, weight = 0;
  for (const auto& s : stems) {
    if (!std::isfinite(s.height_m)) continue;
    ++m.tops_seen;
    sum += s.height_m, weighted += s.height_m * basal_area_m2(s.dbh_cm), weight += basal_area_m2(s.dbh_cm);
  }
  m.heights_known = enough_tops(m.tops_seen, stems.size());
  if (!m.heights_known) return;
  m.mean_height_m = sum / static_cast<double>(m.tops_seen);
  m.lorey_height_m = weighted / weight;
  if (std::isfinite(m.area_m2)) take_dominant_height(stems, m);
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

bool enough_tops(std::size_t seen, std::size_t stems) {
  return seen > 0 && (seen == stems || (seen >= 5 && 5 * seen >= stems));
}

std::vector<double> seen_heights(const Table& stems) {
  auto height = render::numbers_or_nan(stems, "height_m");
  if (!stems.has("height_seen")) return height;
  const auto seen = render::numbers_or_nan(stems, "height_seen");
  for (std::size_t i = 0; i < height.size(); ++i)
    if (!(seen[i] > 0)) height[i] = std::numeric_limits<double>::quiet_NaN();
  return height;
}

std::vector<std::size_t> counted_stems(const Table& stems, const CountingRule& rule) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  const auto state = render::texts_or_empty(stems, "state");
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < dbh.size(); ++i)
    if (!rejected(state, i) && std::isfinite(dbh[i]) && rule.counts({x[i], y[i]}, dbh[i])) rows.push_back(i);
  return rows;
}

PlotMetrics plot_metrics(const Table& stems, const CountingRule& rule, double class_cm, double form_sd_pct) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PlotMetrics m;
  m.assumed = {breast_height_m(stems), form_sd_pct};
  m.area_m2 = rule.area.area_m2();
  m.mean_dbh_cm = m.sd_dbh_cm = m.quadratic_mean_dbh_cm = m.least_dbh_cm = m.most_dbh_cm = m.mean_height_m =
      m.lorey_height_m = m.dominant_height_m = nan;
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm"),
             height = seen_heights(stems), low = render::numbers_or_nan(stems, "dbh_lo_cm"),
             high = render::numbers_or_nan(stems, "dbh_hi_cm"), volume = render::numbers_or_nan(stems, "volume_m3");
  const auto state = render::texts_or_empty(stems, "state");
  for (std::size_t i = 0; i < dbh.size(); ++i) {
    if (rejected(state, i) || !std::isfinite(dbh[i])) continue;
    if (!rule.area.contains(x[i], y[i]))
      ++m.outside;
    else if (dbh[i] < rule.min_dbh_cm)
      ++m.too_thin;
  }
  std::vector<Counted> counted;
  for (const auto i : counted_stems(stems, rule))
    counted.push_back({dbh[i], (high[i] - low[i]) / (2 * 1.959964), height[i], volume[i]});
  m.stems = counted.size();
  if (!counted.empty()) {
    take_diameters(counted, m);
    take_heights(counted, m);
    m.stand = stand_values(counted, m.assumed);
  }
  m.stems_per_ha = static_cast<double>(m.stems) * m2_per_ha / m.area_m2;
  m.basal_area_m2_per_ha = m.basal_area_m2 * m2_per_ha / m.area_m2;
  m.classes = classes_of(counted, class_cm, m.area_m2);
  return m;
}

namespace {

std::vector<MetricRow> height_rows(const PlotMetrics& m) {
  const std::string seen = "tops seen on " + std::to_string(m.tops_seen) + " of " + std::to_string(m.stems) + " stems";
  if (!m.heights_known)
    return {{"Heights", "not given", "",
             m.tops_seen == 0 && m.stems == 0 ? "no stems" : seen + ": heights are lower bounds"}};
  std::vector<MetricRow> rows{
      {"Mean height", render::fixed(m.mean_height_m, 1), "m", seen + "; these alone count"},
      {"Lorey's height", render::fixed(m.lorey_height_m, 1), "m", "heights weighted by basal area; " + seen}};
  if (m.dominant_stems > 0)
    rows.push_back({"Dominant height", render::fixed(m.dominant_height_m, 1), "m",
                    "mean height of the 100 thickest stems per hectare: " + std::to_string(m.dominant_stems) +
                        " on this plot, tops seen on " + std::to_string(m.dominant_tops)});
  return rows;
}

// "; 95 %: ± 0.12 as measured, ± 1.3 as a sample": both halves where known.
std::string intervals(const HalfWidths& half, double factor, int decimals) {
  std::string text;
  if (std::isfinite(half.measured)) text += "± " + render::fixed(factor * half.measured, decimals) + " as measured";
  if (std::isfinite(half.sampled))
    text += (text.empty() ? "" : ", ") + ("± " + render::fixed(factor * half.sampled, decimals)) +
            " as a sample of a stand";
  return text.empty() ? text : "; 95 %: " + text;
}

// "; 2 stems without an interval taken as unsure as the others": empty where all have one, or none.
std::string assumed(const PlotMetrics& m) {
  const auto n = m.stand.no_interval;
  if (n == 0 || n == m.stems) return {};
  return "; " + std::to_string(n) + (n == 1 ? " stem" : " stems") +
         " without an interval taken as unsure as the others";
}

// Heights by the curve, and volumes: nothing where too few tops were seen to speak of heights.
std::vector<MetricRow> stand_rows(const PlotMetrics& m) {
  std::vector<MetricRow> rows;
  const auto& s = m.stand;
  if (m.stems == 0) return rows;
  if (!m.heights_known) return {{"Stem volume", "not given", "", "heights are lacking"}};
  if (s.curve) {
    const auto& c = *s.curve;
    rows.push_back({"Height curve",
                    "h = " + number_text(c.breast_height_m) + " + d²/(" + render::fixed(c.a, 3) + " + " +
                        render::fixed(c.b, 4) + " d)²",
                    "",
                    "Näslund, d in cm; RMSE " + render::fixed(c.rmse_m, 2) + " m over " + std::to_string(c.trees) +
                        " trees of " + render::fixed(c.least_dbh_cm, 0) + " to " + render::fixed(c.most_dbh_cm, 0) +
                        " cm"});
    if (s.by_curve > 0 && std::isfinite(s.lorey_height_m))
      rows.push_back({"Lorey's height, all stems", render::fixed(s.lorey_height_m, 1), "m",
                      "by the curve for " + std::to_string(s.by_curve) + " of " + std::to_string(m.stems) + " stems"});
  }
  if (!std::isfinite(s.volume_m3)) {
    const std::string why = s.curve ? "stems thinner or thicker than the height curve reaches, their tops not seen"
                                    : "tops are lacking and no height curve can be fitted";
    rows.push_back({"Stem volume", "not given", "", why});
    return rows;
  }
  const std::string how = std::to_string(s.own_volume) +
                          " by their stem curve, the others as stems between paraboloid and cone through DBH and top" +
                          (s.own_volume < m.stems ? ", their form unsure by " + number_text(m.assumed.form_sd_pct) +
                                                        " % (standard deviation)"
                                                  : "");
  rows.push_back({"Stem volume", render::fixed(s.volume_m3, 3), "m³",
                  how + intervals({s.volume_m3_half.measured, nan_value}, 1, 3)});
  if (std::isfinite(m.area_m2))
    rows.push_back({"Stem volume per hectare", render::fixed(s.volume_m3 * m2_per_ha / m.area_m2, 1), "m³/ha",
                    "volume / area" + intervals(s.volume_m3_half, m2_per_ha / m.area_m2, 1)});
  return rows;
}

}  // namespace

std::vector<MetricRow> metric_rows(const PlotMetrics& m, double min_dbh_cm) {
  const std::string inside = std::isfinite(m.area_m2) ? " and centre at breast height inside the plot; " +
                                                            std::to_string(m.outside) + " outside, "
                                                      : "; ";
  std::vector<MetricRow> rows;
  if (std::isfinite(m.area_m2)) rows.push_back({"Plot area", render::fixed(m.area_m2, 1), "m²", "horizontal"});
  rows.push_back({"Breast height", number_text(m.assumed.breast_height_m), "m", "above ground, where DBH is measured"});
  rows.push_back(
      {"Stems", std::to_string(m.stems), "",
       (min_dbh_cm > 0 ? "DBH of at least " + render::fixed(min_dbh_cm, 1) + " cm" : std::string("of every DBH")) +
           inside + std::to_string(m.too_thin) + " thinner"});
  if (std::isfinite(m.area_m2))
    rows.push_back({"Stem density", render::fixed(m.stems_per_ha, 0), "1/ha",
                    "stems / area" + intervals(m.stand.stems, m2_per_ha / m.area_m2, 0)});
  rows.push_back({"Basal area", render::fixed(m.basal_area_m2, 3), "m²",
                  "sum of π/4 · DBH²" + intervals({m.stand.basal_area_m2.measured, nan_value}, 1, 3) + assumed(m)});
  if (std::isfinite(m.area_m2))
    rows.push_back({"Basal area per hectare", render::fixed(m.basal_area_m2_per_ha, 2), "m²/ha",
                    "basal area / area" + intervals(m.stand.basal_area_m2, m2_per_ha / m.area_m2, 2)});
  rows.push_back(
      {"Mean DBH", render::fixed(m.mean_dbh_cm, 2), "cm",
       "arithmetic; range " + render::fixed(m.least_dbh_cm, 1) + " to " + render::fixed(m.most_dbh_cm, 1) + " cm"});
  rows.push_back({"Standard deviation of DBH", render::fixed(m.sd_dbh_cm, 2), "cm", "with n − 1"});
  rows.push_back({"Quadratic mean diameter", render::fixed(m.quadratic_mean_dbh_cm, 2), "cm",
                  "√(mean of DBH²)" + intervals({m.stand.quadratic_mean_dbh_half_cm, nan_value}, 1, 2)});
  for (auto& row : height_rows(m)) rows.push_back(std::move(row));
  for (auto& row : stand_rows(m)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace bole::report
