// Writes the files of a report into the output folder of a run. What cannot be written becomes a finding
// (output_not_written, input_not_usable), which makes the run fail in the end; the other files are still written.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/run.h"
#include "io/core/gdal/gdal_writer.h"
#include "pipeline/stage.h"
#include "render/draw/figure.h"
#include "report/core/picture.h"

namespace bole::report {

// Of pixels inside a page: sharp on a screen, small enough to mail.
inline constexpr double page_dpi = 160;

struct FigureOutput {
  double dpi = 300;        // of the PNG
  bool for_print = true;   // false: one file, as the page has it: SVG of a chart, else PNG
  bool vectors = true;     // for print: SVG and PDF files too, where the figure can be vector
  bool on_page = true;     // kept for the page
  bool as_pixels = false;  // on the page even where the figure could be vector
  bool wide = true;        // on the page: over its whole width
};

// Why a layer without a coordinate reference system is no GeoJSON.
inline constexpr const char* no_geojson =
    "not written: GeoJSON holds longitude and latitude, and the place of these coordinates on the earth is not known "
    "(no coordinate reference system)";

class ReportWriter {
 public:
  // Throws Error{bad_input} where the run has no output folder.
  explicit ReportWriter(const Run& run);

  // Runs one part of the work. An error in it becomes a finding that begins with `what`; Error{cancelled} is thrown on.
  void attempt(const std::string& what, const std::function<void()>& part);
  // attempt() with the path of a file in the output folder; the file is listed where `write` succeeds. An
  // Error{bad_input} is the finding input_not_usable here: a table without a column is no fault of the disk.
  void write(const std::string& file, const std::function<void(const std::filesystem::path&)>& write);
  // GeoJSON holds longitude and latitude only: a layer whose place on the earth is not known is not written; a fact and
  // the message of the report say so. Gives whether it was written.
  bool write_geojson(const std::string& file, const io::VectorLayer& layer);
  // Writes a figure as PNG, SVG and PDF into figures/.
  void save(const render::Figure& figure, const FigureOutput& output);

  // Whether to leave out what is not needed for a page, because somebody asked for an early end. Says so in the report.
  bool ends_early();

  Report& report() { return result_.report; }
  const std::vector<std::string>& files() const { return files_; }
  const std::vector<ReportPicture>& pictures() const { return pictures_; }

  // The count of files and the message of the report.
  pipeline::StageResult finish();

 private:
  void put(const std::string& file, const std::string& bytes);
  void guard(const std::string& what, const char* code_of_bad_input, const std::function<void()>& part);

  const Run& run_;
  pipeline::StageResult result_;
  std::vector<std::string> files_;
  std::string left_out_;  // what was not written, in words for the message
  std::vector<ReportPicture> pictures_;
};

}  // namespace bole::report
