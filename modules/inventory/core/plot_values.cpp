#include "inventory/core/plot_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "base/no_number.h"
#include "base/statistics.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "inventory/core/measures.h"

namespace bole::inventory {
namespace {

constexpr double dominant_per_ha = 100;

void take_diameters(const std::vector<SizedStem>& stems, PlotValues& m) {
  const double n = static_cast<double>(stems.size());
  double sum = 0, squares = 0;
  m.min_dbh_cm = m.max_dbh_cm = stems.front().dbh_cm;
  for (const auto& s : stems) {
    sum += s.dbh_cm;
    squares += s.dbh_cm * s.dbh_cm;
    m.basal_area_m2 += basal_area_m2(s.dbh_cm);
    m.min_dbh_cm = std::min(m.min_dbh_cm, s.dbh_cm);
    m.max_dbh_cm = std::max(m.max_dbh_cm, s.dbh_cm);
  }
  m.mean_dbh_cm = sum / n;
  m.quadratic_mean_dbh_cm = std::sqrt(squares / n);
  double spread = 0;
  for (const auto& s : stems) spread += std::pow(s.dbh_cm - m.mean_dbh_cm, 2);
  m.sd_dbh_cm = stems.size() > 1 ? std::sqrt(spread / (n - 1)) : no_number;
}

void take_dominant_height(std::vector<SizedStem> stems, PlotValues& m) {
  m.dominant_stems = std::min(
      stems.size(),
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(dominant_per_ha * m.area_m2 / m2_per_ha))));
  std::stable_sort(stems.begin(), stems.end(),
                   [](const SizedStem& a, const SizedStem& b) { return a.dbh_cm > b.dbh_cm; });
  stems.resize(m.dominant_stems);
  std::erase_if(stems, [](const SizedStem& s) { return !std::isfinite(s.height_m); });
  m.dominant_tops = stems.size();
  if (stems.empty() || 2 * m.dominant_tops < m.dominant_stems) return;
  m.dominant_height_m = std::accumulate(stems.begin(), stems.end(), 0.0,
                                        [](double total, const SizedStem& s) { return total + s.height_m; }) /
                        static_cast<double>(stems.size());
}

void take_heights(const std::vector<SizedStem>& stems, PlotValues& m) {
  double sum = 0, weighted = 0, weight = 0;
  for (const auto& s : stems) {
    if (!std::isfinite(s.height_m)) continue;
    ++m.tops_seen;
    sum += s.height_m;
    weighted += s.height_m * basal_area_m2(s.dbh_cm);
    weight += basal_area_m2(s.dbh_cm);
  }
  m.tops_basal_area_pct = 100 * weight / m.basal_area_m2;
  m.heights_known = enough_tops(m.tops_seen, stems.size());
  if (!m.heights_known) return;
  m.mean_height_m = sum / static_cast<double>(m.tops_seen);
  m.lorey_height_m = weighted / weight;
  if (std::isfinite(m.area_m2)) take_dominant_height(stems, m);
}

// Each stem with its height, or with what it reaches at least: nothing where that is not known.
double lorey_at_least_m(const std::vector<SizedStem>& stems, const std::vector<double>& bound_m) {
  double weighted = 0, weight = 0;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const double g = basal_area_m2(stems[i].dbh_cm);
    const double height = std::isfinite(stems[i].height_m) ? stems[i].height_m : bound_m[i];
    weighted += std::isfinite(height) ? g * height : 0;
    weight += g;
  }
  return weighted / weight;
}

std::vector<DiameterClass> classes_of(const std::vector<SizedStem>& stems, const std::vector<CountedStem>& counted,
                                      double class_cm, double area_m2) {
  struct Heights {
    double sum = 0;
    std::size_t count = 0;
  };
  std::map<long, std::pair<DiameterClass, Heights>> by_class;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto& s = stems[i];
    const long k = std::lround(std::floor(s.dbh_cm / class_cm));
    auto& [c, heights] = by_class[k];
    c.lo_cm = static_cast<double>(k) * class_cm;
    c.hi_cm = c.lo_cm + class_cm;
    ++c.stems;
    c.to_check += counted[i].to_check;
    c.basal_area_m2 += basal_area_m2(s.dbh_cm);
    if (!std::isfinite(s.height_m)) continue;
    heights.sum += s.height_m;
    ++heights.count;
  }
  std::vector<DiameterClass> classes;
  for (auto& [k, entry] : by_class) {
    auto& [c, heights] = entry;
    c.stems_per_ha = static_cast<double>(c.stems) * m2_per_ha / area_m2;
    c.basal_area_m2_per_ha = c.basal_area_m2 * m2_per_ha / area_m2;
    c.mean_height_m = heights.count > 0 ? heights.sum / static_cast<double>(heights.count) : no_number;
    classes.push_back(c);
  }
  return classes;
}

