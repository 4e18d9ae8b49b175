// What was measured on a plant: drawn on it, in tables with intervals, and a form to correct it.
#pragma once

#include <QObject>

#include "document/survey.h"

class QLabel;
class QTabWidget;

namespace bole::desktop {

class PlantEditor;
class PlantForm;
class TableModel;
class Workbench;

class Traits : public QObject {
  Q_OBJECT

 public:
  explicit Traits(Workbench& bench);

  PlantEditor& editor() { return *editor_; }

 private:
  void make_dock();
  void show_survey(const Survey& survey);

  Workbench& bench_;
  PlantForm* form_ = nullptr;
  PlantEditor* editor_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QLabel* how_ = nullptr;  // how the stem was measured, whether the scale is known
  std::vector<TableModel*> models_;
  bool raised_ = false, drawn_ = true;
};

}  // namespace bole::desktop
