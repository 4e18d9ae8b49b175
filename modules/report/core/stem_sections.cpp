#include "report/core/stem_sections.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/look_list.h"

namespace bole::report {
namespace {

struct StemColumn {
  const char* column;
  const char* title;
  int decimals;
};

// Those of the stem table that a reader wants, where they are present.
constexpr StemColumn stem_columns[] = {
    {"tree_id", "Tree", 0},     {"x_m", "x (m)", 2},     {"y_m", "y (m)", 2},           {"dbh_cm", "DBH (cm)", 1},
    {"dbh_lo_cm", "from", 1},   {"dbh_hi_cm", "to", 1},  {"height_m", "Height (m)", 1}, {"lean_deg", "Lean (°)", 1},
    {"arc_deg", "Arc (°)", 0},  {"passes", "Passes", 0}, {"sigma_cm", "σ (cm)", 2},     {"inliers", "Points", 0},
    {"quality", "Quality", -1}, {"state", "State", -1}};

std::string stem_cell(const Table& stems, const StemColumn& column, double height_seen, std::size_t row) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(stems.find(column.column))) return (*texts)[row];
  const std::string_view name = column.column;
  if (name == "tree_id") return stems.text(name, row, 0);
  const double value = (name == "height_m" ? known_heights(stems) : numbers_or_nan(stems, name))[row];
  const bool lower_bound = name == "height_m" && height_seen == 0 && std::isfinite(value);
  return (lower_bound ? "≥ " : "") + render::fixed(value, column.decimals);
}

HtmlTable stem_table(const Table& stems, const std::vector<std::size_t>& rows) {
  const auto seen = numbers_or_nan(stems, "height_seen");
  HtmlTable table;
  table.sortable = true;
  std::vector<StemColumn> used;
  for (const auto& c : stem_columns)
    if (stems.has(c.column)) {
      used.push_back(c);
      table.columns.push_back({c.title, c.decimals >= 0});
    }
  for (const auto i : rows) {
    std::vector<std::string> cells;
    for (const auto& c : used) cells.push_back(stem_cell(stems, c, seen[i], i));
    table.rows.push_back(std::move(cells));
    table.trees.push_back(tree_name(stems, i));
  }
  return table;
}

std::vector<std::size_t> rows_inside(const Table& table, const PlotArea& area) {
  const auto x = numbers_or_nan(table, "x_m"), y = numbers_or_nan(table, "y_m");
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (area.contains(x[i], y[i])) rows.push_back(i);
  return rows;
}

// "12 stems outside the plot are in stems.csv."; empty for none. `what`: the words for one and for several.
std::string outside_note(std::size_t outside, const std::pair<std::string, std::string>& what,
                         const std::string& file) {
  if (outside == 0) return {};
  return paragraph(std::to_string(outside) + " " + (outside == 1 ? what.first : what.second) + " outside the plot " +
                       (outside == 1 ? "is" : "are") + " in " + file + ".",
                   "note");
}

