#include "report/core/stem_sections.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"

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

// Which of the stems listed count in no value of the plot, and why.
std::string uncounted_note(const SurveyData& d, const std::vector<std::size_t>& rows) {
  const auto counted = counted_rows(*d.stems, d.rule);
  std::string ids;
  for (const auto i : rows)
    if (!std::binary_search(counted.begin(), counted.end(), i))
      ids += (ids.empty() ? "" : ", ") +
             (d.stems->has("tree_id") ? d.stems->text("tree_id", i, 0) : std::to_string(i + 1));
  if (ids.empty()) return {};
  const std::string thin = d.rule.min_dbh_cm > 0 ? "thinner than " + render::fixed(d.rule.min_dbh_cm, 1) + " cm, " : "";
  return paragraph("Counted in no value of the plot (" + thin + "without DBH, or rejected by hand): " + ids + ".",
                   "note");
}

// Whether a person has looked at the stem and said what it is.
bool decided(const std::string& state) { return state == "accepted" || state == "edited" || state == "rejected"; }

// The tables are written in ASCII; the page is not.
std::string typeset(std::string text) {
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("+-", "±");
  replace(" deg", "°");
  return text;
}

std::string trees_to_check(const SurveyData& d, Report& told) {
  if (d.stems == nullptr) return {};
  const auto state = texts_or_empty(*d.stems, "state"), quality = texts_or_empty(*d.stems, "quality"),
             reasons = texts_or_empty(*d.stems, "reasons");
  const auto dbh = numbers_or_nan(*d.stems, "dbh_cm"), x = numbers_or_nan(*d.stems, "x_m"),
             y = numbers_or_nan(*d.stems, "y_m");
  HtmlTable table{{{"Tree", true}, {"DBH (cm)", true}, {"Quality"}, {"Why it should be checked"}}, {}, true};
  std::size_t outside = 0;
  for (std::size_t i = 0; i < d.stems->rows(); ++i) {
    if (decided(state[i]) || (state[i] != "check" && quality[i] != "poor")) continue;
    if (!d.rule.area.contains(x[i], y[i]))
      ++outside;
    else
      table.rows.push_back({d.stems->has("tree_id") ? d.stems->text("tree_id", i, 0) : std::to_string(i + 1),
                            render::fixed(dbh[i], 1), quality[i], typeset(reasons[i])});
  }
  told.counts["trees_to_check"] = std::ssize(table.rows);
  told.counts["trees_to_check_outside"] = static_cast<std::int64_t>(outside);
  std::string body;
  if (!table.rows.empty())
    body = "<h3>Trees to check (" + std::to_string(table.rows.size()) + ")</h3>\n" + table.html();
  return body + outside_note(outside, {"stem to check", "stems to check"}, "stems.csv");
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
                 paragraph(text, "note") + paragraph("A click on a heading sorts.", "note screen") +
                     stem_table(*d.stems, rows).html() + uncounted_note(d, rows) +
                     outside_note(d.stems->rows() - rows.size(), {"stem", "stems"}, "stems.csv"));
}

std::string check_section(const SurveyData& d, const std::vector<std::string>& warnings, Report& told) {
  std::string body;
  if (!warnings.empty()) {
    body += "<ul>\n";
    for (const auto& w : warnings) body += "<li>" + escaped(w) + "</li>\n";
    body += "</ul>\n";
  }
  body += trees_to_check(d, told);
  body += edits_by_hand(d, told);
  body += rejected_candidates(d, told);
  if (body.empty()) body = paragraph("Nothing: no warnings, no tree asks to be checked.");
  return section("check", "What to look at", body);
}

}  // namespace bole::report
