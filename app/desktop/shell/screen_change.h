// The window on two screens of different scale.
#pragma once

#include <QObject>

namespace bole::desktop {

class MainWindow;

// The window has the same size to the eye on a screen of another scale, as far as that screen has room. Bars and panels
// are windows of the system within it: for Qt they do not change, and so they would keep place and size in pixels.
class ScreenChange : public QObject {
 public:
  explicit ScreenChange(MainWindow& window);
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();

  MainWindow& window_;
  double pixels_ = 0;  // of the screen for one of Qt
};

}  // namespace bole::desktop
