#include "report/make_report.h"

#include <cairo.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "base/atomic_file.h"
#include "base/version.h"
#include "render/draw/axes.h"
#include "render/draw/figure.h"
#include "render/offscreen/offscreen.h"
#include "report/core/page_warnings.h"
#include "report/core/report_page.h"
#include "report/exports.h"
#include "report/survey_figures.h"

namespace bole::report {
namespace {

constexpr double page_dpi = 160;  // of pixels inside report.html: sharp on a screen, small enough to mail

class Writer {
 public:
  Writer(const DataSet& inputs, const ReportOptions& options, const Run& run)
      : data_(survey_data(inputs)), o_(options), run_(run) {}

  pipeline::StageResult write() {
    write_exports(run_.part(0, 0.3));
    if (o_.figures) write_figures(run_.part(0.3, 0.95));
    if (o_.page) attempt("report.html", [&] { write_page(); });
    run_.report(1, "report");
    auto& r = result_.report;
    r.counts["files"] = static_cast<std::int64_t>(files_.size());
    r.counts["figures"] = static_cast<std::int64_t>(pictures_.size());
    r.facts["axes"] = std::string(axes_name(data_.axes));
    r.message = fmt::format("{} files in {}", files_.size(), run_.output_dir.string());
    if (o_.page) r.message += ", read report.html first";
    return std::move(result_);
  }

 private:
  // Runs one part; what goes wrong in it becomes a warning.
  template <class Part>
  void attempt(const std::string& what, Part part) {
    run_.check_cancel();
    try {
      part();
    } catch (const Error& e) {
      if (e.kind() == ErrorKind::cancelled) throw;
      result_.report.warn(what + ": " + e.what());
    } catch (const std::exception& e) {
      result_.report.warn(what + ": " + e.what());
    }
  }

  void write_exports(const Run& run) {
    const auto exports = survey_exports(data_, o_);
    for (std::size_t i = 0; i < exports.size(); ++i) {
      const auto& e = exports[i];
      run.report(static_cast<double>(i) / static_cast<double>(exports.size()), "write " + e.file);
      attempt(e.file, [&] {
        e.write(run_.output_dir / e.file, run, result_.report);
        files_.push_back(e.file);
      });
    }
  }

  void write_figures(const Run& run) {
    const auto plans = survey_figures(data_, o_, run);
    bool can_render = true;
    if (data_.points != nullptr) {
      try {
        render::use_backend(render::backend_from_name(o_.backend));
      } catch (const Error& e) {
        can_render = false;
        result_.report.warn(std::string("no 3-D maps: ") + e.what());
      }
    }
    double all = 0, done = 0;
    for (const auto& p : plans) all += p.share;
    for (const auto& plan : plans) {
      run.report(done / all, "draw " + plan.name);
      const bool is_map = plan.share >= 20;
      if (!is_map || can_render)
        attempt(plan.name, [&] {
          for (const auto& figure : plan.make()) save(figure, plan);
        });
      done += plan.share;
    }
  }

  void save(const render::Figure& figure, const FigurePlan& plan) {
    run_.check_cancel();
    const auto path = run_.output_dir / "figures" / figure.name;
    const auto put = [&](const char* ending, const std::string& bytes) {
      write_text_file(path.string() + ending, bytes);
      files_.push_back("figures/" + figure.name + ending);
    };
    const std::string png = render::figure_png(figure, plan.dpi > 0 ? plan.dpi : o_.dpi);
    put(".png", png);
    std::string svg;
    if (figure.vector && (o_.vector_figures || (o_.page && !plan.picture))) svg = render::figure_svg(figure);
    if (figure.vector && o_.vector_figures) put(".svg", svg), put(".pdf", render::figure_pdf(figure));
    if (!o_.page || !plan.on_page) return;
    const bool as_vector = figure.vector && !plan.picture;
    pictures_.push_back({figure.title, figure.caption, as_vector ? "image/svg+xml" : "image/png",
                         as_vector            ? svg
                         : o_.dpi <= page_dpi ? png
                                              : render::figure_png(figure, page_dpi),
                         plan.wide});
  }

  // Whether a stage before this one took the walk from a file in place of computing it.
  bool poses_given() const {
    if (run_.record == nullptr) return false;
    const auto given = [](const OptionRecord& o) { return o.name == "trajectory" && !o.value.empty(); };
    return std::any_of(run_.record->stages.begin(), run_.record->stages.end(), [&](const StageRecord& s) {
      return s.type == "slam.run" && std::any_of(s.options.begin(), s.options.end(), given);
    });
  }

  void write_page() {
    ReportContent content;
    content.title = o_.title;
    content.facts = {{"Plot", describe(data_.rule.area)}, {"Axes", axes_text()}};
    if (run_.record != nullptr && !run_.record->document.empty())
      content.facts.emplace_back("Pipeline", run_.record->document);
    content.facts.emplace_back("Made on", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))));
    content.metrics = plot_metrics(*data_.stems, data_.rule, o_.class_width, o_.form_sd);
    content.stems = data_.stems, content.rejected = data_.rejected, content.edits = data_.edits,
    content.summary = data_.summary, content.loops = data_.loops, content.odometry = data_.odometry;
    content.rule = data_.rule, content.poses_given = poses_given();
    content.pictures = std::move(pictures_);
    content.record = run_.record;
    content.warnings = page_warnings(run_.record.get(), result_.report);
    content.versions = {{"Bole", std::string(version())}};
    for (auto& library : library_versions()) content.versions.push_back(std::move(library));
    content.versions.emplace_back("Cairo", cairo_version_string());
    content.files = files_;
    write_text_file(run_.output_dir / "report.html", report_html(content));
    files_.push_back("report.html");
    pictures_ = std::move(content.pictures);
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

  SurveyData data_;
  const ReportOptions& o_;
  const Run& run_;
  pipeline::StageResult result_;
  std::vector<std::string> files_;
  std::vector<ReportPicture> pictures_;
};

}  // namespace

pipeline::StageResult make_report(const DataSet& inputs, const ReportOptions& options, const Run& run) {
  if (run.output_dir.empty())
    throw bad_input("there is no folder to write the report into", "an output folder", "Give --out DIR");
  return Writer(inputs, options, run).write();
}

}  // namespace bole::report
