// For .cpp files that call OpenCV.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace cv {
class Mat;
}

namespace bole::rgbd {

// The corner of four chess squares near `start`, to a fraction of a pixel. `along_x` and `along_y` lead from the corner
// along the edges of the squares, as far as nothing but the squares is printed there; `black` is the square between
// them. Nothing where it moved more than `max_move_px`, or where the four squares do not have the brightness of a
// chessboard: something hides the corner.
std::optional<Eigen::Vector2d> refine_chess_corner(const cv::Mat& gray, const Eigen::Vector2d& start,
                                                   const Eigen::Vector2d& along_x, const Eigen::Vector2d& along_y,
                                                   bool black, double max_move_px);

}  // namespace bole::rgbd
