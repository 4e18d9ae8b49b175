#include "look/svg_paper.h"

#include <QGuiApplication>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPen>
#include <QScreen>
#include <cmath>

namespace bole::desktop {
namespace {

constexpr double mm_per_inch = 25.4;

// As everywhere in the program, or letters would be larger here than the boxes that are made for them.
int dots_per_inch() { return static_cast<int>(std::lround(QGuiApplication::primaryScreen()->logicalDotsPerInch())); }

QByteArray number(double value) {
  QByteArray text = QByteArray::number(value, 'f', 2);
  while (text.endsWith('0')) text.chop(1);
  if (text.endsWith('.')) text.chop(1);
  return text;
}

QByteArray point(const QPainterPath::Element& e) { return number(e.x) + " " + number(e.y); }

QByteArray path_data(const QPainterPath& path) {
  QByteArray data;
  for (int i = 0; i < path.elementCount(); ++i) {
    const auto e = path.elementAt(i);
    if (e.isMoveTo()) data += "M" + point(e);
    if (e.isLineTo()) data += "L" + point(e);
    if (!e.isCurveTo()) continue;
    data += "C" + point(e) + " " + point(path.elementAt(i + 1)) + " " + point(path.elementAt(i + 2));
    i += 2;
  }
  return data;
}

QByteArray paint(const char* what, const QColor& color) {
  QByteArray text = QByteArray(" ") + what + "=\"" + color.name().toLatin1() + "\"";
  if (color.alpha() < 255) text += QByteArray(" ") + what + "-opacity=\"" + number(color.alphaF()) + "\"";
  return text;
}

QByteArray stroke(const QPen& pen, double scale) {
  const double width = scale * (pen.widthF() > 0 ? pen.widthF() : 1);
  QByteArray text = paint("stroke", pen.color()) + " stroke-width=\"" + number(width) + "\"";
  if (pen.capStyle() == Qt::RoundCap) text += " stroke-linecap=\"round\"";
  if (pen.joinStyle() == Qt::RoundJoin) text += " stroke-linejoin=\"round\"";
  QByteArray dashes;
  for (const double dash : pen.dashPattern()) dashes += (dashes.isEmpty() ? "" : " ") + number(dash * width);
  if (!dashes.isEmpty()) text += " stroke-dasharray=\"" + dashes + "\"";
  return text;
}

}  // namespace

class SvgPaper::Engine : public QPaintEngine {
 public:
  Engine() : QPaintEngine(PrimitiveTransform | PainterPaths | Antialiasing | AlphaBlend | PaintOutsidePaintEvent) {}

  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  Type type() const override { return User; }
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}  // pictures are not asked for
  void updateState(const QPaintEngineState& now) override {
    if (now.state() & DirtyPen) pen_ = now.pen();
    if (now.state() & DirtyBrush) brush_ = now.brush();
    if (now.state() & DirtyTransform) transform_ = now.transform();
  }

  void drawPath(const QPainterPath& path) override {
    const bool filled = brush_.style() != Qt::NoBrush, lined = pen_.style() != Qt::NoPen;
    if (!filled && !lined) return;
    shapes += "<path d=\"" + path_data(transform_.map(path)) + "\"" +
              (filled ? paint("fill", brush_.color()) : QByteArray(" fill=\"none\""));
    if (filled && path.fillRule() == Qt::OddEvenFill) shapes += " fill-rule=\"evenodd\"";
    if (lined) shapes += stroke(pen_, std::sqrt(std::abs(transform_.determinant())));
    shapes += "/>\n";
  }

  void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
    QPainterPath path;
    path.setFillRule(mode == WindingMode ? Qt::WindingFill : Qt::OddEvenFill);
    for (int i = 0; i < count; ++i) i == 0 ? path.moveTo(points[i]) : path.lineTo(points[i]);
    const QBrush brush = brush_;
    if (mode == PolylineMode) brush_ = Qt::NoBrush;
    if (mode != PolylineMode) path.closeSubpath();
    drawPath(path);
    brush_ = brush;
  }

  QByteArray shapes;

 private:
  QPen pen_;
  QBrush brush_;
  QTransform transform_;
};

SvgPaper::SvgPaper(const QSize& size) : size_(size), engine_(std::make_unique<Engine>()) {}

SvgPaper::~SvgPaper() = default;

QPaintEngine* SvgPaper::paintEngine() const { return engine_.get(); }

QByteArray SvgPaper::svg() const {
  const QByteArray width = QByteArray::number(size_.width()), height = QByteArray::number(size_.height());
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
         "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height + "\">\n" + engine_->shapes + "</svg>\n";
}

int SvgPaper::metric(PaintDeviceMetric metric) const {
  switch (metric) {
    case PdmWidth:
      return size_.width();
    case PdmHeight:
      return size_.height();
    case PdmWidthMM:
      return static_cast<int>(size_.width() * mm_per_inch / dots_per_inch());
    case PdmHeightMM:
      return static_cast<int>(size_.height() * mm_per_inch / dots_per_inch());
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
      return dots_per_inch();
    case PdmDevicePixelRatio:
      return 1;
    case PdmDevicePixelRatioScaled:
      return static_cast<int>(devicePixelRatioFScale());
    case PdmNumColors:
    case PdmDepth:
      break;
  }
  return QPaintDevice::metric(metric);
}

}  // namespace bole::desktop
