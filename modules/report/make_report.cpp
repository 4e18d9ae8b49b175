#include "report/make_report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "base/atomic_file.h"
#include "base/verdict.h"
#include "base/version.h"
#include "render/offscreen/offscreen.h"
#include "report/core/page_warnings.h"
#include "report/core/report_page.h"
#include "report/exports.h"
#include "report/report_writer.h"
#include "report/survey_figures.h"

namespace bole::report {
namespace {

class PlotReport {
 public:
  PlotReport(const DataSet& inputs, const ReportOptions& options, const Run& run)
      : writer_(run), data_(survey_data(inputs)), o_(options), run_(run) {}

  pipeline::StageResult write() {
    write_exports(run_.part(0, 0.3));
    if (o_.figures) write_figures(run_.part(0.3, 0.95));
    if (o_.page) writer_.write("report.html", [&](const auto& path) { write_page(path); });
    run_.report(1, "report");
    auto result = writer_.finish();
    result.report.counts["figures"] = static_cast<std::int64_t>(writer_.pictures().size());
    result.report.facts["axes"] = std::string(axes_name(data_.axes));
    if (o_.page) result.report.message += ", read report.html first";
    return result;
  }

 private:
  void write_exports(const Run& run) {
    const auto exports = survey_exports(data_, o_);
    for (std::size_t i = 0; i < exports.size(); ++i) {
      const auto& e = exports[i];
      run.report(static_cast<double>(i) / static_cast<double>(exports.size()), "write " + e.file);
      writer_.write(e.file, [&](const auto& path) { e.write(path, run, writer_.report()); });
    }
  }

  bool can_render() {
    if (data_.points == nullptr) return false;
    try {
      render::use_backend(render::backend_from_name(o_.backend));
      return true;
    } catch (const Error& e) {
      writer_.report().find(Severity::look, finding_code::output_not_written,
                            std::string("the 3-D maps could not be drawn: ") + e.what());
      return false;
    }
  }

  void write_figures(const Run& run) {
    const auto plans = survey_figures(data_, o_, run);
    const bool renders = can_render();
    double all = 0, done = 0;
    for (const auto& plan : plans) all += plan.share();
    for (const auto& plan : plans) {
      if (writer_.ends_early()) return writer_.report().warn("asked to finish early: figures are left out");
      run.report(done / all, "draw " + plan.name);
      if (plan.kind != FigureKind::map || renders) writer_.attempt(plan.name, [&] { save(plan); });
      done += plan.share();
    }
  }

  void save(const FigurePlan& plan) {
    for (const auto& figure : plan.make()) {
      if (writer_.ends_early()) return;
      writer_.save(figure, {.dpi = plan.dpi > 0 ? plan.dpi : o_.dpi,
                            .vectors = o_.vector_figures,
                            .on_page = o_.page && plan.on_page,
                            .as_pixels = plan.kind != FigureKind::chart,
                            .wide = plan.wide});
    }
  }

  void write_page(const std::filesystem::path& path) {
    ReportContent content{.title = o_.title,
                          .facts = facts(),
                          .data = data_,
                          .pictures = writer_.pictures(),
                          .warnings = page_warnings(run_.record.get(), writer_.report()),
                          .record = run_.record,
                          .versions = {{"Bole", std::string(version())}},
                          .files = writer_.files()};
    for (auto& library : library_versions()) content.versions.push_back(std::move(library));
    write_text_file(path, report_html(content, writer_.report()));
  }

  std::vector<std::pair<std::string, std::string>> facts() const {
    std::vector<std::pair<std::string, std::string>> all{{"Plot", describe(data_.rule.area)}, {"Axes", axes_text()}};
    if (run_.record != nullptr && !run_.record->document.empty()) all.emplace_back("Pipeline", run_.record->document);
    all.emplace_back("Made on", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))));
    return all;
  }

  std::string axes_text() const {
    switch (data_.axes) {
      case Axes::plot:
        return "plot (x east, y north, origin at the centre target)";
      case Axes::map:
        return "map (levelled, origin and heading where the walk began)";
      case Axes::global:
        return "projected coordinates";
      default:
        return std::string(axes_name(data_.axes));
    }
  }

  ReportWriter writer_;
  SurveyData data_;
  const ReportOptions& o_;
  const Run& run_;
};

}  // namespace

pipeline::StageResult make_report(const DataSet& inputs, const ReportOptions& options, const Run& run) {
  return PlotReport(inputs, options, run).write();
}

}  // namespace bole::report
