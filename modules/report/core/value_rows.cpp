#include "report/core/value_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/option_text.h"
#include "render/draw/axes.h"

namespace bole::report {
namespace {

// "; 95 %: ± 0.12 as measured, ± 1.3 as a sample of a stand": both halves where known.
std::string intervals(const PlotValues::Value& v, int decimals) {
  std::string text;
  if (std::isfinite(v.half)) text += "± " + render::fixed(v.half, decimals) + " as measured";
  if (std::isfinite(v.sampled_half))
    text += (text.empty() ? "" : ", ") + ("± " + render::fixed(v.sampled_half, decimals)) + " as a sample of a stand";
  return text.empty() ? text : "; 95 %: " + text;
}

// "; 2 stems without an interval taken as unsure as the others": empty where all have one, or none.
std::string without_interval(const PlotValues& v) {
  const double n = v.value("stems_without_interval");
  if (n == 0 || n == v.value("stems")) return {};
  return "; " + v.count("stems_without_interval") + (n == 1 ? " stem" : " stems") +
         " without an interval taken as unsure as the others";
}

std::vector<ValueRow> height_rows(const PlotValues& v) {
  const std::string seen = "tops seen on " + v.count("tops_seen") + " of " + v.count("stems") + " stems";
  if (!v.given("mean_height"))
    return {{"Heights", "not given", "", v.value("stems") == 0 ? "no stems" : seen + ": heights are lower bounds"}};
  std::vector<ValueRow> rows{
      {"Mean height", v.text("mean_height", 1), "m", seen + "; these alone count"},
      {"Lorey's height", v.text("lorey_height", 1), "m", "heights weighted by basal area; " + seen}};
  if (few_heights(v)) {
    rows.back().name += " of these tops";
    rows.back().how += " with " + v.count("tops_basal_area") + " % of the basal area";
    rows.push_back({"Lorey's height, at least", v.text("lorey_height_at_least", 1), "m",
                    "all stems, those whose top was not seen with the height that they reach at least"});
  }
  if (v.value("dominant_stems") > 0)
    rows.push_back({"Dominant height", v.text("dominant_height", 1), "m",
                    "mean height of the 100 thickest stems per hectare: " + v.count("dominant_stems") +
                        " on this plot, tops seen on " + v.count("dominant_tops")});
  return rows;
}

ValueRow curve_row(const Table& curve) {
  const auto number = [&](const char* column) { return curve.numbers(column)[0]; };
  return {"Height curve",
          "h = " + number_text(number("breast_height_m")) + " + d²/(" + render::fixed(number("a"), 3) + " + " +
              render::fixed(number("b"), 4) + " d)²",
          "",
          "Näslund, d in cm; RMSE " + render::fixed(number("rmse_m"), 2) + " m over " +
              render::fixed(number("trees"), 0) + " trees of " + render::fixed(number("min_dbh_cm"), 0) + " to " +
              render::fixed(number("max_dbh_cm"), 0) + " cm"};
}

// Heights by the curve, and volumes: nothing where too few tops were seen.
std::vector<ValueRow> stand_rows(const PlotValues& v, const Table* curve) {
  if (v.value("stems") == 0) return {};
  if (!v.given("mean_height")) return {{"Stem volume", "not given", "", "heights are lacking"}};
  std::vector<ValueRow> rows;
  const bool has_curve = curve != nullptr && curve->rows() > 0;
  if (has_curve) {
    rows.push_back(curve_row(*curve));
    if (v.value("heights_by_curve") > 0 && v.given("lorey_height_all"))
      rows.push_back({"Lorey's height, all stems", v.text("lorey_height_all", 1), "m",
                      "by the curve for " + v.count("heights_by_curve") + " of " + v.count("stems") + " stems"});
  }
  if (!v.given("volume")) {
    rows.push_back({"Stem volume", "not given", "",
                    has_curve ? "stems thinner or thicker than the height curve reaches, their tops not seen"
                              : "tops are lacking and no height curve can be fitted"});
    return rows;
  }
  std::string how = v.count("volumes_by_stem_curve") +
                    " by their stem curve, the others as stems between paraboloid and cone through DBH and top";
  if (v.value("volumes_by_stem_curve") < v.value("stems"))
    how += ", their form unsure by " + number_text(v.value("form_sd")) + " % (standard deviation)";
  rows.push_back({"Stem volume", v.text("volume", 3), "m³", how + intervals(v.at("volume"), 3)});
  if (v.given("area"))
    rows.push_back({"Stem volume per hectare", v.text("volume_per_ha", 1), "m³/ha",
                    "volume / area" + intervals(v.at("volume_per_ha"), 1)});
  return rows;
}

void append(std::vector<ValueRow>& rows, std::vector<ValueRow> more) {
  std::ranges::move(more, std::back_inserter(rows));
}

}  // namespace

PlotValues::PlotValues(const Table& t) : measures_(t.texts("measure")) {
  const auto value = t.numbers("value"), half = t.numbers("half"), sampled_half = t.numbers("sampled_half");
  const auto& unit = t.texts("unit");
  for (std::size_t i = 0; i < t.rows(); ++i) values_.push_back({value[i], unit[i], half[i], sampled_half[i]});
}

const PlotValues::Value& PlotValues::at(const std::string& measure) const {
  const auto it = std::ranges::find(measures_, measure);
  if (it == measures_.end())
    throw bad_input("the plot values have no measure '" + measure + "'", "the table of inventory.plot_values",
                    "Connect plot_values of that stage to the report");
  return values_[static_cast<std::size_t>(it - measures_.begin())];
}

std::string PlotValues::text(const std::string& measure, int decimals) const {
  return render::fixed(value(measure), decimals);
}

bool PlotValues::given(const std::string& measure) const { return std::isfinite(value(measure)); }

bool PlotValues::has(const std::string& measure) const {
  return std::ranges::find(measures_, measure) != measures_.end() && given(measure);
}

bool few_heights(const PlotValues& v) {
  constexpr double few_pct = 50;  // the mean of fewer does not describe the plot
  return v.has("tops_basal_area") && v.has("lorey_height_at_least") && v.value("tops_basal_area") < few_pct;
}

std::vector<ValueRow> value_rows(const PlotValues& v, const Table* height_curve) {
  const bool bounded = v.given("area");
  const double min_dbh_cm = v.value("min_counted_dbh");
  std::vector<ValueRow> rows;
  if (bounded) rows.push_back({"Plot area", v.text("area", 1), "m²", "horizontal"});
  rows.push_back({"Breast height", number_text(v.value("breast_height")), "m", "above ground, where DBH is measured"});
  rows.push_back(
      {"Stems", v.count("stems"), "",
       (min_dbh_cm > 0 ? "DBH of at least " + v.text("min_counted_dbh", 1) + " cm" : "of every DBH") +
           (bounded ? " and centre at breast height inside the plot; " + v.count("stems_outside") + " outside, "
                    : "; ") +
           v.count("stems_too_thin") + " thinner"});
  if (bounded)
    rows.push_back(
        {"Stem density", v.text("stem_density", 0), "1/ha", "stems / area" + intervals(v.at("stem_density"), 0)});
  rows.push_back({"Basal area", v.text("basal_area", 3), "m²",
                  "sum of π/4 · DBH²" + intervals(v.at("basal_area"), 3) + without_interval(v)});
  if (bounded)
    rows.push_back({"Basal area per hectare", v.text("basal_area_per_ha", 2), "m²/ha",
                    "basal area / area" + intervals(v.at("basal_area_per_ha"), 2)});
  rows.push_back({"Mean DBH", v.text("mean_dbh", 2), "cm",
                  "arithmetic; range " + v.text("min_dbh", 1) + " to " + v.text("max_dbh", 1) + " cm"});
  rows.push_back({"Standard deviation of DBH", v.text("sd_dbh", 2), "cm", "with n − 1"});
  rows.push_back({"Quadratic mean diameter", v.text("quadratic_mean_dbh", 2), "cm",
                  "√(mean of DBH²)" + intervals(v.at("quadratic_mean_dbh"), 2)});
  append(rows, height_rows(v));
  append(rows, stand_rows(v, height_curve));
  return rows;
}

std::string unit_text(const std::string& unit) {
  if (unit == "deg") return "°";
  std::string text = unit;
  for (const auto& [plain, typeset] : {std::pair{"m2", "m²"}, {"m3", "m³"}})
    if (text.starts_with(plain)) text.replace(0, 2, typeset);
  return text;
}

}  // namespace bole::report
