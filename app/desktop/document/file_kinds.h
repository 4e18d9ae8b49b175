// What the window takes for a pipeline, a cloud, a scan or a folder of views. Clouds and scans are those of the table
// of formats (io/core/formats.h), as for `bole info`; views those of the table of layouts
// (io/core/views/view_layouts.h).
#pragma once

#include <QString>

namespace bole::desktop {

enum class FileKind { pipeline, cloud, scan, views, unknown };
FileKind kind_of_file(const QString& path);

QString pipeline_endings();  // "*.json", as a dialog takes them
QString cloud_endings();     // of point clouds
QString all_endings();       // of everything that can be opened: "*.json *.las ..."

}  // namespace bole::desktop
