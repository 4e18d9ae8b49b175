// The views of a camera beside the plant: a list, the picture of one of them, and the cameras in the 3-D view. Pictures
// are read as soon as a pipeline is open; poses and cloud come with its runs.
#pragma once

#include <QObject>
#include <memory>

#include "document/survey.h"
#include "running/picture_reader.h"

class QTableView;

namespace bole::desktop {

class PicturePanel;
class TableModel;
class Workbench;

// One row per view: place, name, time, and what tracking says of it where that is known.
std::shared_ptr<const Table> view_table(const ViewSource& views, const Trajectory* poses, const Table* tracking);

class Pictures : public QObject {
  Q_OBJECT

 public:
  explicit Pictures(Workbench& bench);

  PicturePanel& panel() { return *panel_; }
  const ViewSource* views() const { return views_.get(); }
  void step(int by);  // to another view

 private:
  void make_docks();
  void make_commands();
  void open_views();
  void take_views(const std::shared_ptr<const ViewSource>& views);
  void show_survey(const Survey& survey);
  void follow();  // the survey: list, cameras, picture
  void follow_selection();
  void ask();
  const Trajectory* poses() const;  // of the run, else as the data give them; null where there are none

  Workbench& bench_;
  PicturePanel* panel_ = nullptr;
  QTableView* list_ = nullptr;
  TableModel* model_ = nullptr;
  PictureReader* reader_;
  std::string opened_;  // what the reader has open
  std::shared_ptr<const ViewSource> views_;
  Survey survey_;
  bool following_ = false;
};

}  // namespace bole::desktop
