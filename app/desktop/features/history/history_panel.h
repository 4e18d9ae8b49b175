// The edits of the document, who made them and when, to step back and forth; and the runs of this session with what
// they gave.
#pragma once

#include <QWidget>

class QPushButton;
class QTreeWidget;

namespace bole::desktop {

class Runner;
class Session;

class HistoryPanel : public QWidget {
  Q_OBJECT

 public:
  HistoryPanel(Session& session, Runner& runs, QWidget* parent);

 Q_SIGNALS:
  void compare_asked(int first, int second);  // ids of jobs
  void refused(const QString& text);

 private:
  void fill_edits();
  void fill_runs();
  void show_run();
  void take_options();
  std::vector<int> chosen() const;  // ids, oldest first
  void enable_buttons();

  Session& session_;
  Runner& runs_;
  QTreeWidget *edits_, *list_;
  QPushButton *show_, *take_, *compare_;
};

}  // namespace bole::desktop
