// A slider with two handles; what lies between them is the range. A drag of the middle moves both.
#pragma once

#include <QWidget>

#include "render/draw/axes.h"

namespace bole::desktop {

class RangeSlider : public QWidget {
  Q_OBJECT

 public:
  explicit RangeSlider(QWidget* parent = nullptr);

  void set_limits(const render::Interval& limits);
  void set_range(const render::Interval& range);  // without a signal
  const render::Interval& range() const { return range_; }
  int place_of(double value) const;  // pixels from the left

  QSize sizeHint() const override;

 Q_SIGNALS:
  void dragged(const bole::render::Interval& range);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Part { low, high, both };
  double value_at(int x) const;
  void move_to(render::Interval range);

  render::Interval limits_{0, 1}, range_{0, 1}, pressed_range_{0, 1};
  Part part_ = Part::both;
  double pressed_at_ = 0;
};

}  // namespace bole::desktop
