// The clouds beside the survey in the 3-D view: a layer of points each.
#pragma once

#include <vtkRenderer.h>

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "render/draw/cloud_key.h"
#include "render/scene/point_layer.h"
#include "views/clouds/scene_cloud.h"

namespace bole::desktop {

class CloudLayers : public QObject {
  Q_OBJECT

 public:
  explicit CloudLayers(vtkRenderer* renderer) : renderer_(renderer) {}
  ~CloudLayers() override;

  void set(std::vector<SceneCloud> clouds);  // those to draw; what stays keeps its prepared points
  const std::vector<SceneCloud>& clouds() const { return clouds_; }
  void draw_about(const std::optional<Eigen::Vector3d>& origin);  // of the scene; none: nothing is drawn

  // What the settings of the view make of them.
  void dress(const render::PointFilter& filter, const std::optional<render::ClipBox>& clip,
             const render::PointPaint& of_survey);
  void set_clip(const std::optional<render::ClipBox>& box);
  void set_point_size(double px, double scale);  // px: of those that have no size of their own; scale: of all

  bool update(std::size_t budget, std::size_t fresh);  // of each; see PointLayer
  std::size_t drawn_clouds() const { return origin_ ? layers_.size() : 0; }
  std::size_t drawn() const;
  std::size_t drawn(int id) const;  // points of one of them
  std::size_t fresh() const;
  std::size_t awaited() const;
  // Adds what is seen of them and may lie within `reach_px` of a pixel, and whose it is.
  void add_drawn(const render::PickView& view, const Eigen::Vector2d& at_px, double reach_px,
                 std::vector<render::PointSet>& drawn, std::vector<const SceneCloud*>& owners) const;
  std::vector<render::CloudKey> keys() const;
  // Of the first of them whose numbers have colours of their own.
  std::optional<render::PointPaint> legend(const render::PointPaint& of_survey) const;

 Q_SIGNALS:
  void arrived();      // points from the disk
  void index_built();  // of a cloud that was shown thinned

 private:
  struct Layer {
    render::PointLayer points;
    QMetaObject::Connection arrivals, built;
    std::string paint;  // what it is painted by now
    double height_lo = -1e9, height_hi = 1e9;
    const void* ground = nullptr;
  };
  void show(std::size_t which);
  void forget(Layer& layer);

  vtkRenderer* renderer_;
  std::optional<Eigen::Vector3d> origin_;
  std::vector<SceneCloud> clouds_;
  std::vector<std::unique_ptr<Layer>> layers_;  // of clouds_
};

}  // namespace bole::desktop
