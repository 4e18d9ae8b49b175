#include "report/core/report_page.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "report/core/evaluation_section.h"
#include "report/core/html.h"
#include "report/core/page_style.h"
#include "report/core/slam_section.h"

namespace bole::report {
namespace {

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return "<section id=\"" + id + "\">\n<h2>" + escaped(title) + "</h2>\n" + body + "</section>\n";
}

std::string paragraph(const std::string& text, const std::string& css = {}) {
  return "<p" + (css.empty() ? std::string() : " class=\"" + css + "\"") + ">" + escaped(text) + "</p>\n";
}

std::string cards(const PlotMetrics& m) {
  const auto card = [](const std::string& value, const std::string& unit, const std::string& name) {
    return "<div class=\"card\"><b>" + escaped(value) + "</b> <span>" + escaped(unit) + "</span><br>" + escaped(name) +
           "</div>\n";
  };
  std::string out = "<div class=\"cards\">\n" + card(std::to_string(m.stems), "", "stems");
  if (std::isfinite(m.area_m2))
    out += card(render::fixed(m.stems_per_ha, 0), "1/ha", "stem density") +
           card(render::fixed(m.basal_area_m2_per_ha, 1), "m²/ha", "basal area");
  out += card(render::fixed(m.mean_dbh_cm, 1), "cm", "mean DBH") +
         card(render::fixed(m.quadratic_mean_dbh_cm, 1), "cm", "quadratic mean diameter");
  return out + "</div>\n";
}

std::string metrics_section(const ReportContent& c) {
  HtmlTable table{{{"Measure"}, {"Value", true}, {"Unit"}, {"How"}}, {}, false};
  for (const auto& row : metric_rows(c.metrics, c.rule.min_dbh_cm))
    table.rows.push_back({row.name, row.value, row.unit, row.how});
  std::string body = table.html();
  if (!std::isfinite(c.metrics.area_m2))
    body =
        paragraph(
            "No plot boundary is set, so there are no values per hectare. Where the plot is known, set shape and width "
            "and length (or radius) of the stage survey.plot and connect its plot to the report.",
            "note") +
        body;
  const bool per_ha = std::isfinite(c.metrics.area_m2);
  HtmlTable classes{{{"DBH class (cm)"}, {"Stems", true}}, {}, false};
  if (per_ha) classes.columns.push_back({"1/ha", true});
  classes.columns.push_back({per_ha ? "Basal area (m²/ha)" : "Basal area (m²)", true});
  if (c.metrics.heights_known) classes.columns.push_back({"Mean height of tops seen (m)", true});
  const auto whole = [](const DiameterClass& k) {
    return k.lo_cm == std::round(k.lo_cm) && k.hi_cm == std::round(k.hi_cm);
  };
  const int decimals = std::ranges::all_of(c.metrics.classes, whole) ? 0 : 1;
  for (const auto& k : c.metrics.classes) {
    std::vector<std::string> row{render::fixed(k.lo_cm, decimals) + "–" + render::fixed(k.hi_cm, decimals),
                                 std::to_string(k.stems)};
    if (per_ha) row.push_back(render::fixed(k.stems_per_ha, 0));
    row.push_back(per_ha ? render::fixed(k.basal_area_m2_per_ha, 2) : render::fixed(k.basal_area_m2, 3));
    if (c.metrics.heights_known) row.push_back(render::fixed(k.mean_height_m, 1));
    classes.rows.push_back(std::move(row));
  }
  if (!classes.rows.empty()) body += "<h3>By diameter class</h3>\n" + classes.html();
  return section("plot", "The plot", body);
}

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
  const double value = render::numbers_or_nan(stems, name)[row];
  const bool lower_bound = name == "height_m" && height_seen == 0 && std::isfinite(value);
  return (lower_bound ? "≥ " : "") + render::fixed(value, column.decimals);
}

