#include "report/core/report_page.h"

#include <algorithm>
#include <optional>

#include "base/markup.h"
#include "base/verdict.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/evaluation_section.h"
#include "report/core/html.h"
#include "report/core/look_list.h"
#include "report/core/overview.h"
#include "report/core/page_resources.h"
#include "report/core/plot_section.h"
#include "report/core/slam_section.h"
#include "report/core/slices.h"
#include "report/core/stem_sections.h"
#include "report/core/survey_facts.h"
#include "report/core/terms.h"
#include "report/core/view3d.h"
#include "report/place/place_section.h"

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
  const auto body = evaluation_html(*d.summary);
  if (body.empty()) return {};
  std::string note = "Compared with the reference that was given.";
  const auto published = texts_or_empty(*d.summary, "published");
  if (std::any_of(published.begin(), published.end(), [](const auto& text) { return !text.empty(); }))
    note +=
        " Published: the figures of the method's paper, from other plots; they stand beside ours and do not replace "
        "them.";
  return section("evaluation", "Against the reference", paragraph(note, "note") + body);
}

std::string walk_section(const SurveyData& d) {
  if (d.summary == nullptr) return {};
  const auto body = walk_evaluation_html(*d.summary, d.poses_given());
  if (body.empty()) return {};
  std::string note =
      "The path of the scanner beside the reference path. Unless a row says otherwise, both were first laid over each "
      "other as well as a shift and a turn allow.";
  if (d.poses_given())
    note += " The poses of the walk were given to this run, so errors of the walk tell nothing about SLAM.";
  return "<h3>Path of the scanner against its reference</h3>\n" + paragraph(note, "note") + body;
}

std::string slam_section(const ReportContent& c, Report& told) {
  std::string body;
  if (c.record != nullptr)
    for (const auto& stage : c.record->stages) body += slam_html(stage, c.data.loops, c.data.odometry, told);
  return body.empty() ? std::string() : "<div id=\"slam\">\n<h3>SLAM: from frames to a map</h3>\n" + body + "</div>\n";
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

std::string appendix(const ReportContent& c, Report& told) {
  std::string body = walk_section(c.data) + slam_section(c, told);
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
  return section("run", "Appendix: how it was made", body);
}

// To be filled in by hand on paper.
std::string signature() {
  HtmlTable table{{{"Name"}, {"Date"}, {"Signature"}}, {{"", "", ""}}, false};
  return section("signature", "Checked and accepted", table.html());
}

std::optional<Judgement> judgement_of(const ReportContent& c, Report& told) {
  if (c.record == nullptr) return std::nullopt;
  auto stages = c.record->stages;
  stages.push_back({"report", "report.plot", {}, told, false});
  auto judgement = judge(stages);
  told.facts["verdict"] = std::string(verdict_name(judgement.verdict));
  told.counts[trees_to_look_at_count] = static_cast<std::int64_t>(trees_to_look_at(c.data).rows.size());
  told.counts["notes"] = std::ranges::count_if(
      judgement.findings, [](const StageFinding& f) { return f.finding.severity == Severity::note; });
  return judgement;
}

std::string navigation(const std::string& page) {
  constexpr std::pair<const char*, const char*> links[] = {
      {"plot", "Values"},         {"place", "Place"}, {"check", "What to look at"}, {"stems", "Stems"},
      {"slices", "Slices"},       {"view3d", "3-D"},  {"figures", "Figures"},       {"evaluation", "Reference"},
      {"signature", "Signature"}, {"terms", "Words"}, {"run", "Appendix"}};
  std::string out = "<nav class=\"screen\">";
  for (const auto& [id, title] : links)
    if (page.find("<section id=\"" + std::string(id) + "\">") != std::string::npos)
      out += "<a href=\"#" + std::string(id) + "\">" + title + "</a> ";
  return out + "</nav>\n";
}

std::string view_section(const ReportContent& c) {
  if (c.view_data.empty()) return {};
  const auto* points = c.data.points;
  return view3d_section(points != nullptr && !points->empty(), points != nullptr && points->has(arrays::tree_id));
}

// What stands in the card of the selected tree is filled in by the script.
std::string scripts(const ReportContent& c) {
  std::string out =
      "<aside id=\"tree\" class=\"screen\" hidden=\"hidden\"></aside>\n<div id=\"tip\" class=\"screen\" "
      "hidden=\"hidden\"></div>\n" +
      page_script("tables.js");
  if (c.view_data.empty()) return out;
  return out + "<script type=\"application/json\" id=\"survey-data\">" + c.view_data + "</script>\n" +
         page_script("view3d.js") + page_script("survey.js");
}

}  // namespace

std::string report_html(const ReportContent& c, Report& told) {
  const OverviewContent first{c.title, survey_facts(c.data, c.record.get(), told), judgement_of(c, told)};
  std::string body = plot_section(c.data);
  body += place_section(c.data, c.record.get());
  body += check_section(c.data, c.warnings, told);
  body += stems_section(c.data, told);
  body += slices_section(c.data);
  body += view_section(c);
  body += pictures_section(c);
  body += evaluation_section(c.data);
  body += signature();
  body += terms_section();
  body += appendix(c, told);
  return page_head(c.title, "page.css") + "<main>\n" + overview_html(first, c.data) + navigation(body) + body +
         "</main>\n" + scripts(c) + "</body>\n</html>\n";
}

}  // namespace bole::report
