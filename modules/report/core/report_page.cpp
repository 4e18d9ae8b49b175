#include "report/core/report_page.h"

#include <algorithm>
#include <cmath>

#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/page_style.h"

namespace bole {
namespace {

std::string section(const std::string& id, const std::string& title, const std::string& body) { return "<section id=\"" + id + "\">\n<h2>" + escaped(title) + "</h2>\n" + body + "</section>\n"; }

std::string paragraph(const std::string& text, const std::string& css = {}) { return "<p" + (css.empty() ? std::string() : " class=\"" + css + "\"") + ">" + escaped(text) + "</p>\n"; }

std::string cards(const PlotMetrics& m) {
  const auto card = [](const std::string& value, const std::string& unit, const std::string& name) {
    return "<div class=\"card\"><b>" + escaped(value) + "</b> <span>" + escaped(unit) + "</span><br>" + escaped(name) + "</div>\n";
  };
  std::string out = "<div class=\"cards\">\n" + card(std::to_string(m.stems), "", "stems");
  if (std::isfinite(m.area_m2)) out += card(fixed(m.stems_per_ha, 0), "1/ha", "stem density") + card(fixed(m.basal_area_m2_per_ha, 1), "m²/ha", "basal area");
  out += card(fixed(m.mean_dbh_cm, 1), "cm", "mean DBH") + card(fixed(m.quadratic_mean_dbh_cm, 1), "cm", "quadratic mean diameter");
  if (m.heights > 0) out += card(fixed(m.lorey_height_m, 1), "m", "Lorey's height");
  return out + "</div>\n";
}

std::string metrics_section(const ReportContent& c) {
  HtmlTable table{{{"Measure"}, {"Value", true}, {"Unit"}, {"How"}}, {}, false};
  for (const auto& row : metric_rows(c.metrics, c.least_dbh_cm)) table.rows.push_back({row.name, row.value, row.unit, row.how});
  std::string body = table.html();
  if (!std::isfinite(c.metrics.area_m2)) body = paragraph("No plot boundary is set, so there are no values per hectare. Set plot_shape and plot_size of the report.", "note") + body;
  HtmlTable classes{{{"DBH class (cm)"}, {"Stems", true}, {"1/ha", true}, {"Basal area (m²/ha)", true}, {"Mean height (m)", true}}, {}, false};
  for (const auto& k : c.metrics.classes)
    classes.rows.push_back({fixed(k.lo_cm, 0) + "–" + fixed(k.hi_cm, 0), std::to_string(k.stems), fixed(k.stems_per_ha, 0), fixed(k.basal_area_m2_per_ha, 2), fixed(k.mean_height_m, 1)});
  if (!classes.rows.empty()) body += "<h3>By diameter class</h3>\n" + classes.html();
  return section("plot", "The plot", body);
}

struct StemColumn {
  const char* column;
  const char* title;
  int decimals;
};

// Those of the stem table that a reader wants, where they are present.
constexpr StemColumn stem_columns[] = {{"tree_id", "Tree", 0},    {"x_m", "x (m)", 2},           {"y_m", "y (m)", 2},         {"dbh_cm", "DBH (cm)", 1}, {"dbh_lo_cm", "from", 1},
                                       {"dbh_hi_cm", "to", 1},    {"height_m", "Height (m)", 1}, {"lean_deg", "Lean (°)", 1}, {"arc_deg", "Arc (°)", 0}, {"passes", "Passes", 0},
                                       {"sigma_cm", "σ (cm)", 2}, {"inliers", "Points", 0},      {"quality", "Quality", -1},  {"state", "State", -1}};

HtmlTable stem_table(const Table& stems, const std::vector<std::size_t>& rows) {
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
    for (const auto& c : used) {
      const auto* texts = std::get_if<std::vector<std::string>>(stems.find(c.column));
      cells.push_back(texts != nullptr ? (*texts)[i] : c.column == std::string_view("tree_id") ? stems.text(c.column, i, 0) : fixed(numbers_or_nan(stems, c.column)[i], c.decimals));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string stems_section(const ReportContent& c) {
  if (c.stems == nullptr) return {};
  std::vector<std::size_t> all(c.stems->rows());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return section("stems", "Stems", paragraph("Diameters at breast height with their 95 % interval. A click on a heading sorts.", "note screen") + stem_table(*c.stems, all).html());
}

std::string check_section(const ReportContent& c) {
  std::string body;
  if (!c.warnings.empty()) {
    body += "<ul>\n";
    for (const auto& w : c.warnings) body += "<li>" + escaped(w) + "</li>\n";
    body += "</ul>\n";
  }
  if (c.stems != nullptr) {
    const auto state = texts_or_empty(*c.stems, "state"), quality = texts_or_empty(*c.stems, "quality"), reasons = texts_or_empty(*c.stems, "reasons");
    HtmlTable table{{{"Tree", true}, {"DBH (cm)", true}, {"Quality"}, {"Why it should be checked"}}, {}, true};
    for (std::size_t i = 0; i < c.stems->rows(); ++i)
      if (state[i] == "check" || quality[i] == "poor")
        table.rows.push_back({c.stems->has("tree_id") ? c.stems->text("tree_id", i, 0) : std::to_string(i + 1), fixed(numbers_or_nan(*c.stems, "dbh_cm")[i], 1), quality[i], reasons[i]});
    if (!table.rows.empty()) body += "<h3>Trees to check (" + std::to_string(table.rows.size()) + ")</h3>\n" + table.html();
  }
  if (c.rejected != nullptr && c.rejected->rows() > 0) {
    HtmlTable table{{{"x (m)", true}, {"y (m)", true}, {"Points", true}, {"Why it is no stem"}}, {}, true};
    const auto x = numbers_or_nan(*c.rejected, "x_m"), y = numbers_or_nan(*c.rejected, "y_m"), points = numbers_or_nan(*c.rejected, "points");
    const auto reason = texts_or_empty(*c.rejected, "reason");
    for (std::size_t i = 0; i < c.rejected->rows(); ++i) table.rows.push_back({fixed(x[i], 2), fixed(y[i], 2), fixed(points[i], 0), reason[i]});
    body += "<details><summary>Rejected candidates (" + std::to_string(c.rejected->rows()) + ")</summary>\n" + table.html() + "</details>\n";
  }
  if (body.empty()) body = paragraph("Nothing: no warnings, no tree asks to be checked.");
  return section("check", "What to look at", body);
}

std::string pictures_section(const ReportContent& c) {
  std::string body;
  for (const auto& p : c.pictures)
    body += std::string("<figure") + (p.wide ? "" : " class=\"half\"") + "><img src=\"" + data_uri(p.media_type, p.bytes) + "\" alt=\"" + escaped(p.title) + "\"><figcaption><b>" + escaped(p.title) + ".</b> " +
            escaped(p.caption) + "</figcaption></figure>\n";
  return body.empty() ? std::string() : section("figures", "Figures", "<div class=\"figures\">\n" + body + "</div>\n");
}

std::string number_or_text(const Table& table, const char* column, std::size_t row) {
  const auto* values = table.find(column);
  if (values == nullptr) return {};
  if (const auto* texts = std::get_if<std::vector<std::string>>(values)) return (*texts)[row];
  const double v = numbers_or_nan(table, column)[row];
  return fixed(v, v == std::round(v) ? 0 : std::abs(v) >= 10 ? 2 : 3);
}

std::string evaluation_section(const ReportContent& c) {
  if (c.summary == nullptr || c.summary->rows() == 0) return {};
  HtmlTable table{{{"Measure"}, {"This run", true}, {"Unit"}, {"Published", true}}, {}, false};
  auto by_class = table;
  for (std::size_t i = 0; i < c.summary->rows(); ++i) {
    auto measure = number_or_text(*c.summary, "measure", i);
    // Measures of one class of diameters or distances are many: they fold away.
    auto& rows = measure.find("_to_") != std::string::npos ? by_class.rows : table.rows;
    std::replace(measure.begin(), measure.end(), '_', ' ');
    rows.push_back({measure, number_or_text(*c.summary, "value", i), number_or_text(*c.summary, "unit", i), number_or_text(*c.summary, "published", i)});
  }
  std::string body = paragraph("Compared with the reference that was given. Published: the figures of the method's paper, from other plots; they stand beside ours and do not replace them.", "note") + table.html();
  if (!by_class.rows.empty()) body += "<details><summary>By class of diameter and distance</summary>\n" + by_class.html() + "</details>\n";
  if (c.matches != nullptr) {
    const auto kind = texts_or_empty(*c.matches, "kind");
    const auto count = [&](const char* word) { return std::to_string(std::count(kind.begin(), kind.end(), word)); };
    body += paragraph("Stems: " + count("matched") + " matched, " + count("missed") + " missed, " + count("false") + " false.");
  }
  return section("evaluation", "Against the reference", body);
}

std::string stage_options(const StageRecord& stage) {
  HtmlTable table{{{"Option"}, {"Value", true}, {"Unit"}, {""}}, {}, false};
  for (const auto& o : stage.options) table.rows.push_back({o.name, o.value.empty() ? "–" : o.value, o.unit, o.is_default ? "" : "changed"});
  const bool changed = std::any_of(stage.options.begin(), stage.options.end(), [](const auto& o) { return !o.is_default; });
  return "<details><summary><b>" + escaped(stage.id) + "</b> (" + escaped(stage.type) + ")" + (changed ? ", changed options" : "") + "</summary>\n" + (table.rows.empty() ? paragraph("no options") : table.html()) +
         "</details>\n";
}

std::string run_section(const ReportContent& c) {
  std::string body;
  if (c.record != nullptr && !c.record->stages.empty()) {
    HtmlTable table{{{"Stage"}, {"Type"}, {"Time (s)", true}, {"Peak memory (MiB)", true}, {"Result"}}, {}, false};
    double total = 0;
    for (const auto& s : c.record->stages) {
      total += s.report.seconds;
      table.rows.push_back({s.id, s.type, s.from_cache ? "stored" : fixed(s.report.seconds, 1), s.report.peak_mib > 0 ? fixed(s.report.peak_mib, 0) : "", s.report.message});
    }
    table.rows.push_back({"all", "", fixed(total, 1), "", ""});
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

std::string head(const ReportContent& c) {
  std::string out = "<header>\n<h1>" + escaped(c.title) + "</h1>\n<p class=\"facts\">";
  for (const auto& [name, value] : c.facts) out += "<span>" + escaped(name) + ": <b>" + escaped(value) + "</b></span> ";
  return out + "</p>\n" + cards(c.metrics) + "</header>\n";
}

}  // namespace

std::string report_html(const ReportContent& c) {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + escaped(c.title) + "</title>\n<style>\n" +
                    std::string(page_style) + "</style>\n</head>\n<body>\n<main>\n";
  out += head(c) + metrics_section(c) + check_section(c) + evaluation_section(c) + pictures_section(c) + stems_section(c) + run_section(c);
  return out + "</main>\n<script>\n" + std::string(page_script) + "</script>\n</body>\n</html>\n";
}

}  // namespace bole
