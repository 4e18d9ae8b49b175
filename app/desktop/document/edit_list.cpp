#include "document/edit_list.h"

#include <QDateTime>
#include <algorithm>
#include <set>
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

// Calls `act` with the port and the reader of each kind of edit.
template <class Act>
void for_each_kind(Act act) {
  act(stems_port, stems::parse_stem_edits);
  act(points_port, parse_point_edits);
  act(rows_port, rows::parse_row_edits);
  act(loops_port, slam::parse_loop_edits);
  act(traits_port, plant::parse_plant_edits);
}

Eigen::Vector3d middle_of(const PointRegion& region) {
  const auto mean = [](const std::vector<Eigen::Vector3d>& places) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : places) sum += p;
    return Eigen::Vector3d(sum / static_cast<double>(std::max<std::size_t>(places.size(), 1)));
  };
  switch (region.kind) {
    case PointRegion::Kind::ball:
      break;
    case PointRegion::Kind::box:
      return (region.min + region.max) / 2;
    case PointRegion::Kind::outline:
      return mean(region.outline);
    case PointRegion::Kind::brush:
      return mean(region.path);
  }
  return region.at;
}

void put_place(const stems::StemEdit& edit, EditEntry& entry) { entry.stem = edit.at; }
void put_place(const PointEdit& edit, EditEntry& entry) { entry.place = middle_of(edit.region); }
void put_place(const plant::PlantEdit& edit, EditEntry& entry) {
  if (edit.action == plant::PlantEdit::Action::assign) entry.place = middle_of(edit.region);
  if (edit.action == plant::PlantEdit::Action::set_base) entry.place = edit.at;
}
void put_place(const rows::RowEdit&, EditEntry&) {}
void put_place(const slam::LoopEdit&, EditEntry&) {}

template <class Edit>
EditEntry entry_of(const char* port, std::size_t index, const Edit& edit) {
  EditEntry entry;
  entry.port = port;
  entry.index = index;
  entry.what = edit_words(std::vector<Edit>{edit});
  entry.author = QString::fromStdString(edit.author);
  entry.time = QString::fromStdString(edit.time);
  entry.reason = QString::fromStdString(edit.reason);
  put_place(edit, entry);
  return entry;
}

// Whether a row of the log of a stage is about the edit.
bool is_in(const Table& log, std::size_t row, const EditEntry& entry) {
  if (log.text("author", row) != entry.author.toStdString() || log.text("time", row) != entry.time.toStdString())
    return false;
  return !entry.stem || !log.has("x_m") ||
         *entry.stem == Eigen::Vector2d(log.numbers("x_m")[row], log.numbers("y_m")[row]);
}

}  // namespace

std::vector<EditEntry> listed_edits(const Session& session) {
  std::vector<EditEntry> entries;
  if (!session.has_document()) return entries;
  for_each_kind([&](const char* port, const auto& parse) {
    const auto* editor = editor_of(session.document(), port);
    if (editor == nullptr) return;
    const auto edits = parse(std::get<std::string>(editor->options.get(edits_option)));
    for (std::size_t i = 0; i < edits.size(); ++i) entries.push_back(entry_of(port, i, edits[i]));
  });
  return entries;
}

void tell_outcomes(std::vector<EditEntry>& entries, const Results& results) {
  constexpr const char* log_port = "log";
  for (auto& entry : entries) entry.applied.reset(), entry.message.clear();
  for (const auto& [stage, outputs] : results) {
    if (!outputs.has(log_port)) continue;
    const auto& log = outputs.table(log_port);
    if (!log.has("outcome") || !log.has("author") || !log.has("time")) continue;
    for (std::size_t row = 0; row < log.rows(); ++row)
      if (const auto entry =
              std::ranges::find_if(entries, [&](const auto& e) { return !e.applied && is_in(log, row, e); });
          entry != entries.end()) {
        entry->applied = log.text("outcome", row) == "applied";
        if (log.has("message")) entry->message = QString::fromStdString(log.text("message", row));
      }
  }
}

void remove_edits(Session& session, const std::vector<EditEntry>& entries) {
  auto& undo = session.undo_stack();
  undo.beginMacro(QObject::tr("take back decisions (%1)").arg(entries.size()));
  for_each_kind([&](const char* port, const auto& parse) {
    std::set<std::size_t> out;
    for (const auto& entry : entries)
      if (entry.port == port) out.insert(entry.index);
    if (out.empty()) return;
    const auto& editor = editor_or_refuse(session, port);
    auto edits = parse(std::get<std::string>(editor.options.get(edits_option)));
    std::size_t index = 0;
    std::erase_if(edits, [&](const auto&) { return out.contains(index++); });
    session.set_option(editor.id, edits_option, to_json(edits));
  });
  undo.endMacro();
}

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
