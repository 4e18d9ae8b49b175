// Answers questions of the window, which wait for a person.
#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace bole::desktop {

// The next one that comes up.
inline void answer(QMessageBox::StandardButton button) {
  QTimer::singleShot(0, [button] {
    for (auto* widget : QApplication::topLevelWidgets())
      if (auto* box = qobject_cast<QMessageBox*>(widget)) return box->button(button)->click();
    QTimer::singleShot(20, [button] { answer(button); });
  });
}

}  // namespace bole::desktop
