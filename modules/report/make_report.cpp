#include "report/make_report.h"

#include "base/atomic_file.h"
#include "base/verdict.h"
#include "base/version.h"
#include "render/maps/check_maps.h"
#include "render/offscreen/offscreen.h"
#include "report/check_files.h"
#include "report/core/page_warnings.h"
#include "report/core/report_page.h"
#include "report/core/survey_facts.h"
#include "report/core/tally_page.h"
#include "report/exports.h"
#include "report/report_writer.h"
#include "report/survey_figures.h"
#include "report/view_data.h"

namespace bole::report {
namespace {

class PlotReport {
 public:
  PlotReport(const DataSet& inputs, const ReportOptions& options, const Run& run)
      : writer_(run), data_(survey_data(inputs)), o_(options), drawn_(drawing_options(options)), run_(run) {}

  pipeline::StageResult write() {
    write_exports(run_.part(0, 0.3));
    if (o_.figures) write_figures(run_.part(0.3, 0.95));
    if (data_.check != nullptr)
      writer_.write("check.json",
                    [&](const auto& path) { write_text_file(path, check_json(data_, run_.record.get())); });
    if (o_.page) {
      if (data_.check != nullptr) writer_.write("check.html", [&](const auto& path) { write_check(path); });
      if (data_.kept_stems().rows() > 0) writer_.write("tally.html", [&](const auto& path) { write_tally(path); });
      writer_.write("report.html", [&](const auto& path) { write_page(path); });
    }
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
    auto plans = survey_figures(data_, drawn_, run);
    if (o_.figure_set == FigureSet::page)
      std::erase_if(plans, [](const FigurePlan& plan) { return !plan.on_page && !plan.asked_for; });
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
      writer_.save(figure, {.dpi = plan.dpi > 0 ? plan.dpi : drawn_.dpi,
                            .for_print = o_.figure_set == FigureSet::all,
                            .vectors = o_.vector_figures,
                            .on_page = o_.page && plan.on_page,
                            .as_pixels = plan.kind != FigureKind::chart,
                            .wide = plan.wide});
    }
  }

  void write_page(const std::filesystem::path& path) {
    ReportContent content{.title = o_.title,
                          .data = data_,
                          .pictures = writer_.pictures(),
                          .warnings = page_warnings(run_.record.get(), writer_.report()),
                          .record = run_.record,
                          .versions = {{"Bole", std::string(version())}},
                          .files = writer_.files(),
                          .view_data = view_data_json(data_, run_)};
    for (auto& library : library_versions()) content.versions.push_back(std::move(library));
    write_text_file(path, report_html(content, writer_.report()));
  }

  void write_tally(const std::filesystem::path& path) {
    write_text_file(path, tally_html(o_.title, survey_facts(data_, run_.record.get(), writer_.report()), data_));
  }

  void write_check(const std::filesystem::path& path) {
    std::vector<ReportPicture> maps;
    for (const auto& picture : writer_.pictures())
      if (picture.title == render::check_maps_title) maps.push_back(picture);
    write_text_file(path, check_html(o_.title, data_, maps));
  }

  // A page needs fewer pixels and points than paper.
  static ReportOptions drawing_options(ReportOptions o) {
    constexpr int page_points = 400'000;
    if (o.figure_set == FigureSet::all) return o;
    o.dpi = page_dpi;
    if (!o.hero) o.point_budget = std::min(o.point_budget, page_points);
    return o;
  }

  ReportWriter writer_;
  SurveyData data_;
  const ReportOptions& o_;
  const ReportOptions drawn_;
  const Run& run_;
};

}  // namespace

pipeline::StageResult make_report(const DataSet& inputs, const ReportOptions& options, const Run& run) {
  return PlotReport(inputs, options, run).write();
}

}  // namespace bole::report
