// Rows of plants in the 3-D view and in a table, and what a person does to them, as edits of the document.
#pragma once

#include <QObject>
#include <QStringList>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/survey.h"
#include "rows/core/edits/row_edits.h"
#include "views/scene_drawing.h"

class QModelIndex;
class QTableView;

namespace bole::desktop {

class TableModel;
class Workbench;

class RowEditor : public QObject {
  Q_OBJECT

 public:
  explicit RowEditor(Workbench& bench);

  void apply(const rows::RowEdit& edit);  // as add_edits()

  // What the next clicks in the view are for.
  enum class Task { add, split, merge };
  void start(Task task);
  void stop();
  std::optional<Task> task() const { return task_; }
  void remove();                         // the selected row
  void renumber(const std::string& to);  // the selected row
  void note(const std::string& text);    // on the selected row

 private:
  struct Row {
    std::string id;
    std::vector<Eigen::Vector2d> course;
    Eigen::Vector2d from, to;
    double angle_deg = 0;
  };
  void make_dock();
  void make_commands();
  void show_survey(const Survey& survey);
  void read_rows(const Survey& survey);
  double ground_z(const Eigen::Vector2d& at) const;
  Eigen::Vector3d on_ground(const Eigen::Vector2d& at) const;
  void draw();
  void draw_plants(std::vector<SceneDrawing>& drawings) const;
  SceneDrawing drawing_of(const Row& row) const;
  const Row* selected() const;
  const Row& selected_or_refuse() const;  // throws bole::Error
  rows::RowEdit edit_of(const Row& row, rows::RowEdit::Action action) const;
  void drag(int which, int end, const Eigen::Vector3d& at, bool released);
  void take(const Eigen::Vector3d& place);
  void click_row(int which);
  void follow_selection();

  Workbench& bench_;
  QTableView* view_ = nullptr;
  TableModel* model_ = nullptr;
  Survey survey_;
  std::vector<Row> rows_;
  std::vector<double> ground_x_, ground_y_, ground_z_;  // a sample of the cloud
  std::optional<Task> task_;
  std::vector<Eigen::Vector2d> clicked_;
  bool following_ = false;
  bool raised_ = false;  // the dock, for this document
};

}  // namespace bole::desktop
