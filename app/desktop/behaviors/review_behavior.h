// Goes through the stems from the least certain to the most, past those that a person has decided on.
#pragma once

#include <QObject>

#include "document/survey.h"
#include "selection/selection.h"

namespace bole::desktop {

class ReviewBehavior : public QObject {
  Q_OBJECT

 public:
  ReviewBehavior(Selection& selection, QObject* parent) : QObject(parent), selection_(selection) {}

  // The order is that of `survey`; an edit changes states, not the place where the person is.
  void show_survey(const Survey& survey);
  void next() { step(1); }
  void previous() { step(-1); }
  std::size_t open_stems() const;  // not decided on

 Q_SIGNALS:
  void moved(std::int64_t tree);
  void nothing_left();

 private:
  void step(int direction);

  Selection& selection_;
  std::vector<std::int64_t> order_;  // all trees, worst first
  std::vector<bool> decided_;
};

}  // namespace bole::desktop
