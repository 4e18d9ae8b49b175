#include "rgbd/core/calibration/board_shots.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace bole::rgbd {
namespace {

cv::Mat gray_of(const ColorImage& color) {
  cv::Mat gray;
  const cv::Mat image(color.height, color.width, CV_8UC3, const_cast<std::uint8_t*>(color.values.data()));
  cv::cvtColor(image, gray, cv::COLOR_RGB2GRAY);
  return gray;
}

// The inner corners of a chessboard that is seen whole.
std::vector<BoardCorner> chessboard_corners(const ColorImage& color, const BoardFacts& board) {
  const cv::Size inner(board.columns - 1, board.rows - 1);
  const cv::Mat gray = gray_of(color);
  std::vector<cv::Point2f> found;
  bool seen = cv::findChessboardCornersSB(gray, inner, found, cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY);
  if (!seen) {
    seen = cv::findChessboardCorners(
        gray, inner, found, cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK);
    const cv::TermCriteria enough(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 40, 1e-3);
    if (seen) cv::cornerSubPix(gray, found, {5, 5}, {-1, -1}, enough);
  }
  std::vector<BoardCorner> corners;
  if (!seen || static_cast<int>(found.size()) != inner.area()) return corners;
  for (int row = 0; row < inner.height; ++row)
    for (int column = 0; column < inner.width; ++column) {
      const int at = row * inner.width + column;
      const auto& p = found[static_cast<std::size_t>(at)];
      corners.push_back({board.square * Eigen::Vector3d(column + 1, row + 1, 0), {p.x, p.y}});
    }
  return corners;
}

}  // namespace

BoardFacts board_to_find(const ViewSource& views, const CalibrationOptions& options) {
  if (!options.board) {
    if (const auto board = views.board()) return *board;
    throw bad_input("the views have no board (mat.json)", "the board that they show",
                    "Set board=chessboard or board=charuco with columns, rows and square, or write mat.json");
  }
  BoardFacts board;
  board.columns = options.columns;
  board.rows = options.rows;
  board.square = options.square;
  if (*options.board == BoardKind::charuco) {
    board.marker = options.marker;
    board.dictionary = options.dictionary;
  }
  return board;
}

std::vector<BoardShot> find_boards(const ViewSource& views, const BoardFacts& board, const CameraModel& camera,
                                   const Run& run) {
  const bool markers = board.marker > 0;
  if (!markers && (board.columns < 4 || board.rows < 4))
    throw bad_input("a chessboard of " + std::to_string(board.columns) + " x " + std::to_string(board.rows) +
                        " squares is too small",
                    "4 x 4 squares or more");
  std::optional<CharucoBoard> charuco;
  if (markers) charuco.emplace(board);
  std::vector<BoardShot> shots(views.size());
  constexpr std::size_t batch = 4;  // progress is told by the thread that called
  for (std::size_t first = 0; first < shots.size(); first += batch) {
    run.check_cancel();
    run.report(static_cast<double>(first) / static_cast<double>(shots.size()), "looking for the board");
    tbb::parallel_for(first, std::min(first + batch, shots.size()), [&](std::size_t i) {
      auto& shot = shots[i];
      shot.name = views.name(i);
      shot.view = i;
      View view;
      try {
        views.read(i, view, {.color = true, .depth = false, .mask = false});
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::bad_input) throw;
        shot.left_out = "cannot be read";
        return;
      }
      if (markers) {
        if (auto sighting = charuco->find(view.color, camera)) {
          shot.corners = std::move(sighting->corners);
          shot.layout = sighting->layout;
        }
      } else {
        shot.corners = chessboard_corners(view.color, board);
      }
      if (shot.corners.empty()) shot.left_out = "board not found";
    });
  }
  return shots;
}

std::vector<BoardShot> shots_of_table(const Table& table) {
  const auto x = table.numbers("x_px"), y = table.numbers("y_px");
  const auto board_x = table.numbers("board_x_m"), board_y = table.numbers("board_y_m");
  if (!table.has("view"))
    throw bad_input("the corners have no column 'view'", "view, x_px, y_px, board_x_m, board_y_m");
  std::map<std::string, std::size_t> index;
  std::vector<BoardShot> shots;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!std::isfinite(x[row] + y[row] + board_x[row] + board_y[row]))
      throw bad_input("row " + std::to_string(row + 1) + " of the corners has a missing number", "four numbers");
    const auto name = table.text("view", row);
    const auto [it, fresh] = index.emplace(name, shots.size());
    if (fresh) {
      shots.emplace_back();
      shots.back().name = name;
      shots.back().view = it->second;
    }
    shots[it->second].corners.push_back({{board_x[row], board_y[row], 0}, {x[row], y[row]}});
  }
  return shots;
}

}  // namespace bole::rgbd
