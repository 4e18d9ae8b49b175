#include "features/lesson/lesson_files.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include "document/new_document.h"
#include "documents/new_document.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/tables/table_file.h"
#include "sim/core/field/simulate_field.h"
#include "sim/core/plot/simulate.h"

namespace bole::desktop {
namespace {

constexpr auto sample = "sample_plot";

QString lessons_folder() { return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/lessons"; }

template <class Options>
Options options_of(const LessonData& data) {
  OptionSet options(option_table(static_cast<const Options*>(nullptr)));
  for (const auto& [name, value] : data.options) options.set_text(name, value);
  options.check_all();
  return options.as<Options>();
}

// What made the data, as the mark that they are complete has it: with other options they are made again.
QByteArray recipe_of(const LessonData& data) {
  std::string text = data.command;
  for (const auto& [name, value] : data.options) text += " " + name + "=" + value;
  return QByteArray::fromStdString(text);
}

bool is_made(const QString& mark, const LessonData& data) {
  QFile file(mark);
  return file.open(QIODevice::ReadOnly) && file.readAll() == recipe_of(data);
}

// The files of `bole simulate-field` that lessons read.
void simulate_field_into(const std::filesystem::path& folder, const LessonData& data, const Run& run) {
  const auto scan = sim::simulate_field(options_of<sim::FieldSimulationOptions>(data), run);
  std::filesystem::create_directories(folder);
  io::write_ply(folder / "frame_000.ply", scan.frames.front(), run);
  const std::pair<const char*, const Table*> tables[] = {
      {"attitude.csv", &scan.attitude}, {"marks.csv", &scan.marks}, {"plants.csv", &scan.plants}};
  for (const auto& [name, table] : tables) io::write_table(folder / name, *table);
}

}  // namespace

QString lesson_folder(const Lesson& lesson) { return lessons_folder() + "/" + QString::fromStdString(lesson.id); }

QString lesson_document_path(const Lesson& lesson, const std::string& document) {
  return lesson_folder(lesson) + "/" + QString::fromStdString(document) + ".json";
}

bool is_lesson_path(const QString& path) { return path.startsWith(lessons_folder() + "/"); }

void check_lesson_data(const LessonData& data) {
  if (data.command == "simulate")
    options_of<sim::SimulationOptions>(data);
  else if (data.command == "simulate-field")
    options_of<sim::FieldSimulationOptions>(data);
  else if (data.command != sample)
    throw bad_input("'" + data.command + "' makes no data", "simulate, simulate-field or sample_plot");
}

void make_lesson_data(const Lesson& lesson, const QString& folder, const Run& run) {
  check_lesson_data(lesson.data);
  if (lesson.data.command == sample) {
    sample_document(folder, run);
    return;
  }
  const QString done = folder + "/complete";  // written last: half-made data are made again
  if (is_made(done, lesson.data)) return;
  QFile::remove(done);
  if (lesson.data.command == "simulate")
    sim::simulate(options_of<sim::SimulationOptions>(lesson.data), folder.toStdString(), run);
  else
    simulate_field_into(folder.toStdString(), lesson.data, run);
  QFile mark(done);
  if (!mark.open(QIODevice::WriteOnly) || mark.write(recipe_of(lesson.data)) < 0)
    throw failure("cannot write " + done.toStdString(), "a folder to write into");
}

pipeline::PipelineDocument lesson_document(const Lesson& lesson, const std::string& document, const QString& folder) {
  const auto& made = lesson.document(document);
  auto result = made.pipeline == sample ? sample_document(folder, {}) : documents::shipped_pipeline(made.pipeline);
  for (const auto& [name, value] : made.set) {
    const auto [stage, option] = pipeline::parse_source(name);
    const auto& spec = result.at(stage).type->options->at(option);
    const bool file = spec.text_kind == TextKind::input_path;
    result.set(name, file ? QDir(folder).absoluteFilePath(QString::fromStdString(value)).toStdString() : value);
  }
  return result;
}

}  // namespace bole::desktop
