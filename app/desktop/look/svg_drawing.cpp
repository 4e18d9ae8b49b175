#include "look/svg_drawing.h"

#include <QPainter>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <stdexcept>

namespace bole::desktop {
namespace {

[[noreturn]] void refuse_svg(const QString& what) {
  throw std::invalid_argument("the icon has " + what.toStdString() +
                              "; needed: path with M L H V C Q Z, rect, circle; fill none or currentColor");
}

double number_in(const QXmlStreamAttributes& attributes, const char* name, double otherwise = 0) {
  if (!attributes.hasAttribute(name)) return otherwise;
  bool good = false;
  const double value = attributes.value(name).toString().toDouble(&good);
  if (!good) refuse_svg(QString("%1 = %2").arg(name, attributes.value(name).toString()));
  return value;
}

// The numbers behind each letter.
class PathReader {
 public:
  explicit PathReader(const QString& text) {
    static const QRegularExpression token("[A-Za-z]|-?[0-9]*\\.?[0-9]+");
    for (auto it = token.globalMatch(text); it.hasNext();) tokens_ << it.next().captured();
  }

  QPainterPath read() {
    QPainterPath path;
    QString command;
    while (at_ < tokens_.size()) {
      if (tokens_[at_].at(0).isLetter()) command = tokens_[at_++];
      step(path, command);
    }
    return path;
  }

 private:
  double number() {
    if (at_ >= tokens_.size() || tokens_[at_].at(0).isLetter()) refuse_svg("a path that ends early");
    return tokens_[at_++].toDouble();
  }
  QPointF point() {
    const double x = number();
    return {x, number()};
  }
  void step(QPainterPath& path, const QString& command) {
    const QPointF here = path.currentPosition();
    if (command == "M") {
      path.moveTo(point());
    } else if (command == "L") {
      path.lineTo(point());
    } else if (command == "H") {
      path.lineTo(number(), here.y());
    } else if (command == "V") {
      path.lineTo(here.x(), number());
    } else if (command == "C") {
      const QPointF a = point(), b = point();
      path.cubicTo(a, b, point());
    } else if (command == "Q") {
      const QPointF a = point();
      path.quadTo(a, point());
    } else if (command == "Z") {
      path.closeSubpath();
    } else {
      refuse_svg("the path command '" + command + "'");
    }
  }

  QStringList tokens_;
  int at_ = 0;
};

QPainterPath outline_of_element(const QString& element, const QXmlStreamAttributes& a) {
  if (element == "path") return PathReader(a.value("d").toString()).read();
  QPainterPath path;
  if (element == "circle") {
    path.addEllipse(QPointF(number_in(a, "cx"), number_in(a, "cy")), number_in(a, "r"), number_in(a, "r"));
  } else if (element == "rect") {
    const double round = number_in(a, "rx");
    path.addRoundedRect(QRectF(number_in(a, "x"), number_in(a, "y"), number_in(a, "width"), number_in(a, "height")),
                        round, round);
  } else {
    refuse_svg("the element <" + element + ">");
  }
  return path;
}

}  // namespace

SvgDrawing SvgDrawing::parse(const QByteArray& svg) {
  SvgDrawing drawing;
  QXmlStreamReader in(svg);
  while (!in.atEnd()) {
    if (in.readNext() != QXmlStreamReader::StartElement) continue;
    const auto attributes = in.attributes();
    if (in.name() == QLatin1String("svg")) {
      const auto box = attributes.value("viewBox").toString().split(' ');
      if (box.size() == 4) drawing.size_ = {box[2].toDouble(), box[3].toDouble()};
      drawing.line_ = number_in(attributes, "stroke-width", drawing.line_);
      continue;
    }
    const auto fill = attributes.value("fill").toString();
    if (!fill.isEmpty() && fill != "none" && fill != "currentColor") refuse_svg("the fill " + fill);
    drawing.shapes_.push_back({outline_of_element(in.name().toString(), attributes), fill == "currentColor"});
  }
  if (in.hasError()) refuse_svg("broken XML: " + in.errorString());
  return drawing;
}

void SvgDrawing::paint(QPainter& painter, const QRectF& where, const QColor& color) const {
  const double scale = std::min(where.width() / size_.width(), where.height() / size_.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(where.center());
  painter.scale(scale, scale);
  painter.translate(-size_.width() / 2, -size_.height() / 2);
  painter.setPen(QPen(color, line_, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const auto& shape : shapes_) {
    painter.setBrush(shape.filled ? QBrush(color) : QBrush(Qt::NoBrush));
    painter.drawPath(shape.path);
  }
  painter.restore();
}

}  // namespace bole::desktop
