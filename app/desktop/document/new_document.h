// Documents that the window makes: for a file that was dropped on it, as `bole survey` does (documents/new_document.h),
// and for the sample plot.
#pragma once

#include <QString>

#include "base/run.h"
#include "pipeline/document.h"

namespace bole::desktop {

// A stem map from a cloud, a survey from a scan, the traits of a plant from a folder of views. Throws Error{bad_input}
// for other files.
pipeline::PipelineDocument document_for_file(const QString& path);
// Where that document is saved unless the person says otherwise: beside the file (of views: beside their folder), under
// a name that is free or holds a pipeline for this file. Throws Error{bad_input} when all are taken.
QString pipeline_path_for_file(const QString& path);
QString sample_pipeline_path(const QString& wanted);  // likewise for the sample plot in the folder of `wanted`

// Simulates the sample plot into `folder` when it is not there yet, about a second of work, and gives the document
// that surveys it: raw scan, poses, reference trees. Throws Error{cancelled} and Error{failed}.
pipeline::PipelineDocument sample_document(const QString& folder, const Run& run);

}  // namespace bole::desktop
