#include "document/edit_list.h"

#include <QDateTime>
#include <string>

#include "document/edit_words.h"
#include "document/person.h"
#include "document/stage_roles.h"

namespace bole::desktop {
namespace {

constexpr const char *stems_port = "stems", *rows_port = "rows", *traits_port = "traits",
                     *loops_port = "loop_candidates", *points_port = "point_edits";

const pipeline::StageNode& editor_or_refuse(const Session& session, const std::string& port) {
  const std::string needed = "a pipeline with a stage that edits " + port;
  if (!session.has_document()) throw bad_input("no pipeline is open", needed);
  if (const auto* editor = editor_of(session.document(), port)) return *editor;
  throw bad_input("the pipeline has no stage that edits " + port, needed, "Add it behind the stage that makes them");
}

template <class Edit, class Parse>
void add_to_list(Session& session, const char* port, Parse parse, const std::vector<Edit>& more) {
  const auto& editor = editor_or_refuse(session, port);
  auto edits = parse(std::get<std::string>(editor.options.get(edits_option)));
  const auto author = person().toStdString();
  const auto time = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  for (auto edit : more) {
    if (edit.author.empty()) edit.author = author;
    if (edit.time.empty()) edit.time = time;
    edits.push_back(std::move(edit));
  }
  const auto text = to_json(edits);
  parse(text);  // refuses what a file of edits would be refused for
  session.set_option(editor.id, edits_option, text, edit_words(more));
}

}  // namespace

void add_edits(Session& session, const std::vector<stems::StemEdit>& edits) {
  add_to_list(session, stems_port, stems::parse_stem_edits, edits);
}

void add_edits(Session& session, const std::vector<rows::RowEdit>& edits) {
  add_to_list(session, rows_port, rows::parse_row_edits, edits);
}

void add_edits(Session& session, const std::vector<plant::PlantEdit>& edits) {
  add_to_list(session, traits_port, plant::parse_plant_edits, edits);
}

void add_edits(Session& session, const std::vector<slam::LoopEdit>& edits) {
  add_to_list(session, loops_port, slam::parse_loop_edits, edits);
}

void add_edits(Session& session, const std::vector<PointEdit>& edits) {
  add_to_list(session, points_port, parse_point_edits, edits);
}

void check_stems_can_be_edited(const Session& session) { editor_or_refuse(session, stems_port); }

void check_rows_can_be_edited(const Session& session) { editor_or_refuse(session, rows_port); }

bool plant_can_be_edited(const Session& session) {
  return session.has_document() && editor_of(session.document(), traits_port) != nullptr;
}

bool points_can_be_edited(const Session& session) {
  return session.has_document() && editor_of(session.document(), points_port) != nullptr;
}

}  // namespace bole::desktop
