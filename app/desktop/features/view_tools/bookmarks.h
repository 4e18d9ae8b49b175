// Views to come back to, kept beside the document (plot.views.json), and the view as a picture.
#pragma once

#include <QObject>
#include <QString>
#include <utility>
#include <vector>

#include "views/view_point.h"

class QMenu;

namespace bole::desktop {

class Workbench;

class Bookmarks : public QObject {
  Q_OBJECT

 public:
  explicit Bookmarks(Workbench& bench);

  void add(const QString& name);  // the view as it is; one of that name is replaced
  void remove(const QString& name);
  void go(const QString& name);
  QStringList names() const;

 private:
  void make_commands();
  void fill(QMenu& menu, void (Bookmarks::*act)(const QString&));
  void load();
  void store() const;
  QString file() const;

  Workbench& bench_;
  std::vector<std::pair<QString, ViewPoint>> list_;
};

}  // namespace bole::desktop