// "trees 3, 7 and 9"
std::string trees_text(const std::vector<std::string>& names) {
  std::string text = names.size() == 1 ? "tree " : "trees ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

// Which of the stems listed count in no value of the plot, and why.
std::string uncounted_note(const SurveyData& d, const std::vector<std::size_t>& rows) {
  const auto counted = counted_rows(*d.stems, d.rule);
  const auto state = texts_or_empty(*d.stems, "state");
  const auto dbh = numbers_or_nan(*d.stems, "dbh_cm");
  std::vector<std::string> rejected, unknown, thin;
  for (const auto i : rows) {
    if (std::binary_search(counted.begin(), counted.end(), i)) continue;
    auto& why = state[i] == "rejected" ? rejected : std::isfinite(dbh[i]) ? thin : unknown;
    why.push_back(tree_name(*d.stems, i));
  }
  std::string text;
  const auto add = [&](const std::vector<std::string>& names, const std::string& why) {
    if (!names.empty()) text += (text.empty() ? "" : "; ") + trees_text(names) + " (" + why + ")";
  };
  add(thin, "thinner than " + render::fixed(d.rule.min_dbh_cm, 1) + " cm");
  add(unknown, "without a diameter");
  add(rejected, "rejected by hand");
  if (text.empty()) return {};
  return paragraph("Listed here, but not part of the values of the plot: " + text + ".", "note uncounted");
}

std::string trees_to_check(const SurveyData& d, Report& told) {
  if (d.stems == nullptr) return {};
  const auto look = trees_to_look_at(d);
  const auto quality = texts_or_empty(*d.stems, "quality"), reasons = texts_or_empty(*d.stems, "reasons");
  const auto dbh = numbers_or_nan(*d.stems, "dbh_cm");
  HtmlTable table{{{"Tree", true}, {"DBH (cm)", true}, {"Quality"}, {"Why"}}, {}, true};
  for (const auto i : look.rows) {
    table.trees.push_back(tree_name(*d.stems, i));
    table.rows.push_back({table.trees.back(), render::fixed(dbh[i], 1), quality[i], typeset(reasons[i])});
  }
  told.counts["trees_to_check"] = std::ssize(table.rows);
  told.counts["trees_to_check_outside"] = static_cast<std::int64_t>(look.outside);
  told.counts["stems_in_plot"] = static_cast<std::int64_t>(look.in_plot);
  std::string body;
  if (!table.rows.empty())
    body = "<h3>Trees to look at in the plot (" + std::to_string(table.rows.size()) + ")</h3>\n" + table.html();
  return body + outside_note(look.outside, {"stem to look at", "stems to look at"}, "stems.csv");
}

std::string rejected_candidates(const SurveyData& d, Report& told) {
  if (d.rejected == nullptr || d.rejected->rows() == 0) return {};
  const auto rows = rows_inside(*d.rejected, d.rule.area);
  HtmlTable table{{{"x (m)", true}, {"y (m)", true}, {"Points", true}, {"Why it is no stem"}}, {}, true};
  const auto x = numbers_or_nan(*d.rejected, "x_m"), y = numbers_or_nan(*d.rejected, "y_m"),
             points = numbers_or_nan(*d.rejected, "points");
  const auto reason = texts_or_empty(*d.rejected, "reason");
  for (const auto i : rows)
    table.rows.push_back(
        {render::fixed(x[i], 2), render::fixed(y[i], 2), render::fixed(points[i], 0), typeset(reason[i])});
  told.counts["rejected_candidates"] = std::ssize(rows);
  told.counts["rejected_candidates_outside"] = std::ssize(reason) - std::ssize(rows);
  return "<details><summary>Rejected candidates (" + std::to_string(rows.size()) + ")</summary>\n" + table.html() +
         outside_note(d.rejected->rows() - rows.size(), {"candidate", "candidates"}, "rejected.csv") + "</details>\n";
}

std::string edits_by_hand(const SurveyData& d, Report& told) {
  if (d.edits == nullptr || d.edits->rows() == 0) return {};
  HtmlTable table{{{"Edit", true},
                   {"What", false},
                   {"Tree", true},
                   {"Outcome", false},
                   {"Who", false},
                   {"When", false},
                   {"Why", false}},
                  {},
                  true};
  const auto number = numbers_or_nan(*d.edits, "edit"), tree = numbers_or_nan(*d.edits, "tree_id");
  const auto action = texts_or_empty(*d.edits, "action"), outcome = texts_or_empty(*d.edits, "outcome"),
             message = texts_or_empty(*d.edits, "message"), author = texts_or_empty(*d.edits, "author"),
             time = texts_or_empty(*d.edits, "time"), reason = texts_or_empty(*d.edits, "reason");
  for (std::size_t i = 0; i < d.edits->rows(); ++i)
    table.rows.push_back({render::fixed(number[i], 0), action[i], tree[i] > 0 ? render::fixed(tree[i], 0) : "",
                          outcome[i] + (message[i].empty() ? "" : ": " + typeset(message[i])), author[i], time[i],
                          reason[i]});
  told.counts["edits"] = static_cast<std::int64_t>(d.edits->rows());
  return "<h3>Edits by hand (" + std::to_string(d.edits->rows()) + ")</h3>\n" + table.html();
}

// Fields that narrow the table down; the script of the page works them.
std::string table_tools() {
  return "<p class=\"tools screen\"><label>Find <input id=\"find\" type=\"search\" placeholder=\"tree or "
         "reason\"/></label> "
         "<label>Quality <select id=\"quality\"><option value=\"\">all</option><option>good</option>"
         "<option>fair</option><option>poor</option></select></label> "
         "<label><input id=\"only-look\" type=\"checkbox\"/> only trees to look at</label> "
         "<output id=\"shown\"></output></p>\n";
}

}  // namespace

std::string stems_section(const SurveyData& d, Report& told) {
  if (d.stems == nullptr) return {};
  const auto rows = rows_inside(*d.stems, d.rule.area);
  std::string text = "Diameters at breast height with their 95 % interval.";
  const auto seen = numbers_or_nan(*d.stems, "height_seen");
  if (std::any_of(rows.begin(), rows.end(), [&](std::size_t i) { return seen[i] == 0; }))
    text += " Heights with ≥ are lower bounds: the top was not seen.";
  told.counts["stems_listed"] = std::ssize(rows);
  told.counts["stems_outside"] = std::ssize(seen) - std::ssize(rows);
  return section("stems", "Stems",
                 paragraph(text, "note") +
                     paragraph("A click on a heading sorts, a click on a row shows the tree in the plan, in its slice "
                               "and in the 3-D view.",
                               "note screen") +
                     table_tools() + "<div class=\"scroll\">\n" + stem_table(*d.stems, rows).html() + "</div>\n" +
                     uncounted_note(d, rows) +
                     outside_note(d.stems->rows() - rows.size(), {"stem", "stems"}, "stems.csv"));
}

std::string check_section(const SurveyData& d, const std::vector<std::string>& warnings, Report& told) {
  std::string body = trees_to_check(d, told);
  body += edits_by_hand(d, told);
  if (!warnings.empty()) {
    body += "<h3>Notes of the stages (" + std::to_string(warnings.size()) + ")</h3>\n<ul class=\"notes\">\n";
    told.counts["warnings_listed"] = std::ssize(warnings);
    for (const auto& w : warnings) body += "<li>" + escaped(typeset(w)) + "</li>\n";
    body += "</ul>\n";
  }
  body += rejected_candidates(d, told);
  if (body.empty()) body = paragraph("Nothing: no warnings, and no tree asks for a look.");
  return section("check", "What to look at", body);
}

}  // namespace bole::report
