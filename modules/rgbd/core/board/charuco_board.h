// Finds the corners of a ChArUco board, part of which may be hidden.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/transform.h"
#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/core/view_source.h"
#include "rgbd/core/board/board_layout.h"

namespace bole::rgbd {

struct BoardCorner {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // on the board, metres
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

struct BoardSighting {
  std::vector<BoardCorner> corners;  // of the chess squares, to a fraction of a pixel
  BoardLayout layout;                // that explains the markers
  int markers = 0;                   // that were seen and agree
};

// Axes of the board: x to the right along the columns of the print, y up along its rows, z out of the print towards the
// observer; origin in the lower left corner of the print.
class CharucoBoard {
 public:
  // Throws Error{bad_input} for an unknown dictionary and for sizes that make no board.
  explicit CharucoBoard(const BoardFacts& facts);
  ~CharucoBoard();
  CharucoBoard(CharucoBoard&&) noexcept;
  CharucoBoard& operator=(CharucoBoard&&) noexcept;

  // Nothing where fewer than two markers agree. The layout of the print is that of layout_of_markers().
  std::optional<BoardSighting> find(const ColorImage& color, const CameraModel& camera) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The pose of a camera by the corners that it sees (IPPE: Collins and Bartoli 2014, then refined).
struct BoardPose {
  Pose T_board_camera = Pose::Identity();
  double residual_px = 0;  // root mean square
  bool ambiguous = false;  // the mirrored pose fits nearly as well: the board is too small or too far away
};

// Nothing for fewer than six corners, or corners in one line.
std::optional<BoardPose> board_pose(const std::vector<BoardCorner>& corners, const CameraModel& camera);

}  // namespace bole::rgbd
