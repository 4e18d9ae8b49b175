// What the window takes for a pipeline, a cloud or a scan, by the name of the file. The only list of endings here.
#pragma once

#include <QString>

namespace bole::desktop {

enum class FileKind { pipeline, cloud, scan, unknown };
FileKind kind_of_file(const QString& path);  // a folder is a scan of frames

QString pipeline_endings();  // "*.json", as a dialog takes them
QString all_endings();       // of everything that can be opened: "*.json *.las ..."

}  // namespace bole::desktop
