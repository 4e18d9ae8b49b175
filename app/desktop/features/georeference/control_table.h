// Control points as a person types them, with the residuals of the last run beside them.
#pragma once

#include <QTableWidget>
#include <string>

#include "cloud/table.h"

namespace bole::desktop {

class ControlTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Column { name, easting, northing, height, map_x, map_y, east, north, up, misfit, note, column_count };

  explicit ControlTable(QWidget* parent);

  void show_points(const Table& points);        // of a file of control points
  void show_targets(const Table& targets);      // rows for targets of the plot that have none yet
  void show_residuals(const Table* residuals);  // of survey.georeference; null: none
  void add_point();
  void remove_points();  // that are selected
  bool paste();          // rows from a spreadsheet, from the current cell on

  // The points as a file, rows without coordinates left out. Throws bole::Error that names the row when a cell is not
  // a number, a name is missing or occurs twice.
  std::string csv() const;
  int points_given() const;  // rows with easting and northing

 Q_SIGNALS:
  void typed();  // by a person

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QString text(int row, int column) const;
  void put(int row, int column, const QString& text);
  int row_named(const QString& name) const;  // -1: none
  int new_row(const QString& name);
  std::string line_of(int row) const;

  bool filling_ = false;
};

}  // namespace bole::desktop