HtmlTable stem_table(const Table& stems, const std::vector<std::size_t>& rows) {
  const auto seen = render::numbers_or_nan(stems, "height_seen");
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
  const auto x = render::numbers_or_nan(table, "x_m"), y = render::numbers_or_nan(table, "y_m");
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
std::string uncounted_note(const ReportContent& c, const std::vector<std::size_t>& rows) {
  const auto counted = counted_stems(*c.stems, c.rule);
  std::string ids;
  for (const auto i : rows)
    if (!std::binary_search(counted.begin(), counted.end(), i))
      ids += (ids.empty() ? "" : ", ") +
             (c.stems->has("tree_id") ? c.stems->text("tree_id", i, 0) : std::to_string(i + 1));
  if (ids.empty()) return {};
  const std::string thin = c.rule.min_dbh_cm > 0 ? "thinner than " + render::fixed(c.rule.min_dbh_cm, 1) + " cm, " : "";
  return paragraph("Counted in no value of the plot (" + thin + "without DBH, or rejected by hand): " + ids + ".",
                   "note");
}

std::string stems_section(const ReportContent& c) {
  if (c.stems == nullptr) return {};
  const auto rows = rows_inside(*c.stems, c.rule.area);
  std::string text = "Diameters at breast height with their 95 % interval.";
  const auto seen = render::numbers_or_nan(*c.stems, "height_seen");
  if (std::any_of(rows.begin(), rows.end(), [&](std::size_t i) { return seen[i] == 0; }))
    text += " Heights with ≥ are lower bounds: the top was not seen.";
  return section("stems", "Stems",
                 paragraph(text, "note") + paragraph("A click on a heading sorts.", "note screen") +
                     stem_table(*c.stems, rows).html() + uncounted_note(c, rows) +
                     outside_note(c.stems->rows() - rows.size(), {"stem", "stems"}, "stems.csv"));
}

// Whether a person has looked at the stem and said what it is.
bool decided(const std::string& state) { return state == "accepted" || state == "edited" || state == "rejected"; }

// The tables are written in ASCII; the page is not.
std::string typeset(std::string text) {
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("+-", "±"), replace(" deg", "°");
  return text;
}

std::string trees_to_check(const ReportContent& c) {
  if (c.stems == nullptr) return {};
  const auto state = render::texts_or_empty(*c.stems, "state"), quality = render::texts_or_empty(*c.stems, "quality"),
             reasons = render::texts_or_empty(*c.stems, "reasons");
  const auto dbh = render::numbers_or_nan(*c.stems, "dbh_cm"), x = render::numbers_or_nan(*c.stems, "x_m"),
             y = render::numbers_or_nan(*c.stems, "y_m");
  HtmlTable table{{{"Tree", true}, {"DBH (cm)", true}, {"Quality"}, {"Why it should be checked"}}, {}, true};
  std::size_t outside = 0;
  for (std::size_t i = 0; i < c.stems->rows(); ++i) {
    if (decided(state[i]) || (state[i] != "check" && quality[i] != "poor")) continue;
    if (!c.rule.area.contains(x[i], y[i]))
      ++outside;
    else
      table.rows.push_back({c.stems->has("tree_id") ? c.stems->text("tree_id", i, 0) : std::to_string(i + 1),
                            render::fixed(dbh[i], 1), quality[i], typeset(reasons[i])});
  }
  std::string body;
  if (!table.rows.empty())
    body = "<h3>Trees to check (" + std::to_string(table.rows.size()) + ")</h3>\n" + table.html();
  return body + outside_note(outside, {"stem to check", "stems to check"}, "stems.csv");
}

std::string rejected_candidates(const ReportContent& c) {
  if (c.rejected == nullptr || c.rejected->rows() == 0) return {};
  const auto rows = rows_inside(*c.rejected, c.rule.area);
  HtmlTable table{{{"x (m)", true}, {"y (m)", true}, {"Points", true}, {"Why it is no stem"}}, {}, true};
  const auto x = render::numbers_or_nan(*c.rejected, "x_m"), y = render::numbers_or_nan(*c.rejected, "y_m"),
             points = render::numbers_or_nan(*c.rejected, "points");
  const auto reason = render::texts_or_empty(*c.rejected, "reason");
  for (const auto i : rows)
    table.rows.push_back(
        {render::fixed(x[i], 2), render::fixed(y[i], 2), render::fixed(points[i], 0), typeset(reason[i])});
  return "<details><summary>Rejected candidates (" + std::to_string(rows.size()) + ")</summary>\n" + table.html() +
         outside_note(c.rejected->rows() - rows.size(), {"candidate", "candidates"}, "rejected.csv") + "</details>\n";
}

std::string edits_by_hand(const ReportContent& c) {
  if (c.edits == nullptr || c.edits->rows() == 0) return {};
  HtmlTable table{{{"Edit", true},
                   {"What", false},
                   {"Tree", true},
                   {"Outcome", false},
                   {"Who", false},
                   {"When", false},
                   {"Why", false}},
                  {},
                  true};
  const auto number = render::numbers_or_nan(*c.edits, "edit"), tree = render::numbers_or_nan(*c.edits, "tree_id");
  const auto action = render::texts_or_empty(*c.edits, "action"), outcome = render::texts_or_empty(*c.edits, "outcome"),
             message = render::texts_or_empty(*c.edits, "message"), author = render::texts_or_empty(*c.edits, "author"),
             time = render::texts_or_empty(*c.edits, "time"), reason = render::texts_or_empty(*c.edits, "reason");
  for (std::size_t i = 0; i < c.edits->rows(); ++i)
    table.rows.push_back({render::fixed(number[i], 0), action[i], tree[i] > 0 ? render::fixed(tree[i], 0) : "",
                          outcome[i] + (message[i].empty() ? "" : ": " + typeset(message[i])), author[i], time[i],
                          reason[i]});
  return "<h3>Edits by hand (" + std::to_string(c.edits->rows()) + ")</h3>\n" + table.html();
}

std::string check_section(const ReportContent& c) {
  std::string body;
  if (!c.warnings.empty()) {
    body += "<ul>\n";
    for (const auto& w : c.warnings) body += "<li>" + escaped(w) + "</li>\n";
    body += "</ul>\n";
  }
  body += trees_to_check(c) + edits_by_hand(c) + rejected_candidates(c);
  if (body.empty()) body = paragraph("Nothing: no warnings, no tree asks to be checked.");
  return section("check", "What to look at", body);
}

std::string pictures_section(const ReportContent& c) {
  std::string body;
  for (const auto& p : c.pictures)
    body += std::string("<figure") + (p.wide ? "" : " class=\"half\"") + "><img src=\"" +
            data_uri(p.media_type, p.bytes) + "\" alt=\"" + escaped(p.title) + "\"><figcaption><b>" + escaped(p.title) +
            ".</b> " + escaped(p.caption) + "</figcaption></figure>\n";
  return body.empty() ? std::string() : section("figures", "Figures", "<div class=\"figures\">\n" + body + "</div>\n");
}

std::string evaluation_section(const ReportContent& c) {
  if (c.summary == nullptr || c.summary->rows() == 0) return {};
  std::string note = "Compared with the reference that was given.";
  const auto published = render::texts_or_empty(*c.summary, "published");
  if (std::any_of(published.begin(), published.end(), [](const auto& text) { return !text.empty(); }))
    note +=
        " Published: the figures of the method's paper, from other plots; they stand beside ours and do not replace "
        "them.";
  if (c.poses_given)
    note += " The poses of the walk were given to this run, so errors of the walk tell nothing about SLAM.";
  return section("evaluation", "Against the reference",
                 paragraph(note, "note") + evaluation_html(*c.summary, c.poses_given));
}

std::string slam_section(const ReportContent& c) {
  std::string body;
  if (c.record != nullptr)
    for (const auto& stage : c.record->stages)
      if (stage.type == "slam.run") body += slam_html(stage, c.loops, c.odometry);
  return body.empty() ? std::string() : section("slam", "SLAM", body);
}

std::string stage_options(const StageRecord& stage) {
  HtmlTable table{{{"Option"}, {"Value", true}, {"Unit"}, {""}}, {}, false};
  for (const auto& o : stage.options)
    table.rows.push_back({o.name, o.value.empty() ? "–" : o.value, o.unit, o.is_default ? "" : "changed"});
  const bool changed =
      std::any_of(stage.options.begin(), stage.options.end(), [](const auto& o) { return !o.is_default; });
  return "<details><summary><b>" + escaped(stage.id) + "</b> (" + escaped(stage.type) + ")" +
         (changed ? ", changed options" : "") + "</summary>\n" +
         (table.rows.empty() ? paragraph("no options") : table.html()) + "</details>\n";
}

std::string run_section(const ReportContent& c) {
  std::string body;
  if (c.record != nullptr && !c.record->stages.empty()) {
    HtmlTable table{{{"Stage"}, {"Type"}, {"Time (s)", true}, {"Peak memory (MiB)", true}, {"Result"}}, {}, false};
    double total = 0;
    for (const auto& s : c.record->stages) {
      total += s.report.seconds;
      table.rows.push_back({s.id, s.type, s.from_cache ? "stored" : render::fixed(s.report.seconds, 1),
                            s.report.peak_mib > 0 ? render::fixed(s.report.peak_mib, 0) : "", s.report.message});
    }
    table.rows.push_back({"all", "", render::fixed(total, 1), "", ""});
    body += "<h3>Stages</h3>\n" + table.html() + "<h3>Options</h3>\n";
    for (const auto& s : c.record->stages) body += stage_options(s);
  }
  HtmlTable versions{{{"Program"}, {"Version"}}, {}, false};
  for (const auto& [name, version] : c.versions) versions.rows.push_back({name, version});
  body += "<h3>Versions</h3>\n" + versions.html();
  if (!c.files.empty()) {
    body += "<h3>Files of this run</h3>\n<p class=\"files\">";
    for (const auto& f : c.files) body += "<code>" + escaped(f) + "</code> ";
    body += "</p>\n";
  }
  return section("run", "How it was made", body);
}

// To be filled in by hand on paper.
std::string signature() {
  HtmlTable table{{{"Name"}, {"Date"}, {"Signature"}}, {{"", "", ""}}, false};
  return section("signature", "Checked and accepted", table.html());
}

std::string head(const ReportContent& c) {
  std::string out = "<header>\n<h1>" + escaped(c.title) + "</h1>\n<p class=\"facts\">";
  for (const auto& [name, value] : c.facts) out += "<span>" + escaped(name) + ": <b>" + escaped(value) + "</b></span> ";
  return out + "</p>\n" + cards(c.metrics) + "</header>\n";
}

}  // namespace

std::string report_html(const ReportContent& c) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(c.title) + "</title>\n<style>\n" + std::string(page_style) + "</style>\n</head>\n<body>\n<main>\n";
  out += head(c) + metrics_section(c) + check_section(c) + evaluation_section(c) + pictures_section(c) +
         stems_section(c) + signature() + slam_section(c) + run_section(c);
  return out + "</main>\n<script>\n" + std::string(page_script) + "</script>\n</body>\n</html>\n";
}

}  // namespace bole::report
