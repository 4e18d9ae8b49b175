#include "document/file_kinds.h"

#include <QFileInfo>
#include <QStringList>
#include <array>

#include "io/core/formats.h"
#include "io/core/views/view_layouts.h"

namespace bole::desktop {

FileKind kind_of_file(const QString& path) {
  const QFileInfo info(path);
  const bool json = info.suffix().compare("json", Qt::CaseInsensitive) == 0;
  // Layouts go by the names of files: they are asked where a name may mean views, transforms.json and camera.json too.
  if (info.isDir() || json) {
    const bool camera = info.isFile() && info.fileName() == "camera.json";
    const QString place = camera ? info.absolutePath() : path;
    if (io::find_layout(place.toStdString()) != nullptr) return FileKind::views;
  }
  if (json && !info.isDir()) return FileKind::pipeline;
  const auto* format = io::find_format(path.toStdString());
  if (format == nullptr) return FileKind::unknown;
  return format->content() == io::FileContent::scan ? FileKind::scan : FileKind::cloud;
}

QString pipeline_endings() { return "*.json"; }

QString cloud_endings() {
  QStringList patterns;
  for (const auto& pattern : io::file_patterns(std::array{io::FileContent::cloud}))
    patterns << QString::fromStdString(pattern);
  return patterns.join(' ');
}

QString all_endings() {
  QStringList patterns{pipeline_endings()};
  for (const auto& pattern : io::file_patterns(io::scans_and_clouds)) patterns << QString::fromStdString(pattern);
  return patterns.join(' ');
}

}  // namespace bole::desktop
