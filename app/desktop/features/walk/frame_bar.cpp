#include "features/walk/frame_bar.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "look/elided_label.h"

namespace bole::desktop {

FrameBar::FrameBar(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      label_(new ElidedLabel(this)),
      play_(new QToolButton(this)),
      clock_(new QTimer(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  const auto button = [&, this](QStyle::StandardPixmap icon, const QString& tip, int by) {
    auto* b = new QToolButton(this);
    b->setAutoRaise(true);
    b->setIcon(style()->standardIcon(icon));
    b->setToolTip(tip);
    connect(b, &QToolButton::clicked, this, [this, by] { step(by); });
    layout->addWidget(b);
  };
  button(QStyle::SP_MediaSeekBackward, tr("One frame back (,)"), -1);
  play_->setAutoRaise(true);
  play_->setCheckable(true);
  play_->setIcon(style()->standardIcon(QStyle::SP_MediaPlay));
  play_->setToolTip(tr("Play"));
  connect(play_, &QToolButton::toggled, this, &FrameBar::play);
  layout->addWidget(play_);
  button(QStyle::SP_MediaSeekForward, tr("One frame on (.)"), 1);
  slider_->setObjectName("frame_slider");
  layout->addWidget(slider_, 1);
  layout->addWidget(label_, 1);
  clock_->setInterval(100);  // about the pace of a spinning sensor
  connect(clock_, &QTimer::timeout, this, [this] {
    if (frame() + 1 >= frames()) return play(false);
    step(1);
  });
  connect(slider_, &QSlider::valueChanged, this, &FrameBar::frame_asked);
  set_frames({});
}

void FrameBar::set_frames(std::vector<double> times_s) {
  const QSignalBlocker quiet(slider_);
  times_s_ = std::move(times_s);
  keyframes_.clear();
  slider_->setRange(0, std::max(0, frames() - 1));
  slider_->setPageStep(std::max(1, frames() / 20));
  slider_->setValue(0);
  setEnabled(frames() > 0);
  play(false);
  label_->set_line({});
}

void FrameBar::set_keyframes(const std::vector<double>& times_s) {
  keyframes_.clear();
  for (const double t : times_s) {
    const auto after = std::ranges::upper_bound(times_s_, t);
    if (after != times_s_.begin()) keyframes_.push_back(static_cast<int>(after - times_s_.begin()) - 1);
  }
}

void FrameBar::set_text(const QString& text) { label_->set_line(text); }

QString FrameBar::text() const { return label_->text(); }

int FrameBar::frame() const { return slider_->value(); }

void FrameBar::set_frame(int index) { slider_->setValue(index); }

void FrameBar::follow(int index) {
  const QSignalBlocker quiet(slider_);
  slider_->setValue(index);
}

void FrameBar::step_keyframe(int by) {
  if (keyframes_.empty()) return step(10 * by);
  if (by > 0) {
    const auto next = std::ranges::upper_bound(keyframes_, frame());
    if (next != keyframes_.end()) set_frame(*next);
  } else {
    const auto here = std::ranges::lower_bound(keyframes_, frame());
    if (here != keyframes_.begin()) set_frame(*(here - 1));
  }
}

void FrameBar::play(bool on) {
  if (on && frames() > 0)
    clock_->start();
  else
    clock_->stop();
  play_->setChecked(on && frames() > 0);
}

}  // namespace bole::desktop
