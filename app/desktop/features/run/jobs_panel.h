// The runs of this session that wait, run or are over, with their progress; ends them.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QTimer;
class QTreeWidget;
class QTreeWidgetItem;

namespace bole::desktop {

class Runner;
struct Job;

class JobsPanel : public QWidget {
  Q_OBJECT

 public:
  JobsPanel(Runner& runs, QWidget* parent);

  QSize sizeHint() const override { return {420, 180}; }

 private:
  void refresh();
  void fill(QTreeWidgetItem* item, const Job& job) const;
  int selected() const;  // id; that of the running job when nothing is selected; 0 without one
  void show_selected();

  Runner& runs_;
  QTreeWidget* tree_;
  QLabel* details_;
  QPushButton *cancel_, *finish_;
  QTimer *soon_, *clock_;
};

}  // namespace bole::desktop
