#include "report/report_writer.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/verdict.h"

namespace bole::report {
ReportWriter::ReportWriter(const Run& run) : run_(run) {
  if (run.output_dir.empty())
    throw bad_input("there is no folder to write the report into", "an output folder", "Give --out DIR");
}

void ReportWriter::guard(const std::string& what, const char* code_of_bad_input, const std::function<void()>& part) {
  run_.check_cancel();
  const auto note = [&](const char* code, const char* why) {
    report().find(Severity::refused, code, what + " could not be written: " + why);
  };
  try {
    part();
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::cancelled) throw;
    note(e.kind() == ErrorKind::bad_input ? code_of_bad_input : finding_code::output_not_written, e.what());
  } catch (const std::exception& e) {
    note(finding_code::output_not_written, e.what());
  }
}

void ReportWriter::attempt(const std::string& what, const std::function<void()>& part) {
  guard(what, finding_code::output_not_written, part);
}

bool ReportWriter::ends_early() {
  if (!run_.asked_to_finish()) return false;
  report().status = Status::finished_early;
  return true;
}

void ReportWriter::write(const std::string& file, const std::function<void(const std::filesystem::path&)>& write) {
  guard(file, finding_code::input_not_usable, [&] {
    write(run_.output_dir / file);
    files_.push_back(file);
  });
}

bool ReportWriter::write_geojson(const std::string& file, const io::VectorLayer& layer) {
  if (layer.crs_wkt.empty()) {
    report().facts[file] = no_geojson;
    left_out_ = ", no GeoJSON: the place on the earth is not known";
    return false;
  }
  const auto before = files_.size();
  write(file, [&](const auto& path) { io::write_geojson(path, layer); });
  return files_.size() > before;
}

void ReportWriter::put(const std::string& file, const std::string& bytes) {
  write_text_file(run_.output_dir / file, bytes);
  files_.push_back(file);
}

void ReportWriter::save(const render::Figure& figure, const FigureOutput& output) {
  run_.check_cancel();
  const std::string file = "figures/" + figure.name;
  const bool chart = figure.vector && !output.as_pixels, vector_on_page = chart && output.on_page;
  std::string png, svg;
  if (vector_on_page || (figure.vector && output.for_print && output.vectors)) svg = render::figure_svg(figure);
  if (output.for_print || !chart) {
    png = render::figure_png(figure, output.dpi);
    put(file + ".png", png);
  } else {
    if (svg.empty()) svg = render::figure_svg(figure);
    put(file + ".svg", svg);
  }
  if (figure.vector && output.for_print && output.vectors) {
    put(file + ".svg", svg);
    put(file + ".pdf", render::figure_pdf(figure));
  }
  if (!output.on_page) return;
  ReportPicture picture{figure.title, figure.caption, "image/svg+xml", {}, output.wide};
  if (vector_on_page) {
    picture.bytes = std::move(svg);
  } else {
    picture.media_type = "image/png";
    picture.bytes = output.dpi <= page_dpi ? png : render::figure_png(figure, page_dpi);
  }
  pictures_.push_back(std::move(picture));
}

pipeline::StageResult ReportWriter::finish() {
  report().counts["files"] = static_cast<std::int64_t>(files_.size());
  report().message = fmt::format("{} files{}", files_.size(), left_out_);
  return std::move(result_);
}

}  // namespace bole::report
