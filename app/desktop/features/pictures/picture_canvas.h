// A picture with what lies over it; the wheel zooms at the mouse, a drag moves it, a double click shows all of it.
#pragma once

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QPointF>
#include <QWidget>
#include <optional>
#include <vector>

#include "render/draw/color.h"

namespace bole::desktop {

// Places are pixels of the picture; (0, 0) is the centre of the first pixel.
struct PictureMarks {
  QColor color;
  double size_px = 2;  // of a dot or a line on the screen
  std::vector<QPointF> dots{};
  std::vector<QLineF> lines{};
};

// The colours of a picture of numbers.
struct ColorBar {
  const render::ColorMap* map = nullptr;
  double lo = 0, hi = 1;
  QString title{};
  int decimals = 2;
};

class PictureCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit PictureCanvas(QWidget* parent);

  // Another size than before shows all of it; else the part that was seen stays.
  void show_picture(const QImage& image, const std::optional<ColorBar>& bar = {});
  void set_marks(std::vector<PictureMarks> marks);
  void set_message(const QString& text);  // in place of a picture, or over it

  const QImage& picture() const { return image_; }
  const std::vector<PictureMarks>& marks() const { return marks_; }
  std::size_t drawn_dots() const { return drawn_dots_; }  // of the last painting
  double zoom() const { return zoom_; }                   // pixels of the screen per pixel of the picture
  void zoom_at(const QPointF& at, double factor);
  void fit();
  QPointF to_picture(const QPointF& at) const;
  QPointF to_widget(const QPointF& pixel) const;

  QSize sizeHint() const override { return {560, 420}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 Q_SIGNALS:
  void hovered(const QPointF& pixel);
  void left();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void paint_marks(QPainter& painter);
  void paint_bar(QPainter& painter) const;
  double fitting_zoom() const;

  QImage image_;
  std::optional<ColorBar> bar_;
  std::vector<PictureMarks> marks_;
  QString message_;
  QPointF centre_;  // pixel of the picture in the middle of the widget
  double zoom_ = 1;
  bool fits_ = true;  // until somebody zooms or moves
  std::size_t drawn_dots_ = 0;
  QPointF dragged_from_;
};

}  // namespace bole::desktop
