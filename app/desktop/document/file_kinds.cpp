#include "document/file_kinds.h"

#include <QFileInfo>
#include <QStringList>

#include "io/core/formats.h"

namespace bole::desktop {

FileKind kind_of_file(const QString& path) {
  if (QFileInfo(path).suffix().compare("json", Qt::CaseInsensitive) == 0) return FileKind::pipeline;
  const auto* format = io::find_format(path.toStdString());
  if (format == nullptr) return FileKind::unknown;
  return format->content() == io::FileContent::scan ? FileKind::scan : FileKind::cloud;
}

QString pipeline_endings() { return "*.json"; }

QString all_endings() {
  QStringList patterns{pipeline_endings()};
  for (const auto& pattern : io::file_patterns(io::scans_and_clouds)) patterns << QString::fromStdString(pattern);
  return patterns.join(' ');
}

}  // namespace bole::desktop
