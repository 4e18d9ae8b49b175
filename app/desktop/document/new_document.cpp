#include "document/new_document.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "base/resources.h"
#include "shell/resources.h"
#include "sim/core/simulate.h"

namespace bole::desktop {
namespace {

SimulationOptions sample_options() {
  SimulationOptions options;
  options.plot = "sample";
  options.walk = resource_path("plots/sample_walk.csv").string();
  options.sensor = "vlp16";
  options.rotation_hz = 5;
  options.speed = 3;  // a walk of seconds; the poses are known, so nothing depends on small steps
  options.stand_still = 0.2;
  return options;
}

}  // namespace

PipelineDocument shipped_pipeline(const QString& name) {
  take_in_resources();
  QFile file(":/pipelines/" + name);
  if (!file.open(QIODevice::ReadOnly)) throw failure("the program lacks its pipeline " + name.toStdString());
  return PipelineDocument::parse(file.readAll().toStdString(), StageRegistry::global());
}

FileKind kind_of_file(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return FileKind::scan;
  const QString ending = info.suffix().toLower();
  if (ending == "json") return FileKind::pipeline;
  if (ending == "pcap") return FileKind::scan;
  if (QStringList{"las", "laz", "ply", "pcd", "xyz", "txt", "csv", "asc", "pts"}.contains(ending))
    return FileKind::cloud;
  return FileKind::unknown;
}

PipelineDocument document_for_file(const QString& path) {
  const auto kind = kind_of_file(path);
  if (kind != FileKind::cloud && kind != FileKind::scan)
    throw bad_input("'" + path.toStdString() + "' is no pipeline, cloud or scan",
                    "a file that ends in json, las, laz, ply, pcd, xyz, txt, csv or pcap, or a folder of frames");
  auto document = shipped_pipeline(kind == FileKind::cloud ? "stem_map_from_cloud.json" : "forest_plot.json");
  document.set("scan.file", QFileInfo(path).absoluteFilePath().toStdString());
  return document;
}

QString pipeline_path_for_file(const QString& path) {
  const QFileInfo info(path);
  return info.absolutePath() + "/" + info.completeBaseName() + ".json";
}

PipelineDocument sample_document(const QString& folder, const Run& run) {
  const QDir dir(folder);
  const QString done = dir.filePath("complete");  // written last: a half-made sample is made again
  if (!QFileInfo::exists(done)) {
    simulate(sample_options(), folder.toStdString(), run);
    QFile mark(done);
    if (!mark.open(QIODevice::WriteOnly)) throw failure("cannot write " + done.toStdString());
  }
  auto document = shipped_pipeline("forest_plot.json");
  const auto file = [&](const char* name) { return dir.absoluteFilePath(name).toStdString(); };
  document.set("scan.file", file("walk.pcap"));
  document.set("slam.trajectory", file("trajectory.tum"));
  document.set("reference_trees.file", file("trees.csv"));
  document.set("plot.width", "12");
  document.set("plot.length", "12");
  document.set("slam.map_range_max", "12");  // the plot, not the forest around it
  return document;
}

}  // namespace bole::desktop
