#include "features/field_check/plot_map.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "look/theme.h"
#include "render/charts/columns.h"
#include "render/draw/color.h"

namespace bole::desktop {
namespace {

QColor to_qt(const render::Color& c) { return QColor::fromRgbF(c.r, c.g, c.b); }

std::int64_t id_at(const Table& table, const char* column, std::size_t row) {
  const auto numbers = render::numbers_or_nan(table, column);
  return std::isfinite(numbers[row]) ? static_cast<std::int64_t>(numbers[row]) : 0;
}

}  // namespace

QColor match_color(MatchKind kind, const QPalette& palette) {
  const QColor color = to_qt(kind == MatchKind::matched  ? render::ink::good
                             : kind == MatchKind::missed ? render::ink::fair
                                                         : render::ink::poor);
  return is_dark(palette) ? color.lighter(140) : color;
}

std::vector<MatchRow> match_rows(const Table& matches) {
  std::vector<MatchRow> rows;
  const auto kinds = render::texts_or_empty(matches, "kind");
  const auto x = render::numbers_or_nan(matches, "x_m"), y = render::numbers_or_nan(matches, "y_m"),
             rx = render::numbers_or_nan(matches, "ref_x_m"), ry = render::numbers_or_nan(matches, "ref_y_m"),
             dbh = render::numbers_or_nan(matches, "dbh_cm"), field = render::numbers_or_nan(matches, "ref_dbh_cm");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    MatchRow row;
    row.kind = kinds[i] == "missed" ? MatchKind::missed : kinds[i] == "false" ? MatchKind::falsely : MatchKind::matched;
    if (row.kind != MatchKind::missed) row.tree = id_at(matches, "tree_id", i);
    if (row.kind != MatchKind::falsely) row.reference = id_at(matches, "ref_id", i);
    row.stem_m = row.kind == MatchKind::missed ? QPointF(rx[i], ry[i]) : QPointF(x[i], y[i]);
    row.field_m = row.kind == MatchKind::falsely ? row.stem_m : QPointF(rx[i], ry[i]);
    row.dbh_cm = dbh[i];
    row.field_dbh_cm = field[i];
    rows.push_back(row);
  }
  return rows;
}

PlotMap::PlotMap(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  setMinimumSize(150, 110);
  setMouseTracking(false);
  connect(&selection_, &Selection::changed, this, [this] {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (selection_.tree() && rows_[i].tree == selection_.tree()) current_ = static_cast<int>(i);
    update();
  });
}

void PlotMap::show_matches(const std::vector<MatchRow>& rows) {
  rows_ = rows;
  current_ = -1;
  QRectF extent;
  for (const auto& row : rows)
    for (const auto& at : {row.stem_m, row.field_m}) extent |= QRectF(at - QPointF(0.5, 0.5), QSizeF(1, 1));
  const bool as_before =
      (extent.center() - extent_m_.center()).manhattanLength() < 2 && std::abs(extent.width() - extent_m_.width()) < 4;
  extent_m_ = extent;
  if (!as_before) fit();
  update();
}

void PlotMap::set_current(int row) {
  current_ = row;
  if (row >= 0 && !rect().adjusted(20, 20, -20, -20).contains(place_of(row).toPoint()))
    middle_m_ = rows_[static_cast<std::size_t>(row)].stem_m;
  update();
}

QPointF PlotMap::place_of(int row) const { return to_widget(rows_.at(static_cast<std::size_t>(row)).stem_m); }

void PlotMap::fit() {
  if (extent_m_.isEmpty()) return;
  middle_m_ = extent_m_.center();
  px_per_m_ = 0.9 * std::min(width() / extent_m_.width(), (height() - 40) / extent_m_.height());
  px_per_m_ = std::clamp(px_per_m_, 0.05, 2000.0);
}

QPointF PlotMap::to_widget(const QPointF& m) const {
  return QPointF(width() / 2.0 + (m.x() - middle_m_.x()) * px_per_m_,
                 height() / 2.0 - (m.y() - middle_m_.y()) * px_per_m_);
}

QPointF PlotMap::to_metres(const QPointF& w) const {
  return {middle_m_.x() + (w.x() - width() / 2.0) / px_per_m_, middle_m_.y() - (w.y() - height() / 2.0) / px_per_m_};
}

int PlotMap::row_at(const QPointF& widget) const {
  constexpr double reach_px = 12;
  int best = -1;
  double nearest_px = reach_px;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (const auto& at : {rows_[i].stem_m, rows_[i].field_m}) {
      const QPointF d = to_widget(at) - widget;
      if (const double distance = std::hypot(d.x(), d.y()); distance < nearest_px) {
        nearest_px = distance;
        best = static_cast<int>(i);
      }
    }
  return best;
}

void PlotMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  if (rows_.empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Load field measurements and run to see which trees were found."));
    return;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) draw_row(painter, rows_[i], static_cast<int>(i) == current_);
  draw_scale_bar(painter);
  draw_legend(painter);
}

