// The plot on the earth: control points and their coordinate system in a form, with the residuals of the adjustment.
#pragma once

#include <QWidget>
#include <memory>

#include "document/survey.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace bole::desktop {

class ControlTable;
class Workbench;

class PlaceForm : public QWidget {
  Q_OBJECT

 public:
  explicit PlaceForm(Workbench& bench);

  ControlTable& table() { return *table_; }
  QLineEdit& system() { return *system_; }
  QString said() const;
  // Writes the points beside the document, joins the file to it as one step of undo, and runs it. A file that is there
  // stays as it is, so that undo brings the points back. Throws bole::Error.
  void apply();
  void read(const QString& file);  // takes over the points of a file; throws bole::Error

 private:
  const pipeline::StageNode* stage() const;  // null: the document has none
  void make_widgets();
  void make_commands();
  void show_document();
  void take(const vtkbridge::RunOutcome& outcome, const Results& results);
  void show_stage_options();
  void draw();
  QString new_file(const std::string& content) const;
  void say(const QString& text);

  Workbench& bench_;
  ControlTable* table_;
  QLineEdit* system_;
  QLabel* said_;
  QPushButton* apply_;
  std::shared_ptr<const Table> residuals_;
  QString file_;  // that is shown
};

}  // namespace bole::desktop
