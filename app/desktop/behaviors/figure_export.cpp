#include "behaviors/figure_export.h"

#include <QMenu>

#include "main_window.h"
#include "panels/figure_dialog.h"

namespace bole::desktop {

void install_figure_export(MainWindow& window) {
  auto* menu = window.menu(Menu::file);
  auto* action = window.add_action(
      menu, "export_figure", MainWindow::tr("Export a figure…"),
      [&window] {
        FigureSource source(window.session().has_document() ? &window.session().document() : nullptr,
                            window.runner().results(), window.runner().survey());
        if (source.names().empty())
          throw bad_input("there is nothing to draw yet", "stems, rows or points", "Run the pipeline first");
        auto* dialog = new FigureDialog(std::move(source), &window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        QObject::connect(dialog, &FigureDialog::saved, &window, [&window](const QStringList& files) {
          window.say(MainWindow::tr("Wrote %1").arg(files.join(", ")));
        });
        dialog->open();
      },
      QKeySequence("Ctrl+Shift+E"));
  menu->insertAction(window.findChild<QAction*>("open_report"), action);  // beside the other export
}

}  // namespace bole::desktop
