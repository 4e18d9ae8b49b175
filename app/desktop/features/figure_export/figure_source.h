// The figures that a document's report draws, for the figure export: the same data, options and code as in a run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "document/session.h"
#include "document/survey.h"
#include "render/draw/figure.h"
#include "report/report_options.h"
#include "workbench/offered_figures.h"

namespace bole::desktop {

enum class FigureFormat { png, svg, pdf };

class FigureSource {
 public:
  // The inputs and options of the stage report.plot where the document has one that ran, else what the views show; then
  // what features offer.
  FigureSource(const pipeline::PipelineDocument* document, const Results& results, const Survey& survey,
               std::vector<OfferedFigure> offered = {});

  const std::vector<std::string>& names() const { return names_; }
  const report::ReportOptions& options() const { return options_; }

  // One of names() at a width and resolution; the pages of a sheet one after the other. Any thread. Throws bole::Error.
  std::vector<render::Figure> make(const std::string& name, double width_mm, double dpi, const Run& run = {}) const;

 private:
  report::ReportOptions with(double width_mm, double dpi) const;

  DataSet data_;
  report::ReportOptions options_;
  Survey survey_;
  std::vector<OfferedFigure> offered_;
  std::vector<std::string> names_;
};

// The bytes of a file.
std::string figure_bytes(const render::Figure& figure, FigureFormat format, double dpi);

}  // namespace bole::desktop
