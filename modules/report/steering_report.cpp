#include "report/steering_report.h"

#include <fmt/format.h>

#include <map>

#include "base/atomic_file.h"
#include "io/core/table_file.h"
#include "render/charts/steering_charts.h"
#include "report/core/simple_page.h"

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

struct PortTable {
  const char *port, *file, *title;
  std::vector<std::pair<std::string, std::string>> columns;
};

const std::vector<PortTable>& port_tables() {
  static const std::vector<PortTable> tables{
      {"figures",
       "steering.csv",
       "Errors by speed (m)",
       {{"speed_km_h", "km/h"},
        {"line_mean_m", "line mean"},
        {"published_line_mean_m", "published"},
        {"line_sd_m", "line SD"},
        {"published_line_sd_m", "published"},
        {"line_max_m", "line max"},
        {"published_line_max_m", "published"},
        {"adjacent_mean_m", "adjacent mean"},
        {"published_adjacent_mean_m", "published"},
        {"adjacent_sd_m", "adjacent SD"},
        {"published_adjacent_sd_m", "published"},
        {"adjacent_max_m", "adjacent max"},
        {"published_adjacent_max_m", "published"}}},
      {"figures",
       "",
       "Whose share it is (SD, m)",
       {{"speed_km_h", "km/h"},
        {"true_sd_m", "true line error"},
        {"receiver_sd_m", "receiver and filter"},
        {"controller_sd_m", "seen by the controller"},
        {"perfect_sd_m", "with a perfect receiver"}}},
      {"cases",
       "steering_cases.csv",
       "Jumps and outages",
       {{"speed_km_h", "km/h"},
        {"case", "case"},
        {"size", "size (m, s)"},
        {"peak_error_m", "largest error (m)"},
        {"stopped_s", "stood (s)"}}},
      {"gains",
       "steering_gains.csv",
       "Tuned gains",
       {{"speed_km_h", "km/h"},
        {"preview_m", "preview (m)"},
        {"published_preview_m", "published"},
        {"p", "P"},
        {"published_p", "published"},
        {"i", "I"},
        {"published_i", "published"},
        {"d", "D"},
        {"published_d", "published"}}},
      {"passes",
       "passes.csv",
       "Passes of the log",
       {{"pass", "pass"},
        {"angle_deg", "angle (deg)"},
        {"length_m", "length (m)"},
        {"speed_km_h", "km/h"},
        {"line_sd_m", "line SD (m)"},
        {"line_max_m", "line max (m)"},
        {"neighbour", "neighbour"},
        {"distance_m", "distance (m)"},
        {"adjacent_mean_m", "adjacent mean (m)"},
        {"adjacent_sd_m", "adjacent SD (m)"},
        {"adjacent_max_m", "adjacent max (m)"}}},
      {"track", "steering_track.csv", "", {}},
      {"errors", "pass_errors.csv", "", {}},
  };
  return tables;
}

// One curve per speed of the first lines driven, or per pass of a log (the first eight).
std::vector<ErrorCurve> curves_of(const Table& t, const char* key, const char* station, const char* error,
                                  const char* second, const char* unit, bool first_line_only) {
  constexpr std::size_t most = 8;
  std::map<double, ErrorCurve> by;
  const auto k = t.numbers(key), s = t.numbers(station), e = t.numbers(error), e2 = t.numbers(second);
  const auto line = first_line_only ? t.numbers("line") : std::vector<double>(k.size(), 1);
  for (std::size_t i = 0; i < k.size(); ++i) {
    if (line[i] != 1) continue;
    auto& c = by[k[i]];
    c.station_m.push_back(s[i]), c.error_m.push_back(e[i]), c.second_m.push_back(e2[i]);
  }
  std::vector<ErrorCurve> curves;
  for (auto& [value, c] : by) {
    if (curves.size() == most) break;
    c.label = std::string(unit) == "km/h" ? fmt::format("{:g} km/h", value) : fmt::format("{} {:g}", unit, value);
    curves.push_back(std::move(c));
  }
  return curves;
}

