// Leads a student through a lesson: which step, what it still needs, answers and what is said to them.
#pragma once

#include <QObject>
#include <optional>
#include <set>

#include "features/lesson/lesson.h"
#include "features/lesson/lesson_needs.h"
#include "features/lesson/lesson_progress.h"
#include "features/lesson/lesson_values.h"
#include "running/background_work.h"

namespace bole::desktop {

class LessonGuide : public QObject {
  Q_OBJECT

 public:
  LessonGuide(Workbench& bench, std::vector<Lesson> lessons);

  const std::vector<Lesson>& lessons() const { return lessons_; }
  const Lesson* lesson() const { return lesson_; }  // null: none is under way
  int step_index() const { return step_; }
  const LessonStep& step() const { return lesson_->steps[static_cast<std::size_t>(step_)]; }

  // Goes on where the student left it, and opens its data. Throws Error{bad_input} for an unknown id.
  void begin(const std::string& id);
  void begin_again();  // from the first step, without answers
  void leave();
  void go(int step);

  struct Need {
    QString words;
    bool met, option;  // option: show_need() leads to it
  };
  std::vector<Need> needs() const;
  bool all_met() const;
  void show_need(int need);  // brings the panel of options to the front, with the stage of this one
  bool may_go_on() const { return all_met() || passed(); }
  bool passed() const { return progress().step() > step_; }  // the student was in a later step already
  LessonProgress progress() const { return LessonProgress(lesson_->id); }

  // Does what the step still needs, one after the other, then runs its commands and shows its panels.
  void show_me();
  bool showing() const { return showing_; }
  void cancel();  // the data that are made
  bool making_data() const { return work_.busy(); }

  // What the expression gives in the last run of the student. Throws Error{bad_input}.
  double value(const std::string& expression) const;

  struct Feedback {
    bool right;
    QString text;
  };
  Feedback answer_number(int question, const QString& typed);
  Feedback answer_choice(int question, int choice);

 Q_SIGNALS:
  void step_changed();                                    // another lesson or step
  void changed();                                         // what is met, or under way
  void progressed(double fraction, const QString& what);  // of the data

 private:
  void connect_window();
  void take_run(int job);
  void look_again();  // something in the window changed
  void keep_values();
  void open_data();
  void open_document();
  void select_stage();  // of the first option that the step needs
  void go_on_showing();
  void stop_showing(const QString& why);
  LessonPlace place() const { return {bench_, *lesson_, ran_}; }
  Feedback note(int question, const Feedback& feedback);

  Workbench& bench_;
  std::vector<Lesson> lessons_;
  const Lesson* lesson_ = nullptr;
  int step_ = 0;
  LessonRun run_, ended_;  // of the document of the lesson; the last that ended
  std::string ran_;        // the document that run_ is of
  bool showing_ = false;
  std::set<std::size_t> tried_;  // needs that were met by show_me()
  BackgroundWork work_;
};

}  // namespace bole::desktop
