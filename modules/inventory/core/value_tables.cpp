#include "inventory/core/value_tables.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/no_number.h"
#include "base/option_text.h"
#include "cloud/table_columns.h"
#include "inventory/core/measures.h"

namespace bole::inventory {
namespace {

constexpr HalfWidths no_interval{no_number, no_number};

class ValueRows {
 public:
  void add(const char* measure, double value, const char* unit, const HalfWidths& half = no_interval) {
    measure_.emplace_back(measure);
    value_.push_back(value);
    unit_.emplace_back(unit);
    lo_.push_back(value - half.measured);
    hi_.push_back(value + half.measured);
    half_.push_back(half.measured);
    sampled_half_.push_back(half.sampled);
  }
  void count(const char* measure, std::size_t value) { add(measure, static_cast<double>(value), ""); }

  Table table() const {
    Table t;
    t.set("measure", measure_);
    t.set("value", value_);
    t.set("unit", unit_);
    t.set("lo", lo_);
    t.set("hi", hi_);
    t.set("half", half_);
    t.set("sampled_half", sampled_half_);
    return t;
  }

 private:
  std::vector<std::string> measure_, unit_;
  std::vector<double> value_, lo_, hi_, half_, sampled_half_;
};

HalfWidths per_hectare(const HalfWidths& half, double area_m2) {
  const double factor = m2_per_ha / area_m2;
  return {factor * half.measured, factor * half.sampled};
}

// Only where a plot has stems are there intervals.
StandValues known_stand_values(const PlotValues& v) {
  StandValues s = v.stand;
  if (v.stems == 0) {
    s.stems = s.basal_area_m2 = s.volume_m3_half = no_interval;
    s.quadratic_mean_dbh_half_cm = no_number;
    s.mean_height_m = s.lorey_height_m = s.volume_m3 = no_number;
  }
  if (!v.heights_known) {
    s.curve.reset();
    s.mean_height_m = s.lorey_height_m = s.volume_m3 = no_number;
    s.volume_m3_half = no_interval;
  }
  return s;
}

}  // namespace

Table plot_value_table(const PlotValues& v, const PlotValueOptions& options) {
  const StandValues s = known_stand_values(v);
  ValueRows rows;
  rows.add("area", v.area_m2, "m2");
  rows.add("breast_height", v.assumed.breast_height_m, "m");
  rows.add("min_counted_dbh", v.min_counted_dbh_cm, "cm");
  rows.count("stems", v.stems);
  rows.count("stems_outside", v.outside);
  rows.count("stems_too_thin", v.too_thin);
  rows.count("stems_without_interval", s.no_interval);
  rows.add("stem_density", v.stems_per_ha, "1/ha", per_hectare(s.stems, v.area_m2));
  rows.add("basal_area", v.basal_area_m2, "m2", {s.basal_area_m2.measured, no_number});
  rows.add("basal_area_per_ha", v.basal_area_m2_per_ha, "m2/ha", per_hectare(s.basal_area_m2, v.area_m2));
  rows.add("mean_dbh", v.mean_dbh_cm, "cm");
  rows.add("min_dbh", v.min_dbh_cm, "cm");
  rows.add("max_dbh", v.max_dbh_cm, "cm");
  rows.add("sd_dbh", v.sd_dbh_cm, "cm");
  rows.add("quadratic_mean_dbh", v.quadratic_mean_dbh_cm, "cm", {s.quadratic_mean_dbh_half_cm, no_number});
  rows.count("tops_seen", v.tops_seen);
  rows.add("mean_height", v.mean_height_m, "m");
  rows.add("lorey_height", v.lorey_height_m, "m");
  rows.add("tops_basal_area", v.tops_basal_area_pct, "%");
  rows.add("lorey_height_at_least", v.lorey_at_least_m, "m");
  rows.add("dominant_height", v.dominant_height_m, "m");
  rows.count("dominant_stems", v.dominant_stems);
  rows.count("dominant_tops", v.dominant_tops);
  rows.count("heights_by_curve", s.by_curve);
  rows.add("mean_height_all", s.mean_height_m, "m");
  rows.add("lorey_height_all", s.lorey_height_m, "m");
  rows.add("volume", s.volume_m3, "m3", {s.volume_m3_half.measured, no_number});
  rows.add("volume_per_ha", s.volume_m3 * m2_per_ha / v.area_m2, "m3/ha", per_hectare(s.volume_m3_half, v.area_m2));
  rows.count("volumes_by_stem_curve", s.own_volume);
  rows.add("form_sd", v.assumed.form_sd_pct, "%");
  rows.count("stems_to_check", v.to_check);
  rows.count("stems_sound", v.sound.stems);
  rows.add("stem_density_sound", v.sound.stems_per_ha, "1/ha");
  rows.add("basal_area_sound", v.sound.basal_area_m2, "m2");
  rows.add("basal_area_per_ha_sound", v.sound.basal_area_m2_per_ha, "m2/ha");
  rows.add("quadratic_mean_dbh_sound", v.sound.quadratic_mean_dbh_cm, "cm");
  const double volume_sound = v.heights_known ? v.sound.volume_m3 : no_number;
  rows.add("volume_sound", volume_sound, "m3");
  rows.add("volume_per_ha_sound", volume_sound * m2_per_ha / v.area_m2, "m3/ha");
  Table t = rows.table();
  t.facts["class_width_cm"] = number_text(options.class_width_cm);
  return t;
}

Table class_table(const PlotValues& v) {
  std::vector<double> lo, hi, per_ha, area, area_per_ha, height;
  std::vector<std::int64_t> stems, to_check;
  for (const auto& c : v.classes) {
    to_check.push_back(static_cast<std::int64_t>(c.to_check));
    lo.push_back(c.lo_cm);
    hi.push_back(c.hi_cm);
    stems.push_back(static_cast<std::int64_t>(c.stems));
    per_ha.push_back(c.stems_per_ha);
    area.push_back(c.basal_area_m2);
    area_per_ha.push_back(c.basal_area_m2_per_ha);
    height.push_back(c.mean_height_m);
  }
  Table t;
  t.set("min_dbh_cm", lo);
  t.set("max_dbh_cm", hi);
  t.set("stems", stems);
  t.set("stems_to_check", to_check);
  t.set("stems_per_ha", per_ha);
  t.set("basal_area_m2", area);
  t.set("basal_area_m2_per_ha", area_per_ha);
  t.set("mean_height_m", height);
  return t;
}

Table height_curve_table(const PlotValues& v) {
  const auto curve = v.heights_known && v.stems > 0 ? v.stand.curve : std::nullopt;
  const auto one = [&](double value) { return curve ? std::vector<double>{value} : std::vector<double>{}; };
  const HeightCurve c = curve.value_or(HeightCurve{});
  Table t;
  t.set("breast_height_m", one(c.breast_height_m));
  t.set("a", one(c.a));
  t.set("b", one(c.b));
  t.set("rmse_m", one(c.rmse_m));
  t.set("trees", one(static_cast<double>(c.trees)));
  t.set("left_out", one(static_cast<double>(c.left_out)));
  t.set("min_dbh_cm", one(c.min_dbh_cm));
  t.set("max_dbh_cm", one(c.max_dbh_cm));
  return t;
}

Table tree_value_table(const PlotValues& v, const Table& stems) {
  const auto ids = numbers_or_nan(stems, "tree_id"), dbh = numbers_or_nan(stems, "dbh_cm");
  std::vector<std::int64_t> id, to_check;
  std::vector<double> diameter, height, curve_height, residual, volume, lo, hi;
  std::vector<std::string> height_source, volume_source;
  for (std::size_t i = 0; i < v.counted.size(); ++i) {
    const auto row = v.counted[i].row;
    StemValues s = v.stand.by_stem[i];
    if (!v.heights_known) {
      s.volume_m3 = s.own_volume ? s.volume_m3 : no_number;
      s.volume_half_m3 = s.own_volume ? s.volume_half_m3 : no_number;
      s.height_m = s.by_curve ? no_number : s.height_m;
      s.by_curve = false;
      s.curve_height_m = no_number;
    }
    id.push_back(std::isfinite(ids[row]) ? static_cast<std::int64_t>(ids[row]) : static_cast<std::int64_t>(row) + 1);
    to_check.push_back(v.counted[i].to_check ? 1 : 0);
    diameter.push_back(dbh[row]);
    height.push_back(s.height_m);
    height_source.emplace_back(!std::isfinite(s.height_m) ? "" : s.by_curve ? "height curve" : "top seen");
    curve_height.push_back(s.curve_height_m);
    residual.push_back(s.by_curve ? no_number : s.height_m - s.curve_height_m);
    volume.push_back(s.volume_m3);
    lo.push_back(s.volume_m3 - s.volume_half_m3);
    hi.push_back(s.volume_m3 + s.volume_half_m3);
    volume_source.emplace_back(!std::isfinite(s.volume_m3) ? "" : s.own_volume ? "stem curve" : "DBH, height and form");
  }
  Table t;
  t.set("tree_id", id);
  t.set("dbh_cm", diameter);
  t.set("to_check", to_check);
  t.set("height_m", height);
  t.set("height_source", height_source);
  t.set("curve_height_m", curve_height);
  t.set("height_residual_m", residual);
  t.set("volume_m3", volume);
  t.set("volume_lo_m3", lo);
  t.set("volume_hi_m3", hi);
  t.set("volume_source", volume_source);
  return t;
}

}  // namespace bole::inventory
