// Goes through the stems from the least certain to the most certain, past those that a person has decided on.
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>
#include <vector>

#include "document/survey.h"

namespace bole::desktop {

class Workbench;

class StemReview : public QObject {
  Q_OBJECT

 public:
  explicit StemReview(Workbench& bench);

  void next() { step(1); }
  void previous() { step(-1); }
  std::size_t open_stems() const;  // not decided on

 private:
  void make_commands();
  // The order is that of the survey; an edit changes states, not the place in the order.
  void show_survey(const Survey& survey);
  void step(int direction);
  void show(std::int64_t tree);

  Workbench& bench_;
  std::vector<std::int64_t> order_;  // all trees, worst first
  std::vector<bool> decided_;
  std::optional<std::int64_t> last_;  // that the review showed
};

}  // namespace bole::desktop
