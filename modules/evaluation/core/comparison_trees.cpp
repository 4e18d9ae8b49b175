#include "evaluation/core/comparison_trees.h"

#include <array>
#include <map>
#include <set>

#include "base/no_number.h"
#include "cloud/table_columns.h"

namespace bole::evaluation {
namespace {

constexpr std::array columns_of_words{"name", "plot", "system", "against", "kind", "tree", "ref_tree"};
constexpr std::array values{"x_m",    "y_m",        "ref_x_m",      "ref_y_m",   "dx_m",     "dy_m",
                            "dbh_cm", "ref_dbh_cm", "dbh_error_cm", "dbh_lo_cm", "dbh_hi_cm"};

}  // namespace

void drop_uncounted(StemEvaluation& evaluation, const Table& stems) {
  if (!stems.has("counted") || !stems.has("tree_id")) return;
  std::set<std::string> uncounted;
  const auto counted = stems.numbers("counted");
  for (std::size_t i = 0; i < stems.rows(); ++i)
    if (counted[i] == 0) uncounted.insert(stems.text("tree_id", i));
  const auto& kind = evaluation.matches.texts("kind");
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] != "false" || !uncounted.contains(evaluation.matches.text("tree_id", i))) kept.push_back(i);
  evaluation.extra -= evaluation.matches.rows() - kept.size();
  evaluation.matches = evaluation.matches.subset(kept);
}

Table with_intervals(const Table& matches, const Table& stems) {
  Table out = matches;
  std::map<std::string, std::size_t> row_of;
  if (stems.has("tree_id"))
    for (std::size_t i = 0; i < stems.rows(); ++i) row_of.try_emplace(stems.text("tree_id", i), i);
  for (const char* column : {"dbh_lo_cm", "dbh_hi_cm"}) {
    const auto values = numbers_or_nan(stems, column);
    std::vector<double> found;
    for (std::size_t i = 0; i < matches.rows(); ++i) {
      const auto it = row_of.find(matches.text("tree_id", i));
      found.push_back(it == row_of.end() ? no_number : values[it->second]);
    }
    out.set(column, std::move(found));
  }
  return out;
}

Table trees_table(const std::vector<ComparedTrees>& parts) {
  std::vector<std::int64_t> run;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<std::string, std::vector<double>> numbers;
  for (const auto& part : parts) {
    const auto& m = part.matches;
    const auto names = texts_or_empty(m, "tree_name"), ref_names = texts_or_empty(m, "ref_name");
    const auto id_of = [&](const char* column, const std::string& name, std::size_t i) {
      return !name.empty() ? name : m.integers(column)[i] == 0 ? std::string() : m.text(column, i);
    };
    for (std::size_t i = 0; i < m.rows(); ++i) {
      run.push_back(part.run);
      texts["name"].push_back(part.name);
      texts["plot"].push_back(part.plot);
      texts["system"].push_back(part.system);
      texts["against"].push_back(part.against);
      texts["kind"].push_back(m.texts("kind")[i]);
      texts["tree"].push_back(id_of("tree_id", names[i], i));
      texts["ref_tree"].push_back(id_of("ref_id", ref_names[i], i));
    }
    for (const char* column : values) {
      const auto of_part = m.numbers(column);
      numbers[column].insert(numbers[column].end(), of_part.begin(), of_part.end());
    }
  }
  Table out;
  out.set("run", std::move(run));
  for (const char* column : columns_of_words) out.set(column, std::move(texts[column]));
  for (const char* column : values) out.set(column, std::move(numbers[column]));
  return out;
}

}  // namespace bole::evaluation
