#include "document/scan_document.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "base/resources.h"

namespace bole::desktop {
namespace {

bool reads(const QString& document, const QString& scan) {
  try {
    const auto loaded = PipelineDocument::load(document.toStdString(), StageRegistry::global());
    return std::ranges::any_of(loaded.stages(), [&](const StageNode& node) {
      return node.type->name == "io.read_scan" &&
             QFileInfo(QString::fromStdString(std::get<std::string>(node.options.get("file")))) == QFileInfo(scan);
    });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

bool is_scan(const QString& path) {
  const QFileInfo file(path);
  const QString ending = file.suffix().toLower();
  return file.isDir() || ending == "pcap" || ending == "pcapng";
}

QString document_path_for_scan(const QString& scan) {
  const QFileInfo file(scan);
  QString folder = file.absolutePath();
  if (!QFileInfo(folder).isWritable()) {
    folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Bole";
    QDir().mkpath(folder);
  }
  const QString name = folder + "/" + (file.isDir() ? file.fileName() : file.completeBaseName());
  QString path = name + ".json";
  for (int i = 2; QFileInfo::exists(path) && !reads(path, scan); ++i) path = name + "-" + QString::number(i) + ".json";
  return path;
}

PipelineDocument document_for_scan(const QString& scan) {
  const auto pattern = resource_dir().parent_path() / "pipelines" / "forest_plot.json";
  auto document = PipelineDocument::load(pattern, StageRegistry::global());
  document.set("scan.file", QFileInfo(scan).absoluteFilePath().toStdString());
  return document;
}

}  // namespace bole::desktop