class SteeringWriter {
 public:
  SteeringWriter(const DataSet& inputs, const SteeringReportOptions& options, const Run& run)
      : in_(inputs), o_(options), run_(run) {}

  StageResult write() {
    page_.title = "Auto-steering";
    for (const auto& p : port_tables()) {
      if (!in_.has(p.port)) continue;
      const auto& table = in_.table(p.port);
      if (*p.file != 0) attempt(p.file, [&](const auto& path) { write_table(path, table); });
      if (*p.title != 0) page_.tables.push_back({p.title, "", &table, p.columns, 4});
    }
    if (page_.tables.empty())
      throw bad_input("nothing is connected to report.steering", "figures, gains or passes",
                      "Connect a steering stage");
    if (o_.figures) {
      if (in_.has("track"))
        draw(error_curves(
            "tracking_errors", "Tracking errors",
            curves_of(in_.table("track"), "speed_km_h", "station_m", "error_m", "seen_error_m", "km/h", true),
            "true error", "as the controller sees it", o_.figure_width));
      if (in_.has("errors") && in_.table("errors").rows() > 0)
        draw(error_curves("pass_errors", "Errors of the passes",
                          curves_of(in_.table("errors"), "pass", "station_m", "error_m", "adjacent_m", "pass", false),
                          "from its own line", "distance to the neighbour less the swath", o_.figure_width));
    }
    page_.warnings = result_.report.warnings;
    attempt("steering.html", [&](const auto& path) { write_text_file(path, simple_page_html(page_)); });
    result_.report.counts["files"] = files_;
    result_.report.message = fmt::format("{} files in {}", files_, run_.output_dir.string());
    return std::move(result_);
  }

 private:
  template <class Part>
  void attempt(const std::string& file, Part part) {
    run_.check_cancel();
    try {
      part(run_.output_dir / file);
      ++files_;
    } catch (const std::exception& e) {
      result_.report.warn(file + ": " + e.what());
    }
  }

  void draw(const Figure& figure) {
    const auto base = "figures/" + figure.name;
    attempt(base + ".png", [&](const auto& path) { write_text_file(path, figure_png(figure, o_.dpi)); });
    attempt(base + ".svg", [&](const auto& path) { write_text_file(path, figure_svg(figure)); });
    attempt(base + ".pdf", [&](const auto& path) { write_text_file(path, figure_pdf(figure)); });
    page_.pictures.push_back({figure.title, figure.caption, "image/svg+xml", figure_svg(figure), true});
  }

  const DataSet& in_;
  const SteeringReportOptions& o_;
  const Run& run_;
  SimplePage page_;
  StageResult result_;
  std::int64_t files_ = 0;
};

}  // namespace

StageResult write_steering_report(const DataSet& inputs, const SteeringReportOptions& options, const Run& run) {
  if (run.output_dir.empty())
    throw bad_input("there is no folder to write the steering report into", "an output folder", "Give --out DIR");
  return SteeringWriter(inputs, options, run).write();
}

StageType steering_report_stage() {
  StageType type;
  type.name = "report.steering";
  type.title = "Write the steering report";
  type.help =
      "Writes what steering stages found: steering.csv with the errors per speed beside the published ones, "
      "steering_cases.csv, steering_gains.csv, the track, the passes of a log with their errors, error curves as PNG, "
      "SVG and PDF, and steering.html with all of it.";
  type.source = "Bole";
  type.inputs = {{"figures", DataKind::table, "Errors per speed.", true, {}},
                 {"cases", DataKind::table, "Jumps and outages.", true, {}},
                 {"track", DataKind::table, "The drives.", true, {}},
                 {"gains", DataKind::table, "Tuned gains.", true, {}},
                 {"passes", DataKind::table, "Passes of a log.", true, {}},
                 {"errors", DataKind::table, "Errors along the passes.", true, {}}};
  type.options = &option_table(static_cast<const SteeringReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_steering_report(inputs, options.as<SteeringReportOptions>(), run);
  };
  return type;
}

}  // namespace bole
