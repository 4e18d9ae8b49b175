// Pairs of points with their residuals, and fine registration, for the selected cloud.
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTreeWidget;

namespace bole::desktop {

class CloudJobs;
class CloudPairs;
class Clouds;
struct CloudEntry;
class Workbench;

// The survey and the other clouds, with their ids.
void list_partners(QComboBox& box, const Clouds& clouds, int but);

class CloudAlignPage : public QWidget {
  Q_OBJECT

 public:
  CloudAlignPage(Clouds& clouds, CloudPairs& pairs, CloudJobs& jobs, Workbench& bench);
  void follow(const CloudEntry* cloud);  // null: none is selected
  int selected_pair() const;             // -1: none
  int onto() const;                      // of the fine registration: id of a cloud, 0: the survey
  double reach_m() const;

 private:
  void make_list();
  QWidget* make_buttons();
  QWidget* make_fine();
  void follow_pairs();

  Clouds& clouds_;
  CloudPairs& pairs_;
  CloudJobs& jobs_;
  Workbench& bench_;
  int cloud_ = 0;  // id
  QLabel *next_, *said_, *fine_said_;
  QTreeWidget* list_;
  QCheckBox* scale_;
  QComboBox* onto_;
  QDoubleSpinBox* reach_;
  bool following_ = false;
};

}  // namespace bole::desktop
