// The docks of the window by id: ids are kept in saved layouts and in modes, titles are translated.
#pragma once

#include <QMainWindow>
#include <QString>

class QDockWidget;

namespace bole::desktop {

class Docks {
 public:
  explicit Docks(QMainWindow& window) : window_(window) {}

  // The dock takes the widget over. With `beside`, the id of a dock there, it becomes a tab of it.
  QDockWidget* add(const QString& id, const QString& title, QWidget* widget, Qt::DockWidgetArea area,
                   const QString& beside = {});
  QDockWidget* find(const QString& id) const;  // null when there is none
  QList<QDockWidget*> all() const;             // in the order in which they were added
  void raise(const QString& id);               // shows it, in front of the other tabs

 private:
  QMainWindow& window_;
  QList<QDockWidget*> docks_;
};

}  // namespace bole::desktop
