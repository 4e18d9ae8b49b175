// A renderer that keeps the picture of its points while nothing of it changes, and draws the rest over it.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderer.h>

#include <cstddef>
#include <utility>
#include <vector>

class vtkProp;

namespace bole::render {

// Millions of points take a tenth of a second to draw; a stem that is selected, or a drawing that is dragged, changes
// none of them. Colours and depths of the points alone are kept beside the picture, so that what is drawn later lies
// before and behind them as ever: frames are the same to the pixel with and without.
class StillPointsRenderer : public vtkOpenGLRenderer {
 public:
  static StillPointsRenderer* New();
  vtkTypeMacro(StillPointsRenderer, vtkOpenGLRenderer)

  // That the prop is one of the points. Its MTime has to tell of every change.
  static void mark(vtkProp& prop);

  // Whether a frame is worth keeping: not while the camera moves. What was kept before is forgotten by false.
  void keep(bool on) { keeps_ = on; }

  std::size_t frames_drawn() const { return drawn_; }       // in which all points were drawn
  std::size_t frames_from_kept() const { return reused_; }  // in which their picture was taken

  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  StillPointsRenderer() = default;
  ~StillPointsRenderer() override = default;

 private:
  struct Key {
    std::vector<double> eye;  // all that places and colours pixels but the points
    std::vector<std::pair<const vtkProp*, vtkMTimeType>> points;
    bool operator==(const Key&) const = default;
  };
  Key key_of(const std::vector<vtkProp*>& points);
  bool can_keep();
  void draw(const std::vector<vtkProp*>& props);
  bool put_aside();
  void put_back();

  bool keeps_ = false;
  bool refused_ = false;  // by the driver: every frame is drawn whole
  Key kept_;
  vtkNew<vtkOpenGLFramebufferObject> picture_;
  std::size_t drawn_ = 0, reused_ = 0;
};

}  // namespace bole::render
