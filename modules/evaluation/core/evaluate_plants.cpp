#include "evaluation/core/evaluate_plants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/no_number.h"
#include "cloud/table_columns.h"

namespace bole::evaluation {
namespace {

// SPEC C: accuracy in percent.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> published{{{"height_mm", "97.94"},
                                                                                  {"breadth_length_mm", "93.95"},
                                                                                  {"breadth_width_mm", "94.11"},
                                                                                  {"stem_diameter_mm", "97.62"}}};

std::vector<std::string> plant_names(const Table& table, const char* which) {
  std::vector<std::string> names(table.rows());
  if (!table.has("plant_id")) {
    if (table.rows() == 1) return {""};
    throw bad_input(
        std::string("the ") + which + " table has " + std::to_string(table.rows()) + " plants and no column plant_id",
        "names of the plants");
  }
  for (std::size_t i = 0; i < table.rows(); ++i) names[i] = table.text("plant_id", i);
  auto sorted = names;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    throw bad_input(std::string("the ") + which + " table has the plant '" + *twice + "' twice", "every plant once");
  return names;
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_by_name(const Table& estimate, const Table& reference) {
  const auto a = plant_names(estimate, "estimated"), b = plant_names(reference, "reference");
  if (a.size() == 1 && b.size() == 1) return {{0, 0}};
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (const auto it = std::ranges::find(b, a[i]); it != b.end())
      out.emplace_back(i, static_cast<std::size_t>(it - b.begin()));
  if (out.empty())
    throw bad_input("no plant_id is in both tables", "the same names in both",
                    "first estimated: '" + (a.empty() ? std::string() : a[0]) + "', first reference: '" +
                        (b.empty() ? std::string() : b[0]) + "'");
  return out;
}

// "stem_diameter_mm" and "lo" give "stem_diameter_lo_mm".
std::string bound_name(const std::string& trait, const char* bound) {
  const auto cut = trait.rfind('_');
  return cut == std::string::npos ? trait + "_" + bound : trait.substr(0, cut) + "_" + bound + trait.substr(cut);
}

bool is_bound(const std::string& name) {
  return name.find("_lo_") != std::string::npos || name.find("_hi_") != std::string::npos || name.ends_with("_lo") ||
         name.ends_with("_hi");
}

std::string unit_of_trait(const std::string& trait) {
  const auto cut = trait.rfind('_');
  auto unit = cut == std::string::npos ? std::string() : trait.substr(cut + 1);
  for (const auto* known : {"mm", "cm", "m", "cm2", "cm3", "mm2", "deg", "kg", "g"})
    if (unit == known) return unit;
  return {};
}

struct Sums {
  double n = 0, relative = 0, error = 0, square = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0, intervals = 0, held = 0;

  double r2() const {
    const double a = n * xx - x * x, b = n * yy - y * y, c = n * xy - x * y;
    return n >= 3 && a > 0 && b > 0 ? c * c / (a * b) : no_number;
  }
};

struct Columns {
  std::vector<std::string> measure, unit, figure, plant, trait, held;
  std::vector<double> value, estimate, reference, error, relative;

  void add(const std::string& name, double v, const std::string& u, std::string_view p = {}) {
    measure.push_back(name);
    value.push_back(v);
    unit.push_back(u);
    figure.emplace_back(p);
  }
};

}  // namespace

PlantEvaluation evaluate_plants(const Table& estimate, const Table& reference) {
  const auto pairs = pairs_by_name(estimate, reference);
  Columns out;
  std::size_t traits = 0;
  for (const auto& column : reference.columns()) {
    const auto& name = column.name;
    const auto* other = estimate.find(name);
    if (other == nullptr || is_bound(name) || std::holds_alternative<std::vector<std::string>>(column.values) ||
        std::holds_alternative<std::vector<std::string>>(*other) || name == "plant_id")
      continue;
    const auto a = estimate.numbers(name), b = reference.numbers(name);
    const auto low = numbers_or_nan(estimate, bound_name(name, "lo")),
               high = numbers_or_nan(estimate, bound_name(name, "hi"));
    Sums s;
    for (const auto& [i, j] : pairs) {
      if (!std::isfinite(a[i]) || !std::isfinite(b[j]) || b[j] == 0) continue;
      const double e = a[i] - b[j];
      s.n += 1;
      s.relative += std::abs(e / b[j]);
      s.error += e;
      s.square += e * e;
      s.x += b[j];
      s.y += a[i];
      s.xx += b[j] * b[j];
      s.yy += a[i] * a[i];
      s.xy += a[i] * b[j];
      std::string held;
      if (std::isfinite(low[i]) && std::isfinite(high[i])) {
        const bool in = b[j] >= low[i] && b[j] <= high[i];
        held = in ? "yes" : "no";
        s.intervals += 1;
        s.held += in;
      }
      out.plant.push_back(estimate.has("plant_id") ? estimate.text("plant_id", i) : "");
      out.trait.push_back(name);
      out.estimate.push_back(a[i]);
      out.reference.push_back(b[j]);
      out.error.push_back(e);
      out.relative.push_back(100 * e / b[j]);
      out.held.push_back(held);
    }
    if (s.n == 0) continue;
    ++traits;
    const auto* figure = std::ranges::find(published, name, &std::pair<std::string_view, std::string_view>::first);
    const auto unit = unit_of_trait(name);
    out.add(name + "_plants", s.n, "");
    out.add(name + "_accuracy", 100 * (1 - s.relative / s.n), "%", figure != published.end() ? figure->second : "");
    out.add(name + "_bias", s.error / s.n, unit);
    out.add(name + "_rmse", std::sqrt(s.square / s.n), unit);
    out.add(name + "_r2", s.r2(), "");
    out.add(name + "_in_interval", s.intervals > 0 ? 100 * s.held / s.intervals : no_number, "%");
  }
  if (traits == 0) throw bad_input("the tables share no column of numbers with values", "height_mm and the like");
  PlantEvaluation result;
  result.summary.set("measure", out.measure);
  result.summary.set("value", out.value);
  result.summary.set("unit", out.unit);
  result.summary.set("published", out.figure);
  result.plants.set("plant_id", out.plant);
  result.plants.set("trait", out.trait);
  result.plants.set("value", out.estimate);
  result.plants.set("reference", out.reference);
  result.plants.set("error", out.error);
  result.plants.set("relative_error_percent", out.relative);
  result.plants.set("in_interval", out.held);
  return result;
}

}  // namespace bole::evaluation
