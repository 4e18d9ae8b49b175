#include "features/stem_review/stem_review.h"

#include <algorithm>

#include "render/charts/columns.h"
#include "render/charts/worst_first.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {

StemReview::StemReview(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  connect(&bench_, &Workbench::survey_shown, this, &StemReview::show_survey);
}

void StemReview::make_commands() {
  auto& commands = bench_.commands();
  const std::vector<Place> menu{in_menu(Menu::stem), in_tool_bar("stem_bar")};
  commands.add({.id = "stem.next",
                .text = tr("Next doubtful stem"),
                .key = QKeySequence("Ctrl+Right"),
                .places = menu,
                .act = [this] { next(); },
                .enabled_when = bench_.with_survey()});
  commands.add({.id = "stem.previous",
                .text = tr("Previous doubtful stem"),
                .key = QKeySequence("Ctrl+Left"),
                .places = menu,
                .act = [this] { previous(); },
                .enabled_when = bench_.with_survey()});
  commands.add({.id = "stem.zoom",
                .text = tr("Zoom to the selected stem"),
                .key = Qt::Key_Z,
                .places = {in_menu(Menu::stem), in_tool_bar("stem_bar"), in_context("scene", 1)},
                .act = [this] { bench_.scene().zoom_to_tree(*bench_.selection().tree()); },
                .enabled_when = bench_.with_tree()});
}

void StemReview::show_survey(const Survey& survey) {
  order_.clear();
  decided_.clear();
  if (!survey.stems || !survey.stems->has("tree_id")) return;
  const auto ids = survey.stems->integers("tree_id");
  const auto states = render::texts_or_empty(*survey.stems, "state");
  for (const auto row : render::worst_first(*survey.stems)) {
    order_.push_back(ids[row]);
    decided_.push_back(states[row] == "accepted" || states[row] == "rejected" || states[row] == "edited");
  }
}

std::size_t StemReview::open_stems() const { return static_cast<std::size_t>(std::ranges::count(decided_, false)); }

void StemReview::step(int direction) {
  const auto n = static_cast<std::ptrdiff_t>(order_.size());
  if (n == 0) return;
  const auto tree = bench_.selection().tree();
  // Forward from where the review stands. From a tree that was selected otherwise it begins with the worst one.
  const bool on_the_way = tree && (direction < 0 || tree == last_);
  const auto here = on_the_way ? std::ranges::find(order_, *tree) : order_.end();
  auto at = here != order_.end() ? here - order_.begin() : direction > 0 ? -1 : n;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    at = (at + direction + n) % n;
    const auto i = static_cast<std::size_t>(at);
    if (!decided_[i]) return show(order_[i]);
  }
  bench_.say(tr("Every stem is accepted, rejected or edited."));
}

void StemReview::show(std::int64_t tree) {
  const SceneView::Hold one_frame(bench_.scene());
  last_ = tree;
  bench_.scene().zoom_to_tree(tree);  // first: what the selection draws is then a frame of a moving view
  bench_.selection().select(tree);
  bench_.hint(tr("%n stem(s) not decided yet", nullptr, static_cast<int>(open_stems())));
}

void install_stem_review(Workbench& bench) { new StemReview(bench); }

}  // namespace bole::desktop
