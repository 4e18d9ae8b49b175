// The dock of lessons: the list of them, or the step of the one that is under way.
#pragma once

#include <QStackedWidget>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace bole::desktop {

class Commands;
class LessonGuide;
class WrappedLabel;

class LessonPanel : public QStackedWidget {
  Q_OBJECT

 public:
  LessonPanel(LessonGuide& guide, Commands& commands, QWidget* parent);

 private:
  QWidget* make_list();
  QWidget* make_page();
  QLayout* make_header(QWidget* page);
  QLayout* make_buttons(QWidget* page);
  void fill_list();
  void show_step();
  void add_sights(QVBoxLayout& layout);
  void show_needs();
  void show_state();  // what is met, numbers of the run, what may be done

  LessonGuide& guide_;
  Commands& commands_;
  QWidget *list_ = nullptr, *page_ = nullptr;
  QVBoxLayout* list_layout_ = nullptr;
  WrappedLabel* title_ = nullptr;
  QLabel* place_ = nullptr;
  QProgressBar* work_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  WrappedLabel* needs_ = nullptr;
  std::vector<QLabel*> sights_;
};

}  // namespace bole::desktop
