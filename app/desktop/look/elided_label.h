// A line of text that never makes its window wider: what has no room is cut, and stands in the tooltip.
#pragma once

#include <QLabel>

namespace bole::desktop {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;
  void set_line(const QString& text);  // plain

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace bole::desktop
