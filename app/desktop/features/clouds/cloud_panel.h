// The list of clouds to look at, and pages about the one that is selected.
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;
class QToolButton;
class QTreeWidget;

namespace bole::desktop {

class CloudAlignPage;
class CloudDifferencePage;
class CloudLookPage;
class CloudPlacePage;
class Clouds;
struct CloudEntry;
class Workbench;

class CloudPanel : public QWidget {
  Q_OBJECT

 public:
  CloudPanel(Clouds& clouds, Workbench& bench);  // once the commands are there

  int current() const;  // id of the cloud that is selected; 0: none
  void select(int id);
  void come_forward();
  CloudAlignPage& align() { return *align_; }
  CloudDifferencePage& difference() { return *difference_; }
  QString said() const;  // of the cloud that is selected

 private:
  void make_list();
  QWidget* make_buttons();
  void follow_list();
  void follow_current();
  void follow_reading();
  void follow_work();
  QString words_of(const CloudEntry& cloud) const;
  void help();  // what the button beside the words offers

  Clouds& clouds_;
  Workbench& bench_;
  QTreeWidget* list_;
  QLabel *said_, *reading_;
  QPushButton* help_;
  QToolButton* cancel_;
  QTabWidget* pages_;
  CloudPlacePage* place_;
  CloudLookPage* look_;
  CloudAlignPage* align_;
  CloudDifferencePage* difference_;
  QProgressBar* doing_;
  QToolButton* cancel_work_;
  bool following_ = false;
};

}  // namespace bole::desktop
