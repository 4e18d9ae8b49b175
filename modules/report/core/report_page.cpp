#include "report/core/report_page.h"

#include <algorithm>

#include "base/markup.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/evaluation_section.h"
#include "report/core/html.h"
#include "report/core/page_style.h"
#include "report/core/plot_section.h"
#include "report/core/slam_section.h"
#include "report/core/stem_sections.h"

namespace bole::report {
namespace {

std::string pictures_section(const ReportContent& c) {
  std::string body;
  for (const auto& p : c.pictures)
    body += std::string("<figure") + (p.wide ? "" : " class=\"half\"") + "><img src=\"" +
            data_uri(p.media_type, p.bytes) + "\" alt=\"" + escaped(p.title) + "\"><figcaption><b>" + escaped(p.title) +
            ".</b> " + escaped(p.caption) + "</figcaption></figure>\n";
  return body.empty() ? std::string() : section("figures", "Figures", "<div class=\"figures\">\n" + body + "</div>\n");
}

std::string evaluation_section(const SurveyData& d) {
  if (d.summary == nullptr || d.summary->rows() == 0) return {};
  std::string note = "Compared with the reference that was given.";
  const auto published = texts_or_empty(*d.summary, "published");
  if (std::any_of(published.begin(), published.end(), [](const auto& text) { return !text.empty(); }))
    note +=
        " Published: the figures of the method's paper, from other plots; they stand beside ours and do not replace "
        "them.";
  if (d.poses_given())
    note += " The poses of the walk were given to this run, so errors of the walk tell nothing about SLAM.";
  return section("evaluation", "Against the reference",
                 paragraph(note, "note") + evaluation_html(*d.summary, d.poses_given()));
}

std::string slam_section(const ReportContent& c, Report& told) {
  std::string body;
  if (c.record != nullptr)
    for (const auto& stage : c.record->stages) body += slam_html(stage, c.data.loops, c.data.odometry, told);
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

std::string run_section(const ReportContent& c, Report& told) {
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
    told.metrics["stages_seconds"] = {total, Unit::second};
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
  return out + "</p>\n" + value_cards(c.data) + "</header>\n";
}

}  // namespace

std::string report_html(const ReportContent& c, Report& told) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(c.title) + "</title>\n<style>\n" + std::string(page_style) + "</style>\n</head>\n<body>\n<main>\n";
  out += head(c);
  out += plot_section(c.data);
  out += check_section(c.data, c.warnings, told);
  out += evaluation_section(c.data);
  out += pictures_section(c);
  out += stems_section(c.data, told);
  out += signature();
  out += slam_section(c, told);
  out += run_section(c, told);
  return out + "</main>\n<script>\n" + std::string(page_script) + "</script>\n</body>\n</html>\n";
}

}  // namespace bole::report
