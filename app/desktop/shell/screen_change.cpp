#include "shell/screen_change.h"

#include <QEvent>
#include <QScreen>
#include <QTimer>
#include <QWindow>
#include <utility>

#include "shell/main_window.h"

namespace bole::desktop {

ScreenChange::ScreenChange(MainWindow& window) : QObject(&window), window_(window) { window.installEventFilter(this); }

bool ScreenChange::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Show && pixels_ == 0) {
    pixels_ = window_.devicePixelRatioF();
    // The window knows its new scale a little later.
    connect(window_.windowHandle(), &QWindow::screenChanged, this,
            [this] { QTimer::singleShot(0, this, &ScreenChange::follow); });
  }
  return false;
}

void ScreenChange::follow() {
  const double before = std::exchange(pixels_, window_.devicePixelRatioF());
  if (pixels_ == before) return;
  if (!window_.isMaximized() && !window_.isFullScreen())  // so far it has the same pixels
    window_.resize((window_.size() * (pixels_ / before)).boundedTo(window_.screen()->availableSize()));
  for (auto* part : window_.findChildren<QWidget*>()) {
    auto* handle = part->internalWinId() != 0 ? part->windowHandle() : nullptr;
    if (handle == nullptr || part->isWindow()) continue;
    const QRect place = handle->geometry();
    handle->setGeometry(place.adjusted(0, 0, 1, 1));  // a place that is no other is not handed on
    handle->setGeometry(place);
  }
}

}  // namespace bole::desktop
