// File > Export a figure…
#include "features/figure_export/figure_dialog.h"
#include "workbench/offered_figures.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

// `chosen`: the name of a figure; empty: the first.
void export_figure(Workbench* b, const QString& chosen = {}) {
  FigureSource source(b->session().has_document() ? &b->session().document() : nullptr, b->runner().results(),
                      b->runner().survey(), OfferedFigures::of(*b).now());
  if (source.names().empty())
    throw bad_input("there is nothing to draw yet", "stems, rows or points", "Run the pipeline first");
  auto* dialog = new FigureDialog(std::move(source), b);
  dialog->choose(chosen);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &FigureDialog::saved, b,
                   [b](const QStringList& files) { b->say(Workbench::tr("Wrote %1").arg(files.join(", "))); });
  dialog->open();
}

}  // namespace

void install_figure_export(Workbench& bench) {
  constexpr int export_section = 2;  // of the menu File
  bench.commands().add({.id = "figure.export",
                        .text = Workbench::tr("Export a figure…"),
                        .key = QKeySequence("Ctrl+Shift+E"),
                        .places = {in_menu(Menu::file, export_section)},
                        .act = [b = &bench] { export_figure(b); },
                        .enabled_when = bench.with_survey()});
  QObject::connect(&OfferedFigures::of(bench), &OfferedFigures::asked, &bench,
                   [b = &bench](const QString& name) { b->guarded([&] { export_figure(b, name); }); });
}

}  // namespace bole::desktop
