#include "features/pictures/picture_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace bole::desktop {
namespace {

constexpr double max_zoom = 40, wheel_step = 1.25;
constexpr double pixels_from_zoom = 3;  // from here on pixels are seen as such
constexpr double px_per_dot = 30;       // of the widget: denser dots would cover what lies below
constexpr int bar_width = 14, bar_margin = 10;

QColor color_of(const render::Color& c) { return QColor::fromRgbF(c.r, c.g, c.b); }

}  // namespace

PictureCanvas::PictureCanvas(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAutoFillBackground(false);
  setCursor(Qt::CrossCursor);
}

void PictureCanvas::show_picture(const QImage& image, const std::optional<ColorBar>& bar) {
  const bool other_size = image.size() != image_.size();
  image_ = image;
  bar_ = bar;
  message_.clear();
  if (other_size || fits_) fit();
  update();
}

void PictureCanvas::set_marks(std::vector<PictureMarks> marks) {
  marks_ = std::move(marks);
  update();
}

void PictureCanvas::set_message(const QString& text) {
  message_ = text;
  update();
}

double PictureCanvas::fitting_zoom() const {
  if (image_.isNull()) return 1;
  return std::min(static_cast<double>(width()) / image_.width(), static_cast<double>(height()) / image_.height());
}

void PictureCanvas::fit() {
  fits_ = true;
  zoom_ = fitting_zoom();
  centre_ = QPointF((image_.width() - 1) / 2.0, (image_.height() - 1) / 2.0);
  update();
}

void PictureCanvas::zoom_at(const QPointF& at, double factor) {
  if (image_.isNull()) return;
  const QPointF pixel = to_picture(at);
  zoom_ = std::clamp(zoom_ * factor, std::min(fitting_zoom(), max_zoom), max_zoom);
  centre_ += pixel - to_picture(at);
  fits_ = zoom_ <= fitting_zoom();
  if (fits_) fit();
  update();
}

QPointF PictureCanvas::to_picture(const QPointF& at) const {
  return centre_ + (at - QPointF(width() / 2.0, height() / 2.0)) / zoom_;
}

QPointF PictureCanvas::to_widget(const QPointF& pixel) const {
  return (pixel - centre_) * zoom_ + QPointF(width() / 2.0, height() / 2.0);
}

void PictureCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  if (!image_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < pixels_from_zoom);
    const QPointF corner = to_widget({-0.5, -0.5});
    painter.drawImage(QRectF(corner, QSizeF(image_.width() * zoom_, image_.height() * zoom_)), image_);
    paint_marks(painter);
    paint_bar(painter);
  }
  if (message_.isEmpty()) return;
  const QRect box =
      painter.boundingRect(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, message_)
          .adjusted(-8, -6, 8, 6);
  QColor paper = palette().color(QPalette::Base);
  paper.setAlpha(225);
  painter.fillRect(box, paper);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, message_);
}

void PictureCanvas::paint_marks(QPainter& painter) {
  drawn_dots_ = 0;
  const QRectF seen(to_picture({0, 0}), to_picture(QPointF(width(), height())));
  for (const auto& layer : marks_) {
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QPen(layer.color, layer.size_px));
    for (const auto& line : layer.lines) painter.drawLine(to_widget(line.p1()), to_widget(line.p2()));
    std::vector<QPointF> inside;
    for (const auto& dot : layer.dots)
      if (seen.contains(dot)) inside.push_back(dot);
    const auto step =
        static_cast<std::size_t>(static_cast<double>(inside.size()) * px_per_dot / (width() * height())) + 1;
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t i = 0; i < inside.size(); i += step) {
      const QPointF at = to_widget(inside[i]);
      painter.fillRect(QRectF(at.x() - layer.size_px / 2, at.y() - layer.size_px / 2, layer.size_px, layer.size_px),
                       layer.color);
      ++drawn_dots_;
    }
  }
}

void PictureCanvas::paint_bar(QPainter& painter) const {
  if (!bar_ || bar_->map == nullptr) return;
  const auto& metrics = fontMetrics();
  const QString hi = QString::number(bar_->hi, 'f', bar_->decimals),
                lo = QString::number(bar_->lo, 'f', bar_->decimals),
                middle = QString::number((bar_->lo + bar_->hi) / 2, 'f', bar_->decimals);
  const int text =
      std::max({metrics.horizontalAdvance(hi), metrics.horizontalAdvance(lo), metrics.horizontalAdvance(middle),
                metrics.horizontalAdvance(bar_->title) - bar_width - 4});
  const int tall = std::clamp(height() / 2, 60, 220);
  const QRect panel(width() - bar_margin - bar_width - text - 16, bar_margin, bar_width + text + 16,
                    tall + 2 * metrics.height() + 14);
  QColor paper = palette().color(QPalette::Base);
  paper.setAlpha(225);
  painter.fillRect(panel, paper);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(panel.adjusted(6, 4, -4, 0), Qt::AlignLeft | Qt::AlignTop, bar_->title);
  const QRect bar(panel.left() + 6, panel.top() + metrics.height() + metrics.height() / 2 + 6, bar_width, tall);
  for (int y = 0; y < bar.height(); ++y)
    painter.fillRect(bar.left(), bar.top() + y, bar.width(), 1,
                     color_of(bar_->map->at(1 - static_cast<double>(y) / std::max(1, bar.height() - 1))));
  const auto label = [&](const QString& words, int y) {
    painter.drawText(bar.right() + 6, y + metrics.ascent() / 2 - 1, words);
  };
  label(hi, bar.top());
  label(middle, bar.center().y());
  label(lo, bar.bottom());
}

void PictureCanvas::resizeEvent(QResizeEvent*) {
  if (fits_) fit();
}

void PictureCanvas::wheelEvent(QWheelEvent* event) {
  zoom_at(event->position(), std::pow(wheel_step, event->angleDelta().y() / 120.0));
  event->accept();
}

void PictureCanvas::mousePressEvent(QMouseEvent* event) { dragged_from_ = event->localPos(); }

void PictureCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton) && !image_.isNull()) {
    centre_ -= (event->localPos() - dragged_from_) / zoom_;
    dragged_from_ = event->localPos();
    fits_ = false;
    update();
  }
  Q_EMIT hovered(to_picture(event->localPos()));
}

void PictureCanvas::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void PictureCanvas::leaveEvent(QEvent*) { Q_EMIT left(); }

}  // namespace bole::desktop
