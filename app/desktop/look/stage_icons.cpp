#include "look/stage_icons.h"

#include <QPainter>
#include <QPainterPath>

namespace bole::desktop {
namespace {

constexpr int size = 64;  // drawn large: scaled down it is sharp on any screen

template <class Draw>
QIcon drawn(const QPalette& palette, Draw draw) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  draw(painter);
  painter.end();
  QIcon icon(pixmap);
  painter.begin(&pixmap);  // in the colour of the text on the row that is chosen, where green is not seen
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(pixmap.rect(), palette.color(QPalette::HighlightedText));
  painter.end();
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

void draw_line(QPainter& painter, const QColor& color, const QVector<QPointF>& points) {
  painter.setPen(QPen(color, 9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF(points));
}

void draw_state(QPainter& painter, StageMark state, const QPalette& palette) {
  const QColor quiet = palette.color(QPalette::Disabled, QPalette::Text);
  switch (state) {
    case StageMark::idle:
      painter.setPen(QPen(quiet, 6));
      painter.drawEllipse(QRectF(18, 18, 28, 28));
      break;
    case StageMark::running:
      painter.setPen(QPen(palette.color(QPalette::Highlight), 9, Qt::SolidLine, Qt::RoundCap));
      painter.drawArc(QRectF(13, 13, 38, 38), 90 * 16, -270 * 16);
      break;
    case StageMark::done:
      draw_line(painter, QColor(0x2e, 0x9e, 0x4f), {{14, 34}, {27, 47}, {50, 18}});
      break;
    case StageMark::warning:
      draw_line(painter, QColor(0xe0, 0x8a, 0x00), {{32, 12}, {32, 38}});
      draw_line(painter, QColor(0xe0, 0x8a, 0x00), {{32, 52}, {32.1, 52}});
      break;
    case StageMark::failed:
      draw_line(painter, QColor(0xd0, 0x34, 0x2c), {{17, 17}, {47, 47}});
      draw_line(painter, QColor(0xd0, 0x34, 0x2c), {{47, 17}, {17, 47}});
      break;
    case StageMark::outdated:  // an hourglass
      painter.setPen(QPen(quiet, 6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPolygon(QPolygonF(QVector<QPointF>{{17, 12}, {47, 12}, {17, 52}, {47, 52}}));
      break;
  }
}

}  // namespace

QIcon state_icon(StageMark state, const QPalette& palette) {
  return drawn(palette, [&](QPainter& painter) { draw_state(painter, state, palette); });
}

void paint_state(QPainter& painter, const QRectF& where, StageMark state, const QPalette& palette) {
  painter.save();
  painter.translate(where.topLeft());
  painter.scale(where.width() / size, where.height() / size);
  painter.setBrush(Qt::NoBrush);
  draw_state(painter, state, palette);
  painter.restore();
}

QIcon eye_icon(bool open, const QPalette& palette) {
  const QColor color = open ? palette.color(QPalette::Text) : palette.color(QPalette::Disabled, QPalette::Text);
  return drawn(palette, [&](QPainter& painter) {
    painter.setPen(QPen(color, 5, Qt::SolidLine, Qt::RoundCap));
    QPainterPath lid(QPointF(6, 32));
    lid.quadTo(QPointF(32, open ? 4 : 56), QPointF(58, 32));
    if (open) lid.quadTo(QPointF(32, 60), QPointF(6, 32));
    painter.drawPath(lid);
    if (!open) return;
    painter.setBrush(color);
    painter.drawEllipse(QPointF(32, 32), 7, 7);
  });
}

}  // namespace bole::desktop
