// File > Export a figure…
#include "features/figure_export/figure_dialog.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

void export_figure(Workbench* b) {
  FigureSource source(b->session().has_document() ? &b->session().document() : nullptr, b->runner().results(),
                      b->runner().survey());
  if (source.names().empty())
    throw bad_input("there is nothing to draw yet", "stems, rows or points", "Run the pipeline first");
  auto* dialog = new FigureDialog(std::move(source), b);
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
}

}  // namespace bole::desktop
