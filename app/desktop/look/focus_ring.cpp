#include "look/focus_ring.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

namespace bole::desktop {
namespace {

constexpr int margin_px = 3, line_px = 2, corner_px = 4;

bool moves_focus(const QEvent* event) {
  const int key = static_cast<const QKeyEvent*>(event)->key();
  return key == Qt::Key_Tab || key == Qt::Key_Backtab;
}

}  // namespace

FocusRing::FocusRing(QWidget& window) : QWidget(&window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

void FocusRing::follow(QWidget* target) {
  target_ = by_key_ && target != nullptr && parentWidget()->isAncestorOf(target) && target->window() == window()
                ? target
                : nullptr;
  place();
}

void FocusRing::place() {
  if (!target_ || !target_->isVisible()) return hide();
  const QRect about(target_->mapTo(parentWidget(), QPoint()), target_->size());
  setGeometry(about.adjusted(-margin_px, -margin_px, margin_px, margin_px).intersected(parentWidget()->rect()));
  show();
  raise();
  update();
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
      by_key_ = by_key_ || moves_focus(event);
      break;
    case QEvent::MouseButtonPress:
      if (std::exchange(by_key_, false)) follow(nullptr);
      break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Hide:
      if (target_ && watched == target_)
        QMetaObject::invokeMethod(
            this, [this] { place(); }, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return false;
}

void FocusRing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), line_px));
  const double inset = line_px / 2.0;
  painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), corner_px, corner_px);
}

}  // namespace bole::desktop
