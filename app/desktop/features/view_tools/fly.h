// View > Fly through the plot: W A S D or the arrow keys move the eye, the mouse turns it, the wheel sets the speed,
// Escape or a click ends.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QSet>
#include <QTimer>
#include <optional>

class QKeyEvent;
class QMouseEvent;

namespace bole::desktop {

class Workbench;

class Fly : public QObject {
  Q_OBJECT

 public:
  explicit Fly(Workbench& bench);

  bool on() const { return on_; }
  void turn(bool on);
  double speed_m_s() const { return speed_m_s_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void begin();
  void end();
  void press(QKeyEvent* event, bool down);
  void look(const QPoint& at);
  void change_speed(double notches);
  void step();
  void say_keys() const;

  Workbench& bench_;
  bool on_ = false;
  double speed_m_s_;
  QSet<int> pressed_;
  QTimer frame_;
  QElapsedTimer clock_;  // since the last step
  std::optional<QPoint> looked_at_;
};

}  // namespace bole::desktop
