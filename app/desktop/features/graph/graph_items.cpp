#include "features/graph/graph_items.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPathStroker>
#include <QStyleOptionGraphicsItem>
#include <algorithm>

namespace bole::desktop {
namespace {

// Of the height of a line.
constexpr double corner = 0.35, margin = 0.4, mark_size = 1.1, thin = 0.07, thick = 0.16, ring = 0.28;
constexpr double head_length = 0.6, head_width = 0.5, reach = 0.5, socket = 0.36;
// Seen smaller than this a box shows its title alone, as large as there is room for.
constexpr double small_scale = 0.7, max_title = 1.5, min_title = 0.6, count_size = 1.3;
constexpr double unlit_share = 0.5, quiet_share = 0.72;  // of the text's colour in arrows and in states

const QColor red(0xd0, 0x34, 0x2c);

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto part = [&](int x, int y) { return static_cast<int>(x + (y - x) * share_of_b); };
  return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

// The largest letters in which the text has room, broken between words.
QFont fitting_font(QFont font, const QString& text, const QRectF& room, double max, double min) {
  const double usual = font.pointSizeF();
  for (double factor = max;; factor -= 0.1) {
    font.setPointSizeF(usual * std::max(factor, min));
    const QRectF needed = QFontMetricsF(font).boundingRect(room, Qt::TextWordWrap, text);
    if (factor <= min || (needed.width() <= room.width() && needed.height() <= room.height())) return font;
  }
}

}  // namespace

double GraphInk::line() const { return QFontMetricsF(font).height(); }

StageBox::StageBox(QString stage, std::shared_ptr<const GraphInk> ink)
    : stage_(std::move(stage)), ink_(std::move(ink)) {
  setZValue(1);
}

void StageBox::set_look(const Look& look) {
  look_ = look;
  update();
}

void StageBox::set_current(bool current) {
  current_ = current;
  update();
}

QRectF StageBox::boundingRect() const {
  const double by = (std::max(ring, socket) + thick) * ink_->line();
  return frame().adjusted(-by, -by, by, by);
}

void StageBox::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  paint_frame(*painter);
  paint_words(*painter, QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform()) < small_scale);
}

void StageBox::paint_frame(QPainter& painter) const {
  const double line = ink_->line();
  const auto& palette = ink_->palette;
  const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text),
               highlight = palette.color(QPalette::Highlight);
  const bool chosen = current_ && ink_->choice;
  const auto rounded = [&](double by) {
    painter.drawRoundedRect(frame().adjusted(-by, -by, by, by), corner * line + by, corner * line + by);
  };
  painter.setBrush(chosen ? mixed(base, highlight, 0.16) : look_.stale ? base : mixed(base, text, 0.04));
  QPen pen(mixed(base, text, 0.55), thin * line);
  if (look_.stale) pen.setDashPattern({4, 3});
  if (look_.mark == StageMark::failed || !look_.missing.isEmpty()) pen.setColor(red);
  if (chosen) pen = QPen(highlight, thick * line);
  painter.setPen(pen);
  rounded(0);
  painter.setBrush(Qt::NoBrush);
  if (chosen && ink_->focus) {
    painter.setPen(QPen(text, thin * line, Qt::DotLine));
    rounded(ring * line);
  }
  for (int i = 0; i < look_.missing.size(); ++i) {  // an open socket where an arrow should come in
    const double share = (i + 1.0) / (look_.missing.size() + 1);
    const QPointF at = ink_->orientation == Qt::Horizontal ? QPointF(0, share * frame().height())
                                                           : QPointF(share * frame().width(), 0);
    painter.setPen(QPen(red, thick * line));
    painter.setBrush(base);
    painter.drawEllipse(at, socket * line, socket * line);
  }
  if (look_.mark == StageMark::running) {
    const double inset = thick * line, width = frame().width() - 2 * inset;
    const QRectF bar(inset, frame().bottom() - inset - 0.28 * line, width * look_.fraction, 0.28 * line);
    painter.fillRect(bar, highlight);
  }
}

