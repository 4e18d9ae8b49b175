// Steps through the frames of a scan in time: a slider, keys, and what is shown.
#pragma once

#include <QWidget>
#include <vector>

class QSlider;
class QTimer;
class QToolButton;

namespace bole::desktop {

class ElidedLabel;

class FrameBar : public QWidget {
  Q_OBJECT

 public:
  explicit FrameBar(QWidget* parent);

  void set_frames(std::vector<double> times_s);            // start of each; none: the bar is empty
  void set_keyframes(const std::vector<double>& times_s);  // where step_keyframe() stops
  void set_text(const QString& text);
  QString text() const;

  int frame() const;
  int frames() const { return static_cast<int>(times_s_.size()); }
  void set_frame(int index);
  void follow(int index);  // the slider without the frame: where a run is
  void step(int by) { set_frame(frame() + by); }
  void step_keyframe(int by);
  void play(bool on);

 Q_SIGNALS:
  void frame_asked(int index);

 private:
  std::vector<double> times_s_;
  std::vector<int> keyframes_;  // frames
  QSlider* slider_;
  ElidedLabel* label_;
  QToolButton* play_;
  QTimer* clock_;
};

}  // namespace bole::desktop
