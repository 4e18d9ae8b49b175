// Puts labels beside points so that none covers another label, a point or the edge.
#pragma once

#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

struct LabelRequest {
  Eigen::Vector2d anchor;  // the point, millimetres
  double radius_mm = 0;    // of the mark that must stay free
  Eigen::Vector2d size;    // of the text, millimetres
};

struct LabelPlace {
  Box box;              // the text's
  bool leader = false;  // far enough from its point to want a line to it
};

// Places in the order of the requests. Positions around each point are tried at growing distance; a few rounds let
// labels that were placed early give way. Where there is no free place the least covered one is taken. Deterministic;
// about n log n.
std::vector<LabelPlace> place_labels(const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles,
                                     const Box& bounds);

}  // namespace bole::render
