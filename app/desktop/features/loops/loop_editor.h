// Loop closures in a table and on the map, and what a person decides about them, as edits of the document.
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "document/survey.h"
#include "slam/core/edits/loop_edits.h"
#include "views/scene_drawing.h"

class QTableView;

namespace bole::desktop {

class TableModel;
class Workbench;

class LoopEditor : public QObject {
  Q_OBJECT

 public:
  explicit LoopEditor(Workbench& bench);

  const Table* loops() const;                  // all that were tried; null before a run
  void select(int row);                        // of that table
  void decide(slam::LoopEdit::Action action);  // about the selected one; throws bole::Error

 private:
  void make_dock();
  void make_commands();
  void take(const vtkbridge::RunOutcome& outcome, const Results& results);
  void draw();
  int selected() const;  // -1: none

  Workbench& bench_;
  QTableView* view_ = nullptr;
  TableModel* model_ = nullptr;
  std::shared_ptr<const Table> loops_;
  std::shared_ptr<const Trajectory> walk_;
  std::vector<int> drawn_;  // the row of each drawing
};

}  // namespace bole::desktop
