#include "report/core/evaluation_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/value_rows.h"

namespace bole::report {
namespace {

struct Display {
  std::string_view measure;  // of the summary table
  std::string_view title;
  int decimals;
};

struct Group {
  std::string_view title;
  std::vector<Display> rows;
};

// Names and order in which a person reads the measures. Measures that stand nowhere here come last under their own
// names.
const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"Detection",
       {{"reference_trees", "Reference trees", 0},
        {"matched", "Found", 0},
        {"missed", "Missed", 0},
        {"false", "False", 0},
        {"completeness", "Completeness", 1},
        {"correctness", "Correctness", 1}}},
      {"Position",
       {{"position_mean_x", "Mean error in x", 3},
        {"position_mean_y", "Mean error in y", 3},
        {"position_sigma_x", "Standard deviation in x", 3},
        {"position_sigma_y", "Standard deviation in y", 3},
        {"position_cov_xy", "Covariance of x and y", 4},
        {"position_sigma_max", "Largest standard deviation in any direction", 3},
        {"position_rmse_x", "RMSE in x", 3},
        {"position_rmse_y", "RMSE in y", 3}}},
      {"DBH",
       {{"dbh_bias", "DBH bias", 2},
        {"dbh_relative_bias", "DBH bias, relative", 2},
        {"dbh_rmse", "DBH RMSE", 2},
        {"dbh_relative_rmse", "DBH RMSE, relative", 2},
        {"dbh_interval_coverage", "Intervals that hold the reference", 1}}},
      {"Height",
       {{"height_trees", "Trees whose top was seen", 0},
        {"height_bias", "Height bias", 2},
        {"height_rmse", "Height RMSE", 2}}},
      {"Alignment of the trees before the comparison",
       {{"align_turn", "Turned by", 2}, {"align_shift_x", "Moved in x", 3}, {"align_shift_y", "Moved in y", 3}}},
  };
  return all;
}

const Group& walk_group() {
  static const Group group{
      "Path of the scanner",
      {{"poses", "Poses compared", 0},
       {"length", "Length of the walk", 1},
       {"ate_rmse", "Absolute trajectory error (ATE) after alignment, RMSE", 3},
       {"rotation_error_rmse", "Rotation error, RMSE", 3},
       {"rpe_translation_rmse", "Relative pose error (RPE) over a step of time, translation, RMSE", 3},
       {"rpe_rotation_rmse", "The same, rotation, RMSE", 3},
       {"rpe_distance_translation_rmse", "Relative pose error (RPE) over a distance walked, translation, RMSE", 3},
       {"rpe_distance_rotation_rmse", "The same, rotation, RMSE", 3},
       {"length_error", "Length of such steps, too long (negative: too short)", 2},
       {"kitti_segments", "Segments compared as KITTI does", 0},
       {"kitti_translation", "Mean error over these segments, translation", 3},
       {"kitti_rotation", "Mean error over these segments, rotation", 3},
       {"end_error", "Error at the end of the walk, its beginning laid over the reference", 3},
       {"drift", "The same by the length walked", 3}}};
  return group;
}

// Families of measures that fold away, as one row each: name_ending.
constexpr std::array<Display, 6> spreads{
    {{"ate", "Absolute trajectory error after alignment", 3},
     {"rotation_error", "Rotation error", 3},
     {"rpe_translation", "Relative pose error over a step of time, translation", 3},
     {"rpe_rotation", "Relative pose error over a step of time, rotation", 3},
     {"rpe_distance_translation", "Relative pose error over a distance, translation", 3},
     {"rpe_distance_rotation", "Relative pose error over a distance, rotation", 3}}};
constexpr std::array<Display, 5> spread_columns{{{"rmse", "RMSE", 3},
                                                 {"mean", "Mean", 3},
                                                 {"median", "Median", 3},
                                                 {"sd", "Standard deviation", 3},
                                                 {"max", "Largest", 3}}};
constexpr std::array<Display, 5> class_columns{{{"trees", "Trees", 0},
                                                {"completeness", "Completeness (%)", 1},
                                                {"correctness", "Correctness (%)", 1},
                                                {"bias", "DBH bias (cm)", 2},
                                                {"rmse", "DBH RMSE (cm)", 2}}};

struct EvaluationMeasure {
  std::string name, unit, published;
  double value = 0;
  bool told = false;
};

class EvaluationSection {
 public:
  EvaluationSection(const Table& summary, bool poses_given) : poses_given_(poses_given) {
    if (const auto it = summary.facts.find("published"); it != summary.facts.end())
      published_heading_ += ": " + it->second;
    const auto name = texts_or_empty(summary, "measure"), unit = texts_or_empty(summary, "unit"),
               published = texts_or_empty(summary, "published");
    const auto value = numbers_or_nan(summary, "value");
    for (std::size_t i = 0; i < summary.rows(); ++i) measures_.push_back({name[i], unit[i], published[i], value[i]});
    for (std::size_t i = 0; i < measures_.size(); ++i) at_.try_emplace(measures_[i].name, i);
  }

