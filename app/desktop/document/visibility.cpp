#include "document/visibility.h"

namespace bole::desktop {

void Visibility::show(const std::string& stage, ViewKind view, bool on) {
  auto& hidden = hidden_[static_cast<std::size_t>(view)];
  if (on ? hidden.erase(stage) == 0 : !hidden.insert(stage).second) return;
  Q_EMIT changed();
}

void Visibility::show_all() {
  hidden_ = {};
  outcome_ = {};
  results_.clear();
  Q_EMIT changed();
}

void Visibility::take(const RunOutcome& outcome, const Results& results) {
  outcome_ = outcome;
  results_ = results;
}

Survey Visibility::survey_for(ViewKind view, const Survey& all) const {
  if (hidden(view).empty() || results_.empty()) return all;
  Results rest = results_;
  for (const auto& stage : hidden(view)) rest.erase(stage);
  return survey_of(outcome_, rest, all, Run());
}

}  // namespace bole::desktop
