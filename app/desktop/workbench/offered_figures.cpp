#include "workbench/offered_figures.h"

namespace bole::desktop {

OfferedFigures& OfferedFigures::of(QObject& bench) {
  auto* found = bench.findChild<OfferedFigures*>(QString(), Qt::FindDirectChildrenOnly);
  return found != nullptr ? *found : *new OfferedFigures(&bench);
}

void OfferedFigures::offer(std::function<std::vector<OfferedFigure>()> source) {
  sources_.push_back(std::move(source));
}

std::vector<OfferedFigure> OfferedFigures::now() const {
  std::vector<OfferedFigure> all;
  for (const auto& source : sources_)
    for (auto& figure : source()) all.push_back(std::move(figure));
  return all;
}

}  // namespace bole::desktop