// Title, and below it the mark with what the state is. From far away: the mark, the number of warnings and large
// letters.
void StageBox::paint_words(QPainter& painter, bool large) const {
  const double line = ink_->line();
  const auto& palette = ink_->palette;
  const QRectF inner = frame().adjusted(margin * line, 0.25 * line, -margin * line, -0.25 * line);
  const double mark = (large ? 1.5 : mark_size) * line;
  const QRectF mark_at(inner.left() - 0.1 * line,
                       large ? inner.center().y() - mark / 2 : inner.bottom() - mark - 0.15 * line, mark, mark);
  const bool counted = large && look_.warnings > 0;
  paint_state(painter, counted ? mark_at.translated(0, -0.5 * line) : mark_at, look_.mark, palette);
  const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
  painter.setPen(text);
  if (counted) {
    QFont font = ink_->font;
    font.setPointSizeF(count_size * font.pointSizeF());
    painter.setFont(font);
    painter.drawText(mark_at.translated(0, 0.75 * line), Qt::AlignCenter, QString::number(look_.warnings));
  }
  painter.setPen(look_.stale ? mixed(base, text, quiet_share) : text);
  const QRectF title = large ? inner.adjusted(mark + 0.1 * line, 0, 0, 0)
                             : QRectF(inner.topLeft(), QPointF(inner.right(), mark_at.top()));
  painter.setFont(fitting_font(ink_->font, look_.title, title, large ? max_title : 1, min_title));
  painter.drawText(title, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, look_.title);
  if (large) return;
  painter.setFont(ink_->font);
  const QRectF state(mark_at.right() + 0.25 * line, mark_at.top(), inner.right() - mark_at.right() - 0.25 * line, mark);
  painter.setPen(mixed(base, text, quiet_share));
  painter.drawText(state, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetricsF(ink_->font).elidedText(look_.state, Qt::ElideRight, state.width()));
}

StageArrow::StageArrow(std::size_t from, std::size_t to, const std::vector<QPointF>& way, Qt::Orientation orientation,
                       std::shared_ptr<const GraphInk> ink)
    : from_(from), to_(to), ink_(std::move(ink)) {
  const QPointF along = orientation == Qt::Horizontal ? QPointF(1, 0) : QPointF(0, 1);
  const QPointF across(along.y(), along.x());
  const double length = head_length * ink_->line(), width = head_width * ink_->line();
  const QPointF tip = way.back(), end = tip - 0.8 * length * along;
  line_.moveTo(way.front());
  for (std::size_t i = 1; i < way.size(); i += 2) {
    const QPointF a = way[i - 1], b = i + 1 == way.size() ? end : way[i];
    const double half = QPointF::dotProduct(b - a, along) / 2;
    line_.cubicTo(a + half * along, b - half * along, b);
    if (i + 1 < way.size()) line_.lineTo(way[i + 1]);
  }
  head_ << tip << tip - length * along + width / 2 * across << tip - length * along - width / 2 * across;
}

void StageArrow::set_lit(bool lit) {
  lit_ = lit;
  setZValue(lit ? 0.5 : 0);
  update();
}

QRectF StageArrow::boundingRect() const {
  const double by = thick * ink_->line();
  return (line_.boundingRect() | head_.boundingRect()).adjusted(-by, -by, by, by);
}

QPainterPath StageArrow::shape() const {
  QPainterPathStroker stroker;
  stroker.setWidth(reach * ink_->line());
  return stroker.createStroke(line_);
}

void StageArrow::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const bool lit = lit_ && ink_->choice;
  const auto& palette = ink_->palette;
  const QColor color = lit ? palette.color(QPalette::Highlight)
                           : mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), unlit_share);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(color, (lit ? thick : thin) * ink_->line(), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter->setBrush(Qt::NoBrush);
  painter->drawPath(line_);
  painter->setPen(Qt::NoPen);
  painter->setBrush(color);
  painter->drawPolygon(head_);
}

}  // namespace bole::desktop
