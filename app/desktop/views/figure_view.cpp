#include "views/figure_view.h"

#include <QPainter>
#include <algorithm>

#include "base/error.h"
#include "look/pixels.h"
#include "views/figure_picture.h"

namespace bole::desktop {

FigureView::FigureView(const QString& empty_text, QWidget* parent) : QWidget(parent), empty_text_(empty_text) {
  setMinimumHeight(90);
}

void FigureView::show_figure(std::function<render::Figure(double)> make) {
  make_ = std::move(make);
  update();
}

void FigureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  QString instead = empty_text_;
  if (make_ && width() > 20) {
    try {
      // A figure has the height it needs at its width: the widest one that fits.
      double width_mm = width() * mm_per_px;
      render::Figure figure = make_(width_mm);
      const double height_mm = height() * mm_per_px;
      const double scale = std::min(1.0, height_mm / figure.height_mm);
      painter.drawImage(QPointF((width() - width() * scale) / 2, 0),
                        figure_picture(figure, palette(), 96 * scale, devicePixelRatioF()));
      return;
    } catch (const Error& e) {
      instead = QString::fromUtf8(e.what());
    }
  }
  painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
  painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap, instead);
}

}  // namespace bole::desktop
