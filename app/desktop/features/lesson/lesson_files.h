// The data and documents of a lesson, in a folder of their own.
#pragma once

#include <QString>

#include "base/run.h"
#include "features/lesson/lesson.h"
#include "pipeline/document.h"

namespace bole::desktop {

QString lesson_folder(const Lesson& lesson);  // in the cache of the person
QString lesson_document_path(const Lesson& lesson, const std::string& document);
bool is_lesson_path(const QString& path);  // of a document of any lesson

// Makes the data unless they are there. Throws Error{cancelled}, and Error{bad_input} for an unknown command or option.
void make_lesson_data(const Lesson& lesson, const QString& folder, const Run& run);

// The document with the paths of the data in that folder, which need not exist. Throws Error{bad_input}.
pipeline::PipelineDocument lesson_document(const Lesson& lesson, const std::string& document, const QString& folder);

// Throws Error{bad_input} for a command that makes no data, and for options that it refuses.
void check_lesson_data(const LessonData& data);

}  // namespace bole::desktop
