// A frame about the widget that has the focus, while a person works by keyboard: styles hardly show it.
#pragma once

#include <QPointer>
#include <QWidget>

namespace bole::desktop {

class FocusRing : public QWidget {
  Q_OBJECT

 public:
  explicit FocusRing(QWidget& window);  // for widgets of this window

  QWidget* around() const { return target_; }  // null: not shown

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow(QWidget* target);
  void place();

  QPointer<QWidget> target_;
  bool by_key_ = false;  // the last press was one of Tab or its kind
};

}  // namespace bole::desktop
