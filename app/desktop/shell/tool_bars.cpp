#include "shell/tool_bars.h"

#include <QAction>
#include <QToolBar>
#include <QToolButton>

#include "shell/main_window.h"

namespace bole::desktop {
namespace {

constexpr int icon_px = 20;

void make_tool_bar(MainWindow& window, const char* name, const QString& title) {
  auto* bar = window.addToolBar(title);
  bar->setObjectName(name);
  bar->setIconSize({icon_px, icon_px});
  int section = 0;
  for (const auto& item : window.commands().items(in_tool_bar(name))) {
    if (item.section != section && !bar->actions().isEmpty()) bar->addSeparator();
    section = item.section;
    bar->addAction(item.entry->action);
    // Words cost room: only what everybody looks for has one.
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(item.entry->action));
        button != nullptr && item.entry->command.id == QLatin1String("run.all"))
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
}

}  // namespace

void make_tool_bars(MainWindow& window) {
  make_tool_bar(window, "run_bar", MainWindow::tr("Run"));
  make_tool_bar(window, "file_bar", MainWindow::tr("File"));
  make_tool_bar(window, "stem_bar", MainWindow::tr("Stem"));
  make_tool_bar(window, "view_bar", MainWindow::tr("View"));
  make_tool_bar(window, "measure_bar", MainWindow::tr("Measure"));
}

}  // namespace bole::desktop
