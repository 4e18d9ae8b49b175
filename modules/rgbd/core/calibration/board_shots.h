// Pictures of a calibration board: the corners in each.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "cloud/table.h"
#include "rgbd/core/board/charuco_board.h"
#include "rgbd/core/calibration/calibration_options.h"

namespace bole::rgbd {

struct BoardShot {
  std::string name;
  std::size_t view = 0;              // in the source of views
  std::vector<BoardCorner> corners;  // points on the board in metres, z = 0
  BoardLayout layout;                // by which a ChArUco board was counted
  std::string left_out;              // why it takes no part; empty: it does
};

// The board that the options name, or that comes with the views. Throws Error{bad_input} where there is neither, or
// where it is no board.
BoardFacts board_to_find(const ViewSource& views, const CalibrationOptions& options);

// One shot per view, those without the board left out. A chessboard must be seen whole; of a ChArUco board some corners
// do. The camera is a guess as yet: only its size counts for a chessboard.
std::vector<BoardShot> find_boards(const ViewSource& views, const BoardFacts& board, const CameraModel& camera,
                                   const Run& run);

// Corners that were found elsewhere: columns view, x_px, y_px, board_x_m, board_y_m. Throws Error{bad_input}.
std::vector<BoardShot> shots_of_table(const Table& corners);

}  // namespace bole::rgbd
