#include "report/steering_report.h"

#include <fmt/format.h>

#include <array>

#include "base/atomic_file.h"
#include "io/core/table_file.h"
#include "render/charts/steering_charts.h"

namespace bole {

const OptionTable& option_table(const SteeringReportOptions*) {
  using S = SteeringReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the error curves and write them as PNG, SVG and PDF."},
      Option<S, double>{
          "figure_width", &S::figure_width, Unit::millimetre, {60, 800}, Tier::basic, "Width of the figures."},
      Option<S, double>{"dpi", &S::dpi, Unit::dot_per_inch, {50, 1200}, Tier::basic, "Resolution of the PNG."},
  });
  return table;
}

namespace {

struct File {
  const char *port, *name, *help;
};
constexpr std::array<File, 6> files{{
    {"summary", "steering_summary.csv", "Errors by speed, the published ones beside."},
    {"passes", "steering_passes.csv", "Errors by pass."},
    {"errors", "steering_errors.csv", "Errors by fix."},
    {"log", "steering_log.csv", "The log of the drive."},
    {"parameters", "steering_gains.csv", "Gains from tuning."},
    {"steps", "steering_tuning.csv", "Every try of the tuning."},
}};

// Hundredths of a millimetre are more than any receiver knows.
Decimals decimals_of(const Table& table) {
  Decimals d;
  for (const auto& column : table.columns())
    if (column.name.ends_with("_m") || column.name == "time_s") d[column.name] = 5;
  return d;
}

}  // namespace

StageResult write_steering_report(const DataSet& inputs, const SteeringReportOptions& options, const Run& run) {
  if (run.output_dir.empty())
    throw bad_input("there is no folder to write the report into", "an output folder", "Give --out DIR");
  StageResult result;
  std::int64_t written = 0;
  const auto attempt = [&](const std::string& file, const auto& part) {
    run.check_cancel();
    try {
      part(run.output_dir / file);
      ++written;
    } catch (const std::exception& e) {
      result.report.warn(file + ": " + e.what());
    }
  };
  for (const auto& file : files)
    if (inputs.has(file.port))
      attempt(file.name, [&](const auto& path) {
        const auto& table = inputs.table(file.port);
        write_table(path, table, decimals_of(table));
      });
  if (options.figures && inputs.has("errors")) {
    const auto& errors = inputs.table("errors");
    for (const auto& figure :
         {tracking_error_curves(errors, options.figure_width), adjacent_error_curves(errors, options.figure_width)}) {
      const auto stem = "figures/" + figure.name;
      attempt(stem + ".png", [&](const auto& path) { write_text_file(path, figure_png(figure, options.dpi)); });
      attempt(stem + ".svg", [&](const auto& path) { write_text_file(path, figure_svg(figure)); });
      attempt(stem + ".pdf", [&](const auto& path) { write_text_file(path, figure_pdf(figure)); });
    }
  }
  if (written == 0 && result.report.warnings.empty())
    throw bad_input("report.steering has no input", "at least one of summary, passes, errors, log, parameters, steps");
  result.report.counts["files"] = written;
  result.report.message = fmt::format("{} files in {}", written, run.output_dir.string());
  return result;
}

StageType steering_report_stage() {
  StageType type;
  type.name = "report.steering";
  type.title = "Write the steering test";
  type.help =
      "Writes the errors of a steering test by speed, pass and fix, the log, the tuning, and the error curves as PNG, "
      "SVG and PDF into the output folder. Inputs that are not connected are left out.";
  type.source = "Bole";
  for (const auto& file : files) type.inputs.push_back({file.port, DataKind::table, file.help, true, {}});
  type.options = &option_table(static_cast<const SteeringReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_steering_report(inputs, options.as<SteeringReportOptions>(), run);
  };
  return type;
}

}  // namespace bole
