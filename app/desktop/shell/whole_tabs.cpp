#include "shell/whole_tabs.h"

#include <QChildEvent>
#include <QMainWindow>
#include <QTabBar>

namespace bole::desktop {

WholeTabs::WholeTabs(QMainWindow& window) : QObject(&window) { window.installEventFilter(this); }

// The window makes a bar when docks are first stacked, and tells it to shorten what does not fit.
bool WholeTabs::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildPolished)
    if (auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) {
      bar->setElideMode(Qt::ElideNone);
      bar->setUsesScrollButtons(true);
    }
  return QObject::eventFilter(watched, event);
}

}  // namespace bole::desktop
