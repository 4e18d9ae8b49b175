// Legend, scale bar and north arrow over the 3-D view; takes no mouse.
#pragma once

#include <QImage>
#include <QWidget>

#include "render/scene/view_furniture.h"

namespace bole::desktop {

class SceneOverlay : public QWidget {
  Q_OBJECT

 public:
  explicit SceneOverlay(QWidget* parent);
  void show_furniture(ViewFurniture furniture);  // its size is set to that of the widget
  static constexpr double mm_per_px = 25.4 / 96;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
};

}  // namespace bole::desktop
