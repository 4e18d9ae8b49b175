// Text that is broken between words and never cut: a layout within a scroll area may give a plain QLabel less height
// than its lines need.
#pragma once

#include <QLabel>

namespace bole::desktop {

class WrappedLabel : public QLabel {
 public:
  explicit WrappedLabel(const QString& text, QWidget* parent = nullptr) : QLabel(text, parent) {
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  void set_words(const QString& text) {
    setText(text);
    keep_height();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    keep_height();
  }

 private:
  void keep_height() { setMinimumHeight(qMax(0, heightForWidth(width()))); }
};

}  // namespace bole::desktop
