// Boxes and arrows of the graph of a pipeline. Everything is measured in the height of a line of text.
#pragma once

#include <QFont>
#include <QGraphicsItem>
#include <QPalette>
#include <QPointF>
#include <memory>
#include <vector>

#include "look/stage_icons.h"

namespace bole::desktop {

// What all items of a graph are drawn with.
struct GraphInk {
  QFont font;
  QPalette palette;
  Qt::Orientation orientation = Qt::Horizontal;
  bool focus = false;   // the keys go to the graph
  bool choice = true;   // false: in a picture for others nothing is selected
  double line() const;  // the height of a line of text
  QSizeF box() const { return QSizeF(9.8, 4.0) * line(); }
};

class StageBox : public QGraphicsItem {
 public:
  struct Look {
    QString title, state;  // "2 warnings · 3 s"
    QStringList missing;   // required inputs that are joined to nothing
    StageMark mark = StageMark::idle;
    int warnings = 0;
    double fraction = 0;  // of a stage that runs
    bool stale = false;   // what it gave is out of date, or it does not run
  };
  StageBox(QString stage, std::shared_ptr<const GraphInk> ink);

  const QString& stage() const { return stage_; }
  const Look& look() const { return look_; }
  void set_look(const Look& look);
  void set_current(bool current);
  bool current() const { return current_; }

  QRectF boundingRect() const override;
  QRectF frame() const { return QRectF(QPointF(), ink_->box()); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paint_frame(QPainter& painter) const;
  void paint_words(QPainter& painter, bool large) const;

  QString stage_;
  std::shared_ptr<const GraphInk> ink_;
  Look look_;
  bool current_ = false;
};

class StageArrow : public QGraphicsItem {
 public:
  StageArrow(std::size_t from, std::size_t to, const std::vector<QPointF>& way, Qt::Orientation orientation,
             std::shared_ptr<const GraphInk> ink);

  std::size_t from() const { return from_; }
  std::size_t to() const { return to_; }
  void set_lit(bool lit);  // of the stage that is selected
  bool lit() const { return lit_; }

  QRectF boundingRect() const override;
  QPainterPath shape() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::size_t from_, to_;
  std::shared_ptr<const GraphInk> ink_;
  QPainterPath line_;
  QPolygonF head_;
  bool lit_ = false;
};

}  // namespace bole::desktop