void PlotMap::draw_row(QPainter& painter, const MatchRow& row, bool current) const {
  const QColor color = match_color(row.kind, palette());
  const QPointF stem = to_widget(row.stem_m), field = to_widget(row.field_m);
  // To scale, but never too small to be seen.
  const auto radius = [this](double dbh_cm) { return std::max(3.5, 0.005 * dbh_cm * px_per_m_); };
  if (row.kind != MatchKind::falsely) {
    painter.setPen(QPen(color, 1.6));
    painter.setBrush(Qt::NoBrush);
    if (row.kind == MatchKind::matched) painter.drawLine(stem, field);
    painter.drawEllipse(field, radius(row.field_dbh_cm), radius(row.field_dbh_cm));
  }
  if (row.kind != MatchKind::missed) {
    painter.setPen(Qt::NoPen);
    QColor fill = color;
    fill.setAlpha(150);
    painter.setBrush(fill);
    painter.drawEllipse(stem, radius(row.dbh_cm), radius(row.dbh_cm));
  }
  if (row.kind == MatchKind::falsely) {
    painter.setPen(QPen(color, 2));
    const double r = radius(row.dbh_cm) + 2;
    painter.drawLine(stem + QPointF(-r, -r), stem + QPointF(r, r));
    painter.drawLine(stem + QPointF(r, -r), stem + QPointF(-r, r));
  }
  painter.setPen(current ? palette().color(QPalette::Link) : palette().color(QPalette::Text));
  const auto number = row.tree ? *row.tree : row.reference;
  painter.drawText(stem + QPointF(radius(row.dbh_cm) + 4, 4), QString::number(number));
  if (!current) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Link), 2));
  painter.drawEllipse(stem, radius(std::fmax(row.dbh_cm, row.field_dbh_cm)) + 5,
                      radius(std::fmax(row.dbh_cm, row.field_dbh_cm)) + 5);
}

void PlotMap::draw_scale_bar(QPainter& painter) const {
  double metres = 0.1;
  for (const double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (step * px_per_m_ < width() / 3.0) metres = step;
  const double y = height() - 12, x = 12, length = metres * px_per_m_;
  painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
  painter.drawLine(QPointF(x, y), QPointF(x + length, y));
  for (const double end : {x, x + length}) painter.drawLine(QPointF(end, y - 4), QPointF(end, y));
  painter.drawText(QPointF(x + length + 6, y + 1), QString::number(metres) + " m");
  painter.drawText(QRectF(width() - 34, y - 10, 28, 16), Qt::AlignCenter, QStringLiteral("↑ N"));
}

void PlotMap::draw_legend(QPainter& painter) const {
  const std::pair<MatchKind, QString> entries[] = {{MatchKind::matched, tr("%1 matched")},
                                                   {MatchKind::missed, tr("%1 missed")},
                                                   {MatchKind::falsely, tr("%1 false")}};
  double x = 10;
  for (const auto& [kind, text] : entries) {
    const auto count = std::ranges::count(rows_, kind, &MatchRow::kind);
    painter.setPen(Qt::NoPen);
    painter.setBrush(match_color(kind, palette()));
    painter.drawEllipse(QPointF(x + 4, 14), 4.5, 4.5);
    painter.setPen(palette().color(QPalette::Text));
    const QString label = text.arg(count);
    painter.drawText(QPointF(x + 13, 18), label);
    x += 26 + painter.fontMetrics().horizontalAdvance(label);
  }
}

void PlotMap::mousePressEvent(QMouseEvent* event) {
  dragged_from_ = event->pos();
  if (const int row = row_at(event->pos()); row >= 0) Q_EMIT chosen(row);
}

void PlotMap::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPoint by = event->pos() - dragged_from_;
  middle_m_ += QPointF(-by.x(), by.y()) / px_per_m_;
  dragged_from_ = event->pos();
  update();
}

void PlotMap::mouseDoubleClickEvent(QMouseEvent*) {
  fit();
  update();
}

void PlotMap::wheelEvent(QWheelEvent* event) {
  const QPointF at = event->position(), before = to_metres(at);
  px_per_m_ = std::clamp(px_per_m_ * std::pow(1.15, event->angleDelta().y() / 120.0), 0.05, 2000.0);
  middle_m_ += before - to_metres(at);  // the place under the cursor stays
  event->accept();
  update();
}

void PlotMap::resizeEvent(QResizeEvent*) { fit(); }

void PlotMap::contextMenuEvent(QContextMenuEvent* event) {
  if (const int row = row_at(event->pos()); row >= 0) Q_EMIT menu_wanted(row, event->globalPos());
}

bool PlotMap::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int index = row_at(help->pos());
  if (index < 0) {
    QToolTip::hideText();
    return true;
  }
  const auto& row = rows_[static_cast<std::size_t>(index)];
  QStringList lines;
  if (row.tree) lines << tr("Stem %1, %2 cm").arg(*row.tree).arg(row.dbh_cm, 0, 'f', 1);
  if (row.kind != MatchKind::falsely)
    lines << tr("Field tree %1, %2 cm").arg(row.reference).arg(row.field_dbh_cm, 0, 'f', 1);
  QToolTip::showText(help->globalPos(), lines.join('\n'), this);
  return true;
}

}  // namespace bole::desktop
