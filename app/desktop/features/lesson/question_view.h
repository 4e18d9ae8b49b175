// One question of a lesson: choices or a number, a button to check the answer, and what is said to it.
#pragma once

#include <QWidget>

#include "features/lesson/lesson_guide.h"

class QButtonGroup;
class QLineEdit;
class QVBoxLayout;

namespace bole::desktop {

class WrappedLabel;

class QuestionView : public QWidget {
  Q_OBJECT

 public:
  QuestionView(LessonGuide& guide, int question, QWidget* parent);

  void check();  // the answer that is chosen or typed

 private:
  void add_choices(const LessonQuestion& question, QVBoxLayout& layout);
  void add_number(const LessonQuestion& question, QVBoxLayout& layout);

  LessonGuide& guide_;
  int question_;
  QButtonGroup* choices_ = nullptr;
  QLineEdit* number_ = nullptr;
  WrappedLabel* feedback_;
};

}  // namespace bole::desktop
