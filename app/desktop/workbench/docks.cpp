#include "workbench/docks.h"

#include <QDockWidget>

namespace bole::desktop {

QDockWidget* Docks::add(const QString& id, const QString& title, QWidget* widget, Qt::DockWidgetArea area,
                        const QString& beside) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(id);
  dock->setWidget(widget);
  window_.addDockWidget(area, dock);
  if (auto* neighbour = find(beside)) {
    window_.tabifyDockWidget(neighbour, dock);
    neighbour->raise();
  }
  docks_ << dock;
  return dock;
}

QDockWidget* Docks::find(const QString& id) const {
  for (auto* dock : docks_)
    if (dock->objectName() == id) return dock;
  return nullptr;
}

QList<QDockWidget*> Docks::all() const { return docks_; }

void Docks::raise(const QString& id) {
  if (auto* dock = find(id)) {
    dock->show();
    dock->raise();
  }
}

}  // namespace bole::desktop
