#include "look/elided_label.h"

#include <QPainter>

namespace bole::desktop {

void ElidedLabel::set_line(const QString& line) {
  setTextFormat(Qt::PlainText);
  setText(line);
  setToolTip(line);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {fontMetrics().horizontalAdvance(QString(8, 'n')), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  painter.drawText(contentsRect(), static_cast<int>(alignment()),
                   fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()));
}

}  // namespace bole::desktop
