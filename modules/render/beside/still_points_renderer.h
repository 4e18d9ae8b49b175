// A renderer that keeps the picture of its points and solids while nothing of it changes, and draws the rest over it.
#pragma once

#include <vtkOpenGLRenderer.h>
#include <vtkWeakPointer.h>

#include <cstddef>
#include <limits>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "render/beside/kept_picture.h"
#include "render/beside/point_parts.h"

namespace bole::render {

// Millions of points take a tenth of a second and more to draw; a stem that is selected, or a drawing that is dragged,
// changes none of them. Colours and depths of the points (PointParts) alone are kept beside the picture, so that what
// is drawn later lies before and behind them as ever: frames are the same to the pixel with and without. Points that
// come into a view that is still are drawn over those that are kept, some in each frame, so that no frame takes long.
// Once all points are there, a second picture has the opaque actors too; while one of them changes, that of the points
// is taken.
class StillPointsRenderer : public vtkOpenGLRenderer {
 public:
  static StillPointsRenderer* New();
  vtkTypeMacro(StillPointsRenderer, vtkOpenGLRenderer)

  // Whether a frame is worth keeping: not while the camera moves. What was kept before is forgotten by false.
  void keep(bool on) { keeps_ = on; }
  // In a frame that is kept, besides those that are there; each cloud has its share. What is more than a part is drawn
  // in parts of the cloud, at least one in each frame.
  void draw_at_most(std::size_t points) { most_ = points; }
  // What changes more often than the rest, such as what is selected, is in no picture that is kept.
  void draw_afresh(vtkProp* prop);
  bool whole() const { return whole_; }  // the last frame had all of them

  std::size_t frames_drawn() const { return drawn_; }                   // in which points were drawn
  std::size_t frames_from_kept() const { return reused_; }              // in which their picture was taken as it was
  std::size_t solids_from_kept() const { return reused_with_solids_; }  // of these, in which solids were in it

  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  StillPointsRenderer() = default;
  ~StillPointsRenderer() override = default;

 private:
  struct Kept {
    vtkMTimeType time = 0;  // of the cloud as it was drawn
    std::unordered_set<const vtkActor*> parts;
  };
  using Solids = std::map<const vtkProp*, vtkMTimeType>;  // as they were drawn
  struct Shown {
    std::vector<PointParts*> clouds;
    std::vector<vtkProp*> solids, others;
  };
  Shown shown();
  std::vector<double> eye();
  bool can_keep();
  vtkOpenGLRenderWindow& window();
  bool still_holds(const std::vector<PointParts*>& clouds, const std::vector<double>& eye) const;
  bool any_missing(const std::vector<PointParts*>& clouds) const;
  bool add_missing(const std::vector<PointParts*>& clouds);
  void draw_points(const std::vector<PointParts*>& clouds, bool holds, std::vector<double> eye);
  void draw_solids(const std::vector<vtkProp*>& solids);
  bool solids_hold(const std::vector<vtkProp*>& solids) const;
  void forget();

  bool keeps_ = false, whole_ = true;
  bool refused_ = false;  // by the driver: every frame is drawn whole
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::vector<double> eye_;  // of the picture: all that places and colours pixels but the points; empty: none is kept
  std::map<const PointParts*, Kept> kept_;
  Solids kept_solids_;  // over these points; empty: none
  std::vector<vtkWeakPointer<vtkProp>> afresh_;
  KeptPicture points_, with_solids_;
  std::size_t drawn_ = 0, reused_ = 0, reused_with_solids_ = 0;
};

}  // namespace bole::render
