#include "document/file_kinds.h"

#include <QFileInfo>
#include <QStringList>

namespace bole::desktop {
namespace {

struct Endings {
  FileKind kind;
  QStringList endings;
};

const std::vector<Endings>& all_kinds() {
  static const std::vector<Endings> kinds{
      {FileKind::pipeline, {"json"}},
      {FileKind::cloud, {"las", "laz", "ply", "pcd", "xyz", "txt", "csv", "asc", "pts"}},
      {FileKind::scan, {"pcap"}}};
  return kinds;
}

}  // namespace

FileKind kind_of_file(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return FileKind::scan;
  for (const auto& [kind, endings] : all_kinds())
    if (endings.contains(info.suffix().toLower())) return kind;
  return FileKind::unknown;
}

QString pipeline_endings() { return "*.json"; }

QString all_endings() {
  QStringList patterns;
  for (const auto& [kind, endings] : all_kinds())
    for (const auto& ending : endings) patterns << "*." + ending;
  return patterns.join(' ');
}

}  // namespace bole::desktop
