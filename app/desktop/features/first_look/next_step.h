// The line above the views: what is open, and one button for what a person does next.
#pragma once

#include <QFrame>
#include <QStringList>

class QPushButton;

namespace bole::desktop {

class ElidedLabel;
class Workbench;
struct FirstSeen;
struct Survey;

class NextStep : public QFrame {
  Q_OBJECT

 public:
  NextStep(Workbench& bench, QWidget* parent);

  void show_opened();  // a document, of which nothing is known yet
  void show_seen(const FirstSeen& seen);
  void show_preparing(const QString& file, double fraction);  // the index of a large cloud is being built
  void show_problem(const QString& why);                      // its input cannot be read
  void show_survey(const Survey& survey);

  QString command() const { return command_; }  // that the button triggers

 private:
  void offer(const QString& command, const QString& text);
  void offer_run();
  void offer_result();
  void show_work();

  Workbench& bench_;
  ElidedLabel* what_;
  QPushButton* button_;
  QString command_, offered_, offered_text_;  // what is offered while nothing runs
};

}  // namespace bole::desktop
