#include "document/new_document.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include "base/resources.h"
#include "document/file_kinds.h"
#include "document/session.h"
#include "documents/new_document.h"
#include "io/core/formats.h"
#include "io/core/views/view_layouts.h"
#include "sim/core/plot/simulate.h"

namespace bole::desktop {
namespace {

sim::SimulationOptions sample_options() {
  sim::SimulationOptions options;
  options.plot = "sample";
  options.walk = resource_path("plots/sample_walk.csv").string();
  options.sensor = "vlp16";
  options.rotation_hz = 5;
  options.speed = 3;  // a walk of seconds; the poses are known, so nothing depends on small steps
  options.stand_still = 0.2;
  return options;
}

constexpr auto sample_scan = "walk.pcap";

bool same_file(const QFileInfo& a, const QFileInfo& b) {
  return a.absoluteFilePath() == b.absoluteFilePath() || (a.exists() && a == b);
}

// Whether a pipeline begins with this scan or cloud. One that cannot be read does not.
bool reads(const QString& pipeline, const QFileInfo& scan) {
  try {
    const auto document = pipeline::PipelineDocument::load(pipeline.toStdString(), pipeline::StageRegistry::global());
    return std::ranges::any_of(document.stages(), [&](const pipeline::StageNode& node) {
      if (!node.type->inputs.empty() ||
          !(node.type->output("points") || node.type->output("frames") || node.type->output("views")))
        return false;
      return std::ranges::any_of(node.type->options->specs, [&](const OptionSpec& spec) {
        return spec.text_kind == TextKind::input_path &&
               same_file(scan, QFileInfo(QString::fromStdString(std::get<std::string>(node.options.get(spec.name)))));
      });
    });
  } catch (const Error&) {
    return false;
  }
}

// The first of `base`.json, the name of the scan with .json, `base`_2.json and so on that is for this scan, saved or
// left by a crash, or is free: walk.pcap and walk.laz have a pipeline each.
QString path_that_reads(const QFileInfo& scan, const QString& base) {
  constexpr int max_names = 100;
  for (int k = 0; k < max_names; ++k) {
    QString path = k == 0   ? base + ".json"
                   : k == 1 ? scan.absoluteFilePath() + ".json"
                            : QString("%1_%2.json").arg(base).arg(k);
    const QString left = Session::recovery_path(path);
    const bool saved = QFileInfo::exists(path), lost = QFileInfo::exists(left);
    if ((!saved && !lost) || reads(saved ? path : left, scan)) return path;
  }
  throw bad_input("every name for a pipeline of '" + scan.filePath().toStdString() + "' is taken",
                  "one like '" + base.toStdString() + ".json'", "Move pipelines away that are not needed");
}

}  // namespace

pipeline::PipelineDocument document_for_file(const QString& path) {
  const auto kind = kind_of_file(path);
  if (kind == FileKind::views) return documents::document_for_views(QFileInfo(path).absoluteFilePath().toStdString());
  if (kind != FileKind::cloud && kind != FileKind::scan)
    throw bad_input(
        "'" + path.toStdString() + "' is not a pipeline, scan, point cloud or folder of views",
        "a pipeline (.json), " + io::format_list(io::scans_and_clouds) + ", or views: " + io::layout_list());
  return documents::document_for_file(QFileInfo(path).absoluteFilePath().toStdString());
}

QString pipeline_path_for_file(const QString& path) {
  const QFileInfo info(QDir::cleanPath(path));
  // A file that describes views is itself JSON: their pipeline has the name of its folder.
  const bool describes = info.isFile() && kind_of_file(path) == FileKind::views;
  const QFileInfo named(describes ? info.absolutePath() : info.absoluteFilePath());
  return path_that_reads(info, named.absolutePath() + "/" + named.completeBaseName());
}

QString sample_pipeline_path(const QString& wanted) {
  const QFileInfo info(wanted);
  return path_that_reads(QFileInfo(info.dir(), sample_scan), info.absolutePath() + "/" + info.completeBaseName());
}

pipeline::PipelineDocument sample_document(const QString& folder, const Run& run) {
  const QDir dir(folder);
  const QString done = dir.filePath("complete");  // written last: a half-made sample is made again
  if (!QFileInfo::exists(done)) {
    sim::simulate(sample_options(), folder.toStdString(), run);
    QFile mark(done);
    if (!mark.open(QIODevice::WriteOnly)) throw failure("cannot write " + done.toStdString());
  }
  auto document = documents::shipped_pipeline("forest_plot");
  const auto file = [&](const char* name) { return dir.absoluteFilePath(name).toStdString(); };
  document.set("scan.file", file(sample_scan));
  document.set("slam.trajectory", file("trajectory.tum"));
  document.set("reference_trees.file", file("trees.csv"));
  document.set("plot.width", "12");
  document.set("plot.length", "12");
  document.set("slam.map_max_range", "12");  // the plot, not the forest around it
  return document;
}

}  // namespace bole::desktop
