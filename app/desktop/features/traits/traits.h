// What was measured on a plant: drawn on it, and in tables with intervals.
#pragma once

#include <QObject>

#include "document/survey.h"

class QLabel;
class QTabWidget;

namespace bole::desktop {

class TableModel;
class Workbench;

class Traits : public QObject {
  Q_OBJECT

 public:
  explicit Traits(Workbench& bench);

 private:
  void make_dock();
  void show_survey(const Survey& survey);

  Workbench& bench_;
  QTabWidget* tabs_ = nullptr;
  QLabel* how_ = nullptr;  // how the stem was measured, whether the scale is known
  std::vector<TableModel*> models_;
  bool raised_ = false, drawn_ = true;
};

}  // namespace bole::desktop
