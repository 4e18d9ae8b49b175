#include "look/scrolled_page.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

namespace bole::desktop {

void fill_with_scrolled(QWidget& panel, QWidget* page) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  scroll->setMinimumWidth(page->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  auto* layout = new QVBoxLayout(&panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
}

void scroll_to(QWidget& widget) {
  constexpr int layout_ms = 60;
  QTimer::singleShot(layout_ms, &widget, [&widget] {
    for (auto* above = widget.parentWidget(); above; above = above->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(above)) return scroll->ensureWidgetVisible(&widget, 0, 0);
  });
}

}  // namespace bole::desktop