// Heights by row, NaN where the top was not seen: column height_m where height_seen is not 0, all where it is absent.
std::vector<double> seen_heights(const Table& stems) {
  auto height = numbers_or_nan(stems, "height_m");
  if (!stems.has("height_seen")) return height;
  const auto seen = numbers_or_nan(stems, "height_seen");
  for (std::size_t i = 0; i < height.size(); ++i)
    if (!(seen[i] > 0)) height[i] = no_number;
  return height;
}

bool is_to_check(const std::string& state, const std::string& quality) {
  const bool decided = state == "accepted" || state == "edited" || state == "rejected";
  return !decided && (state == "check" || quality == "poor");
}

void take_sound(const std::vector<SizedStem>& stems, PlotValues& m) {
  double squares = 0;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    if (m.counted[i].to_check) continue;
    ++m.sound.stems;
    m.sound.basal_area_m2 += basal_area_m2(stems[i].dbh_cm);
    squares += stems[i].dbh_cm * stems[i].dbh_cm;
    m.sound.volume_m3 += m.stand.by_stem[i].volume_m3;
  }
  m.to_check = stems.size() - m.sound.stems;
  const auto n = static_cast<double>(m.sound.stems);
  m.sound.stems_per_ha = n * m2_per_ha / m.area_m2;
  m.sound.basal_area_m2_per_ha = m.sound.basal_area_m2 * m2_per_ha / m.area_m2;
  m.sound.quadratic_mean_dbh_cm = std::sqrt(squares / n);
}

// Where rays are not known an interval can reach further down than up (stems.measure). NaN intervals stay NaN.
SizedStem sized_stem(double dbh_cm, double low_cm, double high_cm, double height_m, double volume_m3) {
  constexpr double rounding_cm = 0.021;  // of three columns with two decimals
  const double further_down_cm = (dbh_cm - low_cm) - (high_cm - dbh_cm);
  if (further_down_cm > rounding_cm) return {dbh_cm, (high_cm - dbh_cm) / z_95, height_m, volume_m3, further_down_cm};
  return {dbh_cm, (high_cm - low_cm) / (2 * z_95), height_m, volume_m3, 0};
}

}  // namespace

bool many_to_check(const PlotValues& v) {
  const auto least = [](double whole) { return considerable_share * whole; };
  return v.to_check > 0 && (static_cast<double>(v.to_check) >= least(static_cast<double>(v.stems)) ||
                            v.basal_area_m2 - v.sound.basal_area_m2 >= least(v.basal_area_m2));
}

bool mostly_to_check(const PlotValues& v) { return v.to_check > 0 && v.sound.basal_area_m2 < 0.5 * v.basal_area_m2; }

bool enough_tops(std::size_t seen, std::size_t stems) {
  return seen > 0 && (seen == stems || (seen >= 5 && 5 * seen >= stems));
}

PlotValues plot_values(const Table& stems, const CountingRule& rule, const PlotValueOptions& options) {
  PlotValues m;
  m.assumed = {breast_height_m(stems), options.form_sd_pct};
  m.area_m2 = rule.area.area_m2();
  m.min_counted_dbh_cm = rule.min_dbh_cm;
  m.mean_dbh_cm = m.sd_dbh_cm = m.quadratic_mean_dbh_cm = m.min_dbh_cm = m.max_dbh_cm = no_number;
  m.mean_height_m = m.lorey_height_m = m.lorey_at_least_m = m.dominant_height_m = m.tops_basal_area_pct = no_number;
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm"),
             height = seen_heights(stems), low = numbers_or_nan(stems, "dbh_lo_cm"),
             high = numbers_or_nan(stems, "dbh_hi_cm"), volume = numbers_or_nan(stems, "volume_m3"),
             bound = numbers_or_nan(stems, "height_lower_bound_m");
  for (const auto i : kept_rows(stems)) {
    if (!std::isfinite(dbh[i])) continue;
    if (!rule.area.contains(x[i], y[i]))
      ++m.outside;
    else if (dbh[i] < rule.min_dbh_cm)
      ++m.too_thin;
  }
  const auto state = texts_or_empty(stems, "state"), quality = texts_or_empty(stems, "quality");
  std::vector<SizedStem> sized;
  std::vector<double> bounds;
  for (const auto i : counted_rows(stems, rule)) {
    sized.push_back(sized_stem(dbh[i], low[i], high[i], height[i], volume[i]));
    bounds.push_back(bound[i]);
    m.counted.push_back({i, is_to_check(state[i], quality[i])});
  }
  m.stems = sized.size();
  if (!sized.empty()) {
    take_diameters(sized, m);
    take_heights(sized, m);
    if (stems.has("height_lower_bound_m")) m.lorey_at_least_m = lorey_at_least_m(sized, bounds);
    m.stand = stand_values(sized, m.assumed);
  }
  take_sound(sized, m);
  m.stems_per_ha = static_cast<double>(m.stems) * m2_per_ha / m.area_m2;
  m.basal_area_m2_per_ha = m.basal_area_m2 * m2_per_ha / m.area_m2;
  m.classes = classes_of(sized, m.counted, options.class_width_cm, m.area_m2);
  return m;
}

}  // namespace bole::inventory
