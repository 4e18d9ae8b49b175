// Whole blocks: rows found in mixed fields (one to three blocks, a third curved, gaps, headlands, strays), beside the
// truth, by `bole evaluate rows`' own measures.
//   block_rows [FIELDS [FIRST_SEED]]
#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "evaluation/core/evaluate_rows.h"
#include "rows/core/rows/find_rows.h"
#include "synthetic/plant_field.h"

namespace {

using namespace bole;

Table truth_of(const synthetic::PlantField& field) {
  std::vector<double> x, y, row;
  std::vector<std::string> state;
  for (const auto& p : field.plants) {
    if (p.row < 0) continue;
    x.push_back(p.at.x());
    y.push_back(p.at.y());
    row.push_back(p.row);
    state.emplace_back("present");
  }
  for (std::size_t r = 0; r < field.rows.size(); ++r)
    for (const auto& m : field.rows[r].missing_inside) {
      x.push_back(m.x());
      y.push_back(m.y());
      row.push_back(static_cast<double>(r));
      state.emplace_back("missing");
    }
  Table t;
  std::vector<std::int64_t> ids(row.begin(), row.end());
  t.set("row_id", ids);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("state", state);
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned fields = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 50;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1001;
  std::map<std::string, std::pair<double, double>> sums;  // measure: weighted sum, weight
  for (unsigned seed = first; seed < first + fields; ++seed) {
    const auto field = synthetic::mixed_field(seed);
    const auto found = rows::find_rows(field.table(), {}, {});
    evaluation::EvaluationOptions o;
    o.match_distance_m = field.plant_spacing_m / 3;
    const auto truth = truth_of(field);
    const auto result = evaluation::evaluate_rows(found.plants, truth, o);
    std::map<std::string, double> value;
    for (std::size_t i = 0; i < result.summary.rows(); ++i)
      value[result.summary.texts("measure")[i]] = result.summary.numbers("value")[i];
    double plants = 0, missing = 0, listed = 0;
    for (const auto& s : truth.texts("state")) ++(s == "present" ? plants : missing);
    for (const auto& s : found.plants.texts("state")) listed += s == "missing";
    const auto add = [&](const std::string& measure, double weight) {
      if (weight > 0) {
        sums[measure].first += value[measure] * weight;
        sums[measure].second += weight;
      }
    };
    add("row_recall", value["rows"]);
    add("row_precision", value["rows_found"]);
    add("plants_in_their_row", plants);
    add("missing_found", missing);
    add("missing_listed_right", listed);
    if (value["row_recall"] < 100 || value["row_precision"] < 100)
      fmt::print("  seed {}: {} rows, {} found, recall {:.1f} %, precision {:.1f} %\n", seed, value["rows"],
                 value["rows_found"], value["row_recall"], value["row_precision"]);
  }
  fmt::print("{} mixed fields, seeds from {}:\n", fields, first);
  for (const auto& [measure, sum] : sums)
    fmt::print("  {:<22} {:6.2f} % of {:.0f}\n", measure, sum.first / sum.second, sum.second);
  return 0;
}
