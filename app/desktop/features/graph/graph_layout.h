// Where the boxes and arrows of a graph are drawn: in layers, so that arrows point forward and few of them cross.
// Layers by the longest path, their order by barycentre sweeps (Sugiyama, Tagawa and Toda 1981), places by least
// squares of the lengths of the arrows. The same graph always gives the same drawing.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace bole::desktop {

struct GraphArrow {
  std::size_t from = 0, to = 0;  // numbers of boxes
};

struct GraphSpacing {
  double layers = 0;  // between two layers, where arrows turn
  double boxes = 0;   // between boxes of a layer
  double lanes = 0;   // between arrows that pass a layer, and between them and boxes
};

struct GraphLayout {
  std::vector<QRectF> boxes;
  // Of each arrow: from the edge of its first box to that of its second. Between the two come the points where it
  // enters and leaves the layers that it passes. Arrows of one box share their way until they part.
  std::vector<std::vector<QPointF>> arrows;
  std::vector<int> layers;  // of each box
  QRectF extent;
};

// All boxes have the same size. Qt::Horizontal: from left to right; Qt::Vertical: from top to bottom. Of a circle,
// which no pipeline that runs has, one arrow points back.
GraphLayout lay_out_graph(std::size_t boxes, const std::vector<GraphArrow>& arrows, const QSizeF& box,
                          const GraphSpacing& spacing, Qt::Orientation orientation);

}  // namespace bole::desktop
