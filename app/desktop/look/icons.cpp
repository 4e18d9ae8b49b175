#include "look/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <memory>

#include "look/resources.h"
#include "look/svg_drawing.h"
#include "look/theme.h"

namespace bole::desktop {
namespace {

// Blue marks what is switched on.
QColor icon_color(QIcon::Mode mode, QIcon::State state) {
  const QPalette palette = QGuiApplication::palette();
  if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
  if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
  if (state == QIcon::On) return is_dark(palette) ? QColor(0x5a, 0xaa, 0xfa) : QColor(0x00, 0x5f, 0xc4);
  return palette.color(QPalette::ButtonText);
}

class DrawingEngine : public QIconEngine {
 public:
  explicit DrawingEngine(std::shared_ptr<const SvgDrawing> drawing) : drawing_(std::move(drawing)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    drawing_->paint(*painter, rect, icon_color(mode, state));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, pixmap.rect(), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new DrawingEngine(drawing_); }

 private:
  std::shared_ptr<const SvgDrawing> drawing_;
};

}  // namespace

QIcon icon_named(const QString& name) {
  take_in_resources();
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new DrawingEngine(std::make_shared<const SvgDrawing>(SvgDrawing::parse(file.readAll()))));
}

}  // namespace bole::desktop
