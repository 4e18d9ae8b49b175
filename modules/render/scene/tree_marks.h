// Numbers of trees over a 3-D view, each with a symbol for the quality of its diameter and what a person decided: told
// by shape and not by colour alone.
#pragma once

#include <string>
#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

struct TreeMark {
  Eigen::Vector2d at_mm = Eigen::Vector2d::Zero();  // of the symbol, from the upper left corner of the view
  std::string number;
  std::string quality;  // good: disc, fair: triangle, poor: square; else a ring
  std::string state;    // accepted: ticked, rejected: struck out; else nothing
  bool strong = false;  // selected
};

Box mark_box(const TreeMark& mark);  // on the view; enough for symbol and number

// Those that cover no other one and lie in the view; the first ones go before.
std::vector<TreeMark> kept_apart(const std::vector<TreeMark>& marks, const Box& view, std::size_t max_count);

// Fills a canvas of the size of mark_box().
void draw_tree_mark(Canvas& canvas, const TreeMark& mark);

// One line for each symbol that occurs in `marks`; the height of the canvas is that of tree_legend_height_mm().
void draw_tree_legend(Canvas& canvas, const std::vector<TreeMark>& marks);
double tree_legend_height_mm(const std::vector<TreeMark>& marks);
std::string tree_legend_state(const std::vector<TreeMark>& marks);  // the same for legends that look alike
inline constexpr double tree_legend_width_mm = 26;

}  // namespace bole::render
