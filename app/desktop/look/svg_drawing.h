// The icons of resources/icons/actions: line drawings in one colour, kept as SVG. Qt's own SVG module would be one more
// package; of the format no more is understood than that style needs.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QPainterPath>
#include <vector>

class QPainter;

namespace bole::desktop {

class SvgDrawing {
 public:
  // Throws std::invalid_argument that names what is not understood.
  static SvgDrawing parse(const QByteArray& svg);

  void paint(QPainter& painter, const QRectF& where, const QColor& color) const;
  bool empty() const { return shapes_.empty(); }

 private:
  struct Shape {
    QPainterPath path;
    bool filled = false;
  };
  std::vector<Shape> shapes_;
  QSizeF size_{24, 24};
  double line_ = 1.8;
};

}  // namespace bole::desktop
