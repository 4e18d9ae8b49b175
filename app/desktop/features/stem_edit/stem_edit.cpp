// What a person changes in stems: diameter, height, state and notes of the selected one, circles moved in the slice,
// stems added and deleted. All of it becomes edits of the document.
#include <QInputDialog>

#include "document/edit_list.h"
#include "panels/table_panel.h"
#include "views/slice_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using Action = stems::StemEdit::Action;

constexpr double min_dbh_cm = 0.1, max_dbh_cm = 2000, min_height_m = 0.1, max_height_m = 200, usual_height_m = 20;
constexpr int own_section = 1;  // of the menu Stem

// An edit of the selected stem, with its place and diameter as they are.
std::optional<stems::StemEdit> edit_of_selection(Workbench& bench, Action action) {
  const auto& survey = bench.runner().survey();
  const auto row = bench.selection().tree() ? survey.row_of(*bench.selection().tree()) : std::nullopt;
  const auto* stems = survey.stems.get();
  if (!row || !stems->has("x_m") || !stems->has("y_m") || !stems->has("dbh_cm")) return {};
  stems::StemEdit edit;
  edit.action = action;
  edit.at = {stems->numbers("x_m")[*row], stems->numbers("y_m")[*row]};
  edit.was_dbh_cm = stems->numbers("dbh_cm")[*row];
  return edit;
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
  auto edit = edit_of_selection(bench, action);
  if (edit && ask_for_value(bench, *edit)) add_edits(bench.session(), {*edit});
}

}  // namespace

void install_stem_edit(Workbench& bench) {
  auto* b = &bench;
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key, Action action) {
    bench.commands().add({.id = id,
                          .text = text,
                          .key = key,
                          .places = {in_menu(Menu::stem, own_section), in_context("stem")},
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
  bench.commands().give_context_menu(bench.stems(), "stem");
  QObject::connect(&bench.slice(), &SliceView::edits_requested, b, [b](const std::vector<stems::StemEdit>& edits) {
    b->guarded([&] { add_edits(b->session(), edits); });
  });
}

}  // namespace bole::desktop
