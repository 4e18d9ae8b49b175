// Quality check of a stem map against trees measured in the field: matched, missed and false ones in a map, a table,
// a chart and the 3-D view; edits mend them, and the evaluation follows.
#pragma once

#include <vtkSmartPointer.h>

#include <QWidget>

#include "document/survey.h"
#include "features/field_check/field_list.h"
#include "features/field_check/plot_map.h"

class QLabel;
class QTableView;
class vtkActor;

namespace bole::desktop {

class RowFilter;
class TableModel;
class Workbench;

class FieldCheck : public QWidget {
  Q_OBJECT

 public:
  explicit FieldCheck(Workbench& bench);

  void load(const QString& file);  // asks for the columns; throws bole::Error
  // The same without asking.
  void load(const QString& file, const FieldMapping& mapping, const std::string& align);
  void show_survey(const Survey& survey);
  void choose(int row);  // of the matches
  // What the menu of a row offers. Throw bole::Error when the row is not of that kind.
  void add_missed(int row);
  void delete_false(int row);

  PlotMap& map() { return *map_; }
  const std::vector<MatchRow>& rows() const { return rows_; }

 private:
  void make_commands();
  QWidget* header();
  void make_table();
  void show_menu(int row, const QPoint& global);
  const MatchRow* current() const;  // null: none
  void show_summary();
  void draw_rings();  // about the stems of the 3-D view
  int row_of_view(const QModelIndex& index) const;

  Workbench& bench_;
  Survey survey_;
  std::vector<MatchRow> rows_;
  QLabel* summary_;
  PlotMap* map_;
  QTableView* table_;
  TableModel* model_;
  RowFilter* filter_;
  std::vector<vtkSmartPointer<vtkActor>> rings_;
  int current_ = -1;  // row of the matches
  bool following_ = false;
};

}  // namespace bole::desktop
