// Reads single frames of a scan in a thread of its own: the last one asked for wins.
#pragma once

#include <QObject>
#include <memory>

#include "cloud/scan_frame.h"
#include "cloud/trajectory.h"
#include "pipeline/document.h"
#include "running/last_wish.h"

namespace bole::desktop {

// A frame brought into the axes of a path.
struct PlacedFrame {
  std::size_t index = 0;
  double time_s = 0;                        // of its first firing
  bool placed = false;                      // false: the path does not reach it; sensor axes
  Pose T_target_sensor = Pose::Identity();  // at its end
  std::vector<Eigen::Vector3d> positions;
};

// De-skewed with the path, when it covers the frame (may be null).
PlacedFrame placed_frame(const ScanFrame& frame, std::size_t index, const Trajectory* path);

class FrameReader : public QObject {
  Q_OBJECT

 public:
  explicit FrameReader(QObject* parent);

  // The stage that opens the scan; nullptr: no scan. Answers with opened() or failed().
  void open(const pipeline::StageNode* node);
  void ask(std::size_t index, std::shared_ptr<const Trajectory> path);

 Q_SIGNALS:
  void opened(const std::vector<double>& times_s);  // start of each frame
  void failed(const QString& text);
  void frame_read(const bole::desktop::PlacedFrame& frame);

 private:
  struct Wish {
    std::size_t index = 0;
    std::shared_ptr<const Trajectory> path;
  };
  using Answer = LastWish<Wish>::Answer;
  void work(const std::stop_token& stop, const pipeline::StageNode& node, const Answer& answer);

  LastWish<Wish> wishes_;
};

}  // namespace bole::desktop
