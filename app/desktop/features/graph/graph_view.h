// The pipeline as a graph: a box for each stage, an arrow for what one takes from another. Boxes are selected as in the
// list of stages, and show the same states.
#pragma once

#include <QGraphicsView>
#include <array>
#include <memory>

#include "features/graph/graph_items.h"
#include "features/graph/graph_layout.h"
#include "features/graph/stage_graph.h"

namespace bole::desktop {

class Workbench;

class GraphView : public QGraphicsView {
  Q_OBJECT

 public:
  explicit GraphView(Workbench& bench);

  void fit();  // all of it, in the direction in which it is larger
  // SVG or PNG by the ending of the name: all of it on white paper. Throws bole::Error.
  void save(const QString& path) const;

  Qt::Orientation orientation() const { return orientation_; }
  const StageGraph& graph() const { return graph_; }
  const std::vector<StageBox*>& boxes() const { return boxes_; }      // by stage
  const std::vector<StageArrow*>& arrows() const { return arrows_; }  // by join
  StageBox* box(const QString& id) const;                             // null: there is none
  QString tip_at(const QPointF& place) const;                         // in the scene
  QString tip_of(const StageBox& box) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void menu_asked(const QPoint& global);
  void options_asked();

 protected:
  bool viewportEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void rebuild();  // from the document
  void lay_out();  // for both directions, in the font at hand
  void show_layout(Qt::Orientation orientation);
  void show_state(StageBox& box) const;
  void show_states() const;
  void show_current();
  void choose(const StageBox* box);
  StageBox* box_at(const QPointF& place) const;
  // The box that a key leads to: along the arrows, or among those beside.
  StageBox* next_box(int key) const;
  double scale_for(Qt::Orientation orientation) const;
  Qt::Orientation larger() const;  // the direction in which all of it is seen larger
  const GraphLayout& layout() const { return layouts_[orientation_ == Qt::Horizontal ? 0 : 1]; }
  void show_focus(bool on);

  Workbench& bench_;
  std::shared_ptr<GraphInk> ink_;
  StageGraph graph_;
  std::array<GraphLayout, 2> layouts_;  // from left to right, from top to bottom
  Qt::Orientation orientation_ = Qt::Horizontal;
  std::vector<StageBox*> boxes_;
  std::vector<StageArrow*> arrows_;
  bool whole_ = true;  // nobody zoomed: a change of the size shows all again
};

}  // namespace bole::desktop
