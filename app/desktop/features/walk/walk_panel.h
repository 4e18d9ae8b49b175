// The walk of the scan: its map as SLAM makes it, and the frames in time. Listens to the runs of the window by itself.
#pragma once

#include <QWidget>
#include <deque>

#include "running/frame_reader.h"
#include "running/live_map.h"
#include "running/runner.h"
#include "views/walk_view.h"

namespace bole::desktop {

class FrameBar;

class WalkPanel : public QWidget {
  Q_OBJECT

 public:
  WalkPanel(Session& session, Runner& runs, QWidget* parent);

  FrameBar& bar() { return *bar_; }
  WalkView& view() { return *view_; }
  const LiveMap& live() const { return live_; }
  double frames_per_s() const;  // of the run under way; 0 when not known

 Q_SIGNALS:
  void live_began();  // the first snapshot of a run
  void live_ended();
  void failed(const QString& text);

 private:
  void open_scan();
  void take(const QString& stage, const DataSet& part);
  void show_result(const Results& results);
  void ask(int frame);
  void show_frame(const PlacedFrame& frame);
  bool live_stage_goes_on() const;
  QString live_text() const;
  std::shared_ptr<const Trajectory> path() const;

  Session& session_;
  Runner& runs_;
  WalkView* view_;
  FrameBar* bar_;
  FrameReader* reader_;
  QString document_;  // path of the one whose walk is shown
  std::string scan_;  // what the reader has open
  LiveMap live_;
  QString live_stage_;  // that makes it
  bool is_live_ = false, following_ = true;  // following: the frame in work is shown, until somebody moves the slider
  std::shared_ptr<const Trajectory> walk_;   // of the last result
  double first_s_ = 0;                       // time of the first frame
  std::deque<std::pair<Job::Clock::time_point, std::int64_t>> pace_;  // of the last seconds
};

}  // namespace bole::desktop
