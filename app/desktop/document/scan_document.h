// A pipeline document for a scan that somebody opens: the survey of a forest plot, pipelines/forest_plot.json.
#pragma once

#include <QString>

#include "pipeline/document.h"

namespace bole::desktop {

// A recording of packets, or a folder of frames.
bool is_scan(const QString& path);

// Where the document of a scan is kept: beside it under its name, or among the user's documents where nothing can be
// written there. It may be there already, from the last time. The name of a file that is no pipeline of this scan is
// left alone.
QString document_path_for_scan(const QString& scan);

// Throws bole::Error when the pipeline that it is made from is not installed.
PipelineDocument document_for_scan(const QString& scan);

}  // namespace bole::desktop
