#include "behaviors/review_behavior.h"

#include <algorithm>

#include "render/charts/columns.h"
#include "render/charts/worst_first.h"

namespace bole::desktop {

void ReviewBehavior::show_survey(const Survey& survey) {
  order_.clear(), decided_.clear();
  if (!survey.stems || !survey.stems->has("tree_id")) return;
  const auto ids = survey.stems->integers("tree_id");
  const auto states = render::texts_or_empty(*survey.stems, "state");
  for (const auto row : render::worst_first(*survey.stems)) {
    order_.push_back(ids[row]);
    decided_.push_back(states[row] == "accepted" || states[row] == "rejected" || states[row] == "edited");
  }
}

std::size_t ReviewBehavior::open_stems() const { return static_cast<std::size_t>(std::ranges::count(decided_, false)); }

void ReviewBehavior::step(int direction) {
  const auto n = static_cast<std::ptrdiff_t>(order_.size());
  if (n == 0) return;
  const auto here = selection_.tree() ? std::ranges::find(order_, *selection_.tree()) : order_.end();
  auto at = here != order_.end() ? here - order_.begin() : direction > 0 ? -1 : n;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    at = (at + direction + n) % n;
    const auto i = static_cast<std::size_t>(at);
    if (decided_[i]) continue;
    selection_.select(order_[i]);
    Q_EMIT moved(order_[i]);
    return;
  }
  Q_EMIT nothing_left();
}

}  // namespace bole::desktop
