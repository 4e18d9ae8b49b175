// The mouse drawn over a widget with the left button held.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <vector>

namespace bole::desktop {

inline void drag_over(QWidget& widget, const std::vector<QPoint>& path) {
  QTest::mousePress(&widget, Qt::LeftButton, {}, path.front());
  for (const auto& to : path) {
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&widget, &move);
  }
  QTest::mouseRelease(&widget, Qt::LeftButton, {}, path.back());
}

}  // namespace bole::desktop
