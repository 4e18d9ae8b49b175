// What a person changes in stems: diameter, height, state and notes of the selected one, circles moved in the slice,
// handles in the 3-D view, stems added and deleted. All of it becomes edits of the document.
#include <QClipboard>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>

#include "document/edit_list.h"
#include "features/stem_edit/stem_handles.h"
#include "panels/table_panel.h"
#include "views/slice_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using Action = stems::StemEdit::Action;

constexpr double min_dbh_cm = 0.1, max_dbh_cm = 2000, min_height_m = 0.1, max_height_m = 200, usual_height_m = 20;
constexpr int own_section = 1;  // of the menu Stem

// An edit of a stem, with its place and diameter as they are.
std::optional<stems::StemEdit> edit_of(const Survey& survey, std::int64_t tree, Action action) {
  const auto row = survey.row_of(tree);
  const auto* stems = survey.stems.get();
  if (!row || !stems->has("x_m") || !stems->has("y_m") || !stems->has("dbh_cm")) return {};
  stems::StemEdit edit;
  edit.action = action;
  edit.at = {stems->numbers("x_m")[*row], stems->numbers("y_m")[*row]};
  edit.was_dbh_cm = stems->numbers("dbh_cm")[*row];
  return edit;
}

// All rows that are chosen in the table, when the selected stem is one of them. A measured value belongs to one tree.
std::vector<std::int64_t> trees_for(Workbench& bench, Action action) {
  const auto tree = bench.selection().tree();
  if (!tree) return {};
  auto chosen = bench.stems().selected_trees();
  const bool of_one = action == Action::resize || action == Action::set_height;
  if (of_one || std::ranges::find(chosen, *tree) == chosen.end()) return {*tree};
  return chosen;
}

// Asks for the value that the edit needs; false when the person thinks better of it.
bool ask_for_value(Workbench& bench, stems::StemEdit& edit) {
  bool given = true;
  if (edit.action == Action::resize)
    edit.dbh_cm =
        QInputDialog::getDouble(&bench, Workbench::tr("Diameter"), Workbench::tr("Diameter at breast height in cm"),
                                *edit.was_dbh_cm, min_dbh_cm, max_dbh_cm, 1, &given);
  if (edit.action == Action::set_height)
    edit.height_m = QInputDialog::getDouble(&bench, Workbench::tr("Height"), Workbench::tr("Height of the tree in m"),
                                            usual_height_m, min_height_m, max_height_m, 1, &given);
  if (edit.action == Action::set_species)
    edit.species = QInputDialog::getText(&bench, Workbench::tr("Species"), Workbench::tr("Species of the tree"),
                                         QLineEdit::Normal, {}, &given)
                       .toStdString();
  if (edit.action == Action::note)
    edit.text =
        QInputDialog::getText(&bench, Workbench::tr("Note"), Workbench::tr("Note"), QLineEdit::Normal, {}, &given)
            .toStdString();
  return given;
}

void edit_selection(Workbench& bench, Action action) {
  std::vector<stems::StemEdit> edits;
  for (const auto tree : trees_for(bench, action))
    if (auto edit = edit_of(bench.runner().survey(), tree, action)) edits.push_back(std::move(*edit));
  if (edits.empty() || !ask_for_value(bench, edits.front())) return;
  for (auto& edit : edits) {  // the same words for all
    edit.species = edits.front().species;
    edit.text = edits.front().text;
  }
  add_edits(bench.session(), edits);  // one step of undo
}

}  // namespace

void install_stem_edit(Workbench& bench) {
  auto* b = &bench;
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key, Action action) {
    std::vector<Place> places{in_menu(Menu::stem, own_section), in_context("stem"), in_context("scene", 1)};
    if (action == Action::accept || action == Action::reject) places.push_back(in_tool_bar("stem_bar", 1));
    bench.commands().add({.id = id,
                          .text = text,
                          .key = key,
                          .places = places,
                          .act = [b, action] { edit_selection(*b, action); },
                          .enabled_when = bench.with_tree()});
  };
  add("stem.set_diameter", Workbench::tr("Set diameter…"), Qt::Key_D, Action::resize);
  add("stem.set_height", Workbench::tr("Set height…"), Qt::Key_H, Action::set_height);
  add("stem.set_species", Workbench::tr("Set species…"), QKeySequence(), Action::set_species);
  add("stem.accept", Workbench::tr("Accept"), Qt::Key_A, Action::accept);
  add("stem.reject", Workbench::tr("Reject"), Qt::Key_R, Action::reject);
  add("stem.note", Workbench::tr("Note…"), Qt::Key_N, Action::note);
  add("stem.delete", Workbench::tr("Delete"), QKeySequence::Delete, Action::remove);
  bench.commands().add({.id = "stem.add",
                        .text = Workbench::tr("Add a tree by a circle"),
                        .key = Qt::Key_C,
                        .places = {in_menu(Menu::stem, own_section)},
                        .turn = [b](bool on) { b->slice().set_adding(on); },
                        .checked_when = [b] { return b->slice().adding(); }});
  bench.commands().add({.id = "stem.copy",
                        .text = Workbench::tr("Copy rows for a spreadsheet"),
                        .key = QKeySequence::Copy,
                        .places = {in_context("stem", 2)},
                        .act = [b] { QGuiApplication::clipboard()->setText(b->stems().selected_text()); },
                        .enabled_when = bench.with_tree(),
                        .owner = &bench.stems()});
  bench.commands().add({.id = "stem.worst_first",
                        .text = Workbench::tr("Worst first"),
                        .places = {in_menu(Menu::stem, own_section), in_context("stem", 2)},
                        .act = [b] { b->stems().sort_worst_first(); },
                        .tip = Workbench::tr("Sorts the table by how little the diameters can be trusted")});
  bench.commands().add_submenu({.id = "stem.columns",
                                .title = Workbench::tr("Columns"),
                                .place = in_context("stem", 2),
                                .fill = [b](QMenu& menu) { b->stems().fill_column_menu(menu); }});
  bench.commands().give_context_menu(bench.stems(), "stem");
  new StemHandles(bench);
  QObject::connect(&bench.slice(), &SliceView::edits_requested, b, [b](const std::vector<stems::StemEdit>& edits) {
    b->guarded([&] { add_edits(b->session(), edits); });
  });
}

}  // namespace bole::desktop
