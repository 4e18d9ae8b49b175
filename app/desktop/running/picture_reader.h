// Reads single views of a camera in a thread of its own, with what they see of the cloud: the last one asked for wins.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "cloud/core/view_source.h"
#include "pipeline/document.h"
#include "render/scene/seen_points.h"
#include "running/last_wish.h"

namespace bole::desktop {

struct Picture {
  std::size_t index = 0;
  View view;
  RgbdCamera camera;
  ColorImage other;  // of the view that was asked for beside it; may be empty

  // Of the cloud; empty where there is none, or the view has no pose.
  bool placed = false;
  render::SeenCloud in_color;
  std::vector<render::SeenPoint> in_depth;  // where the depth camera is another than the colour camera
  DepthImage residual;                      // measured minus the cloud's depth; empty where one is missing
};

struct PictureWish {
  std::size_t index = 0;
  std::optional<std::size_t> other;
  std::optional<Pose> T_world_camera;
  std::shared_ptr<const PointCloud> cloud;  // may be null
};

// Reads a view and looks at the cloud from it. `spacing_m` as see_cloud(). Throws Error{bad_input}, Error{cancelled}.
Picture read_picture(const ViewSource& views, const PictureWish& wish, double spacing_m, const Run& run);

class PictureReader : public QObject {
  Q_OBJECT

 public:
  explicit PictureReader(QObject* parent);

  // The stage that opens the views; nullptr: no views. Answers with opened() or failed().
  void open(const pipeline::StageNode* node);
  void ask(PictureWish wish);

 Q_SIGNALS:
  void opened(const std::shared_ptr<const bole::ViewSource>& views);
  void failed(const QString& text);
  void picture_read(const std::shared_ptr<const bole::desktop::Picture>& picture);

 private:
  using Answer = LastWish<PictureWish>::Answer;
  void work(const std::stop_token& stop, const pipeline::StageNode& node, const Answer& answer);

  LastWish<PictureWish> wishes_;
};

}  // namespace bole::desktop
