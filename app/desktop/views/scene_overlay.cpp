#include "views/scene_overlay.h"

#include <QPainter>

namespace bole::desktop {

SceneOverlay::SceneOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
}

void SceneOverlay::show_furniture(ViewFurniture furniture) {
  if (width() < 2 || height() < 2) return;
  furniture.width_mm = width() * mm_per_px, furniture.height_mm = height() * mm_per_px;
  const auto image = figure_overlay(view_furniture(furniture), 96 * devicePixelRatioF());
  image_ = QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
  image_.setDevicePixelRatio(devicePixelRatioF());
  update();
}

void SceneOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawImage(QPointF(0, 0), image_);
}

}  // namespace bole::desktop
