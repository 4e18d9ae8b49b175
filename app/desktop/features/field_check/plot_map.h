// The plot from above: stems and field trees to scale, matched, missed and false.
#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "cloud/table.h"
#include "document/selection.h"

namespace bole::desktop {

enum class MatchKind { matched, missed, falsely };
QColor match_color(MatchKind kind, const QPalette& palette);

struct MatchRow {
  MatchKind kind = MatchKind::matched;
  std::optional<std::int64_t> tree;  // none for a missed one
  std::int64_t reference = 0;        // 0 for a false one
  QPointF stem_m, field_m;           // the one that is not there equals the other
  double dbh_cm = 0, field_dbh_cm = 0;
};
std::vector<MatchRow> match_rows(const Table& matches);  // by row of the table

class PlotMap : public QWidget {
  Q_OBJECT

 public:
  PlotMap(Selection& selection, QWidget* parent);
  void show_matches(const std::vector<MatchRow>& rows);  // zooms to them when their extent has changed
  void set_current(int row);
  QPointF place_of(int row) const;  // on the widget
  QSize sizeHint() const override { return {320, 300}; }

 Q_SIGNALS:
  void chosen(int row);
  void menu_wanted(int row, const QPoint& global);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;  // tooltips

 private:
  QPointF to_widget(const QPointF& metres) const;
  QPointF to_metres(const QPointF& widget) const;
  int row_at(const QPointF& widget) const;  // -1: none
  void fit();
  void draw_row(QPainter& painter, const MatchRow& row, bool current) const;
  void draw_scale_bar(QPainter& painter) const;
  void draw_legend(QPainter& painter) const;

  Selection& selection_;
  std::vector<MatchRow> rows_;
  int current_ = -1;
  QRectF extent_m_;
  QPointF middle_m_;
  double px_per_m_ = 20;
  QPoint dragged_from_;
};

}  // namespace bole::desktop
