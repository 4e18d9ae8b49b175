// The pipeline as a graph beside the list of its stages.
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>

#include "features/graph/graph_view.h"
#include "look/last_folder.h"
#include "panels/properties_panel.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int graph_menu_section = 1, graph_file_section = 2;  // of the menus View and File

void save_graph(Workbench* b, const GraphView* view) {
  const QString path = note_folder("export", QFileDialog::getSaveFileName(b, Workbench::tr("Save the graph"),
                                                                          in_last_folder("export", "pipeline.svg"),
                                                                          Workbench::tr("Pictures (*.svg *.png)")));
  if (path.isEmpty()) return;
  view->save(path);
  b->say(Workbench::tr("Wrote %1").arg(path));
}

void go_to_options(Workbench* b) {
  b->docks().raise("options");
  for (auto* widget : b->properties().findChildren<QWidget*>())
    if ((widget->focusPolicy() & Qt::TabFocus) && widget->isEnabled() && widget->isVisibleTo(&b->properties()))
      return widget->setFocus(Qt::TabFocusReason);
}

void make_commands(Workbench* b, GraphView* view) {
  auto& commands = b->commands();
  commands.add({.id = "graph.show",
                .text = Workbench::tr("Pipeline as a graph"),
                .key = QKeySequence("Ctrl+G"),
                .places = {in_menu(Menu::view, graph_menu_section), in_context("pipeline", 2)},
                .act =
                    [b, view] {
                      b->docks().raise("graph");
                      view->setFocus();
                    },
                .enabled_when = b->with_document()});
  commands.add({.id = "graph.fit",
                .text = Workbench::tr("Whole graph"),
                .key = QKeySequence("Ctrl+0"),
                .places = {in_context("graph")},
                .act = [view] { view->fit(); },
                .owner = view});
  commands.add({.id = "graph.save",
                .text = Workbench::tr("Save the graph as a picture…"),
                .places = {in_menu(Menu::file, graph_file_section), in_context("graph")},
                .act = [b, view] { save_graph(b, view); },
                .enabled_when = b->with_document()});
  // What the list of stages has keys for works on the same stage here.
  for (const auto& item : commands.items(in_context("pipeline")))
    if (item.entry->action != nullptr && item.entry->command.owner != nullptr) view->addAction(item.entry->action);
  QObject::connect(view, &GraphView::menu_asked, b, [b](const QPoint& global) {
    QMenu menu;
    b->commands().fill(menu, in_context("pipeline"));
    menu.addSeparator();
    b->commands().fill(menu, in_context("graph"));
    menu.exec(global);
  });
}

}  // namespace

void install_graph(Workbench& bench) {
  auto* view = new GraphView(bench);
  bench.docks().add("graph", Workbench::tr("Pipeline graph"), view, Qt::BottomDockWidgetArea, "stems");
  bench.docks().find("graph")->hide();
  make_commands(&bench, view);
  QObject::connect(view, &GraphView::options_asked, &bench, [b = &bench] { go_to_options(b); });
}

}  // namespace bole::desktop