  std::string trees_html() {
    std::string main;
    for (const auto& group : groups()) main += group_html(group);
    return main + classes_html("dbh_", "By diameter class", "DBH (cm)") +
           classes_html("distance_", "By distance from the centre of the plot", "Distance (m)");
  }

  std::string walk_html() {
    for (const auto& group : groups()) group_html(group);  // what they tell is no other measure
    return group_html(walk_group()) + others_html() + spreads_html();
  }

 private:
  EvaluationMeasure* find(const std::string& name) {
    const auto it = at_.find(name);
    return it == at_.end() ? nullptr : &measures_[it->second];
  }

  std::string value_text(const EvaluationMeasure& m, int decimals) const {
    const auto text = render::fixed(m.value, decimals);
    const bool of_the_walk = m.name.starts_with("ate") || m.name.starts_with("rotation_error") ||
                             m.name.starts_with("rpe") || m.name == "end_error" || m.name == "drift";
    return poses_given_ && of_the_walk && text == render::fixed(0, decimals) ? "given poses" : text;
  }

  std::string table_of(std::string_view title, const std::vector<std::vector<std::string>>& rows) const {
    if (rows.empty()) return {};
    const bool published = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return !row[3].empty(); });
    HtmlTable table{{{std::string(title)}, {"This run", true}, {"Unit"}}, rows, false};
    if (published) table.columns.push_back({published_heading_, true});
    return table.html();
  }

  std::string group_html(const Group& group) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& d : group.rows)
      if (auto* m = find(std::string(d.measure))) {
        m->told = true;
        rows.push_back({std::string(d.title), value_text(*m, d.decimals), unit_text(m->unit), published_text(*m)});
      }
    return table_of(group.title, rows);
  }

  static std::string published_text(const EvaluationMeasure& m) {
    return m.published.starts_with('-') ? "\u2212" + m.published.substr(1) : m.published;
  }

  // "dbh_20_to_24_cm_bias": one row for each class, in the order of the table.
  std::string classes_html(const std::string& prefix, const std::string& title, const std::string& heading) {
    HtmlTable table{{{heading}}, {}, false};
    for (const auto& c : class_columns) table.columns.push_back({std::string(c.title), true});
    const std::string first = "_" + std::string(class_columns[0].measure);
    for (const auto& m : std::vector<EvaluationMeasure>(measures_)) {
      if (!m.name.starts_with(prefix) || m.name.find("_to_") == std::string::npos || !m.name.ends_with(first)) continue;
      const auto family = m.name.substr(0, m.name.size() - first.size());
      std::vector<std::string> row{class_name(family.substr(prefix.size()))};
      for (const auto& c : class_columns) row.push_back(cell(family, c));
      table.rows.push_back(std::move(row));
    }
    return folded(title, table);
  }

  // "20_to_24_cm" as "20–24"
  static std::string class_name(const std::string& text) {
    const auto to = text.find("_to_");
    return text.substr(0, to) + "–" + text.substr(to + 4, text.rfind('_') - to - 4);
  }

  std::string cell(const std::string& family, const Display& column) {
    auto* m = find(family + "_" + std::string(column.measure));
    if (m == nullptr) return {};
    m->told = true;
    return value_text(*m, column.decimals);
  }

  std::string spreads_html() {
    HtmlTable table{{{"Error"}}, {}, false};
    for (const auto& c : spread_columns) table.columns.push_back({std::string(c.title), true});
    table.columns.push_back({"Unit"});
    for (const auto& s : spreads) {
      const auto* m = find(std::string(s.measure) + "_rmse");
      if (m == nullptr) continue;
      std::vector<std::string> row{std::string(s.title)};
      for (const auto& c : spread_columns) row.push_back(cell(std::string(s.measure), c));
      row.push_back(unit_text(m->unit));
      table.rows.push_back(std::move(row));
    }
    return folded("Spread of the errors of the walk", table);
  }

  std::string others_html() {
    std::vector<std::vector<std::string>> rows;
    for (const auto& m : measures_) {
      const bool folds_away =
          m.name.find("_to_") != std::string::npos ||
          std::any_of(spreads.begin(), spreads.end(), [&](const Display& s) { return m.name.starts_with(s.measure); });
      if (m.told || folds_away) continue;
      auto name = m.name;
      std::replace(name.begin(), name.end(), '_', ' ');
      rows.push_back(
          {name, value_text(m, m.value == std::round(m.value) ? 0 : 3), unit_text(m.unit), published_text(m)});
    }
    return table_of("Other measures", rows);
  }

  std::vector<EvaluationMeasure> measures_;
  std::map<std::string, std::size_t> at_;
  bool poses_given_;
  std::string published_heading_ = "Published";  // with the system and the plot
};

}  // namespace

std::string evaluation_html(const Table& summary) { return EvaluationSection(summary, false).trees_html(); }

std::string walk_evaluation_html(const Table& summary, bool poses_given) {
  return EvaluationSection(summary, poses_given).walk_html();
}

}  // namespace bole::report
