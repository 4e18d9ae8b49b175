// What the view of a walk is made of: the growing map in blocks of key frames, the path, revisits, and one frame.
#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "document/survey.h"
#include "render/draw/screen_look.h"
#include "running/frame_reader.h"
#include "running/live_map.h"

namespace bole::desktop {

class WalkLayers {
 public:
  explicit WalkLayers(vtkRenderer* renderer) : renderer_(renderer) {}

  void set_dark(bool dark);            // the paper below
  void set_pixel_ratio(double ratio);  // pixels of the screen for one of Qt: points and lines are told in those
  void clear();
  // Only what has changed since the last call is made anew.
  void show_live(LiveMap& map, bool frame);
  // Of a run that is over. Revisits lie by from_time_s and to_time_s; may be null.
  void show_survey(const Survey& survey, const Table* loops);
  void show_frame(const PlacedFrame& frame);
  void hide_frame();

  std::size_t drawn_points() const { return drawn_; }
  std::size_t accepted_loops() const { return accepted_; }
  std::size_t refused_loops() const { return refused_; }
  // What a camera should show: the path and what stands about it, or the frame where there is no path. Lowest corner
  // above the highest: nothing. Relative to origin().
  std::pair<Eigen::Vector3d, Eigen::Vector3d> extent() const;
  bool shows_frame() const { return frame_ != nullptr; }
  const Eigen::Vector3d& origin() const { return origin_; }  // what is drawn at zero

 private:
  render::Color shown(const render::Color& color) const { return dark_ ? render::on_dark(color) : color; }
  void set(vtkSmartPointer<vtkActor>& slot, const vtkSmartPointer<vtkActor>& actor);
  void set_block(std::size_t block, const LiveMap& map);
  void set_path(const Trajectory& path);
  void set_loops(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& accepted,
                 const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& refused);
  void set_frame(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& sensor);

  vtkRenderer* renderer_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<vtkSmartPointer<vtkActor>> blocks_;
  std::vector<std::size_t> block_points_;
  vtkSmartPointer<vtkActor> path_, good_loops_, bad_loops_, frame_, sensor_;
  bool dark_ = false;
  double ratio_ = 1;
  std::size_t step_ = 1;  // of every so many points one is drawn
  std::size_t drawn_ = 0, accepted_ = 0, refused_ = 0;
};

}  // namespace bole::desktop
