#include "features/view_tools/range_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace bole::desktop {
namespace {

constexpr int handle_px = 7;  // half the width of a handle
constexpr double key_share = 0.01;

}  // namespace

RangeSlider::RangeSlider(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
}

QSize RangeSlider::sizeHint() const { return {120, 2 * handle_px + 8}; }

void RangeSlider::set_limits(const render::Interval& limits) {
  limits_ = limits;
  update();
}

void RangeSlider::set_range(const render::Interval& range) {
  range_ = {std::clamp(range.lo, limits_.lo, limits_.hi), std::clamp(range.hi, limits_.lo, limits_.hi)};
  update();
}

int RangeSlider::place_of(double value) const {
  return handle_px + static_cast<int>(std::lround((value - limits_.lo) / limits_.length() * (width() - 2 * handle_px)));
}

double RangeSlider::value_at(int x) const {
  return limits_.lo + limits_.length() * (x - handle_px) / std::max(width() - 2 * handle_px, 1);
}

void RangeSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int middle = height() / 2, lo = place_of(range_.lo), hi = place_of(range_.hi);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().mid());
  painter.drawRoundedRect(QRect(handle_px, middle - 2, width() - 2 * handle_px, 4), 2, 2);
  painter.setBrush(palette().highlight());
  painter.drawRect(QRect(lo, middle - 2, hi - lo, 4));
  painter.setPen(hasFocus() ? palette().highlight().color() : palette().dark().color());
  painter.setBrush(palette().button());
  for (const int x : {lo, hi}) painter.drawEllipse(QPoint(x, middle), handle_px - 1, handle_px - 1);
}

void RangeSlider::mousePressEvent(QMouseEvent* event) {
  const int lo = place_of(range_.lo), hi = place_of(range_.hi), x = event->pos().x();
  const int to_lo = std::abs(x - lo), to_hi = std::abs(x - hi);
  if (std::min(to_lo, to_hi) > handle_px && x > lo && x < hi)
    part_ = Part::both;
  else
    part_ = to_lo < to_hi || (to_lo == to_hi && x < lo) ? Part::low : Part::high;
  pressed_range_ = range_;
  pressed_at_ = value_at(x);
}

void RangeSlider::mouseMoveEvent(QMouseEvent* event) {
  const double by = value_at(event->pos().x()) - pressed_at_;
  auto range = pressed_range_;
  switch (part_) {
    case Part::low:
      range.lo = std::clamp(range.lo + by, limits_.lo, range.hi);
      break;
    case Part::high:
      range.hi = std::clamp(range.hi + by, range.lo, limits_.hi);
      break;
    case Part::both: {
      const double shift = std::clamp(by, limits_.lo - range.lo, limits_.hi - range.hi);
      range.lo += shift;
      range.hi += shift;
    }
  }
  move_to(range);
}

// Arrows move the upper handle, with Shift the lower one.
void RangeSlider::keyPressEvent(QKeyEvent* event) {
  const int direction = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (direction == 0) return QWidget::keyPressEvent(event);
  const double by = direction * key_share * limits_.length();
  if (event->modifiers().testFlag(Qt::ShiftModifier))
    move_to({std::clamp(range_.lo + by, limits_.lo, range_.hi), range_.hi});
  else
    move_to({range_.lo, std::clamp(range_.hi + by, range_.lo, limits_.hi)});
}

void RangeSlider::move_to(render::Interval range) {
  if (range.lo == range_.lo && range.hi == range_.hi) return;
  range_ = range;
  update();
  Q_EMIT dragged(range_);
}

}  // namespace bole::desktop
