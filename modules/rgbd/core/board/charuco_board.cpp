#include "rgbd/core/board/charuco_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "base/error.h"
#include "rgbd/core/board/board_layout.h"
#include "rgbd/core/board/corner_check.h"
#include "rgbd/core/features/gray_image.h"

namespace bole::rgbd {
namespace {

using aruco_name = std::pair<const char*, int>;
constexpr std::array<aruco_name, 21> dictionaries{{{"DICT_4X4_50", cv::aruco::DICT_4X4_50},
                                                   {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
                                                   {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
                                                   {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
                                                   {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
                                                   {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
                                                   {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
                                                   {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
                                                   {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
                                                   {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
                                                   {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
                                                   {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
                                                   {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
                                                   {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
                                                   {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
                                                   {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
                                                   {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
                                                   {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
                                                   {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
                                                   {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
                                                   {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11}}};

constexpr int min_markers = 2;
constexpr double max_second_move_px = 1.5;  // once the corners next to markers tell where the others are
constexpr std::size_t min_corners_for_others = 8;
constexpr double homography_tolerance_px = 2.5;
constexpr int small_image = 1000;    // pixels across: markers may be too small for the detector, and are made larger
constexpr double max_move_px = 2.5;  // of a corner from where the markers say it is

cv::Ptr<cv::aruco::Dictionary> dictionary_of(const std::string& name) {
  for (const auto& [word, id] : dictionaries)
    if (name == word) return cv::aruco::getPredefinedDictionary(id);
  std::string known;
  for (const auto& [word, id] : dictionaries) known += std::string(known.empty() ? "" : ", ") + word;
  throw bad_input("the board's dictionary is '" + name + "'", "one of " + known);
}

// The corners of a marker on the board, clockwise as it is seen, from its upper left.
std::array<Eigen::Vector2d, 4> corners_of(const BoardFacts& facts, const BoardSquare& at) {
  const Eigen::Vector2d centre((at.column + 0.5) * facts.square, (at.row + 0.5) * facts.square);
  const double h = facts.marker / 2;
  return {centre + Eigen::Vector2d(-h, h), centre + Eigen::Vector2d(h, h), centre + Eigen::Vector2d(h, -h),
          centre + Eigen::Vector2d(-h, -h)};
}

struct Explained {
  BoardLayout layout;
  std::vector<std::size_t> markers;                 // that agree
  Eigen::Matrix3d H = Eigen::Matrix3d::Identity();  // from the board to the plane z = 1
};

Eigen::Matrix3d homography(const std::vector<cv::Point2f>& from, const std::vector<cv::Point2f>& to, double tolerance,
                           std::vector<std::uint8_t>& inlier) {
  const cv::Mat H = cv::findHomography(from, to, cv::RANSAC, tolerance, inlier);
  Eigen::Matrix3d out = Eigen::Matrix3d::Zero();
  if (H.empty()) return out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out(r, c) = H.at<double>(r, c);
  return out;
}

Explained explain(const BoardFacts& facts, const BoardLayout& layout, const std::vector<BoardMarker>& markers,
                  double tolerance) {
  Explained out;
  out.layout = layout;
  const auto squares = squares_of(facts, layout);
  std::vector<cv::Point2f> board, image;
  std::vector<std::size_t> owner;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto at = squares.find(markers[m].id);
    if (at == squares.end()) continue;
    const auto corners = corners_of(facts, at->second);
    for (std::size_t k = 0; k < 4; ++k) {
      board.emplace_back(static_cast<float>(corners[k].x()), static_cast<float>(corners[k].y()));
      image.emplace_back(static_cast<float>(markers[m].plane[k].x()), static_cast<float>(markers[m].plane[k].y()));
    }
    owner.push_back(m);
  }
  if (owner.size() < min_markers) return out;
  std::vector<std::uint8_t> inlier;
  out.H = homography(board, image, tolerance, inlier);
  for (std::size_t i = 0; i < owner.size() && inlier.size() == board.size(); ++i)
    if (inlier[4 * i] && inlier[4 * i + 1] && inlier[4 * i + 2] && inlier[4 * i + 3]) out.markers.push_back(owner[i]);
  return out;
}

// Looks for corners of chess squares where a homography of the board says they are.
class CornerSearch {
 public:
  CornerSearch(const BoardFacts& facts, const BoardLayout& layout, const cv::Mat& gray, const CameraModel& camera)
      : facts_(facts), layout_(layout), gray_(gray), camera_(camera) {}

  std::optional<BoardCorner> find(const BoardSquare& at, const Eigen::Matrix3d& H, double max_move) const {
    const double x = at.column * facts_.square, y = at.row * facts_.square;
    const double margin = (facts_.square - facts_.marker) / 2;
    const auto start = to_pixel(H, x, y), along_x = to_pixel(H, x + margin, y), along_y = to_pixel(H, x, y + margin);
    if (!start || !along_x || !along_y) return std::nullopt;
    // Whether the square up and to the right of the corner is black.
    const int rows_from_first = layout_.from_upper_row ? facts_.rows - 1 - at.row : at.row;
    const bool black = ((at.column + rows_from_first) % 2 == 0) == layout_.first_square_black;
    const auto pixel = refine_chess_corner(gray_, *start, *along_x - *start, *along_y - *start, black, max_move);
    if (!pixel) return std::nullopt;
    return BoardCorner{{x, y, 0}, *pixel};
  }

  Eigen::Matrix3d plane_of(const std::vector<BoardCorner>& corners) const {
    std::vector<cv::Point2f> board, plane;
    for (const auto& c : corners) {
      const Eigen::Vector3d d = camera_.direction(c.pixel);
      board.emplace_back(static_cast<float>(c.point.x()), static_cast<float>(c.point.y()));
      plane.emplace_back(static_cast<float>(d.x()), static_cast<float>(d.y()));
    }
    std::vector<std::uint8_t> inlier;
    return homography(board, plane, max_second_move_px / std::abs(camera_.fx), inlier);
  }

 private:
  std::optional<Eigen::Vector2d> to_pixel(const Eigen::Matrix3d& H, double x, double y) const {
    const Eigen::Vector3d p = H * Eigen::Vector3d(x, y, 1);
    if (!(std::abs(p.z()) > 0)) return std::nullopt;
    return camera_.project(Eigen::Vector3d(p / p.z()));
  }

  const BoardFacts& facts_;
  const BoardLayout& layout_;
  const cv::Mat& gray_;
  const CameraModel& camera_;
};

}  // namespace

struct CharucoBoard::Parts {
  BoardFacts facts;
  cv::Ptr<cv::aruco::Dictionary> dictionary;

  std::vector<BoardMarker> markers_in(const cv::Mat& image, const CameraModel& camera) const {
    cv::Mat gray = image;
    const bool small = image.cols < small_image;
    if (small) cv::resize(image, gray, {}, 2, 2, cv::INTER_CUBIC);
    auto parameters = cv::aruco::DetectorParameters::create();
    parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
    parameters->cornerRefinementWinSize = 3;
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    cv::aruco::detectMarkers(gray, dictionary, corners, ids, parameters);
    std::vector<BoardMarker> out;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      BoardMarker m;
      m.id = ids[i];
      for (std::size_t k = 0; k < 4; ++k) {
        m.pixels[k] = {static_cast<double>(corners[i][k].x), static_cast<double>(corners[i][k].y)};
        if (small) m.pixels[k] = ((m.pixels[k].array() + 0.5) / 2 - 0.5).matrix();
        m.plane[k] = camera.direction(m.pixels[k]).head<2>();
      }
      out.push_back(m);
    }
    std::ranges::sort(out, {}, [](const BoardMarker& m) { return std::tuple(m.id, m.pixels[0].x(), m.pixels[0].y()); });
    return out;
  }

  // Corners of chess squares next to a marker that was seen.
  std::vector<BoardSquare> visible_corners(const Explained& seen, const std::vector<BoardMarker>& markers) const {
    const auto squares = squares_of(facts, seen.layout);
    std::map<std::pair<int, int>, int> touched;
    for (const std::size_t m : seen.markers) {
      const auto& s = squares.at(markers[m].id);
      for (const int dr : {0, 1})
        for (const int dc : {0, 1}) ++touched[{s.row + dr, s.column + dc}];
    }
    std::vector<BoardSquare> out;
    for (const auto& [at, count] : touched)
      if (at.first > 0 && at.first < facts.rows && at.second > 0 && at.second < facts.columns)
        out.push_back({at.second, at.first});
    return out;
  }
};

CharucoBoard::CharucoBoard(const BoardFacts& facts) : parts_(std::make_unique<Parts>()) {
  const auto found = "the board has " + std::to_string(facts.columns) + " x " + std::to_string(facts.rows) +
                     " squares of " + std::to_string(facts.square) + " m with markers of " +
                     std::to_string(facts.marker) + " m";
  constexpr int max_squares = 1000;
  if (facts.columns < 2 || facts.rows < 2 || facts.columns > max_squares || facts.rows > max_squares)
    throw bad_input(found, "2 to 1000 squares in each direction", "Correct mat.json.");
  if (!(facts.marker > 0) || !(facts.square > facts.marker) || !(facts.square < 10))
    throw bad_input(found, "markers smaller than their squares", "Correct square_mm and marker_mm in mat.json.");
  parts_->facts = facts;
  parts_->dictionary = dictionary_of(facts.dictionary);
}
CharucoBoard::~CharucoBoard() = default;
CharucoBoard::CharucoBoard(CharucoBoard&&) noexcept = default;
CharucoBoard& CharucoBoard::operator=(CharucoBoard&&) noexcept = default;

std::optional<BoardSighting> CharucoBoard::find(const ColorImage& color, const CameraModel& camera) const {
  if (color.empty()) return std::nullopt;
  const cv::Mat gray = gray_image(color);
  const auto markers = parts_->markers_in(gray, camera);
  const auto seen = explain(parts_->facts, layout_of_markers(parts_->facts, markers), markers,
                            homography_tolerance_px / std::abs(camera.fx));
  if (seen.markers.size() < min_markers) return std::nullopt;

  BoardSighting out;
  out.layout = seen.layout;
  out.markers = static_cast<int>(seen.markers.size());
  const CornerSearch search(parts_->facts, seen.layout, gray, camera);
  const auto next_to_markers = parts_->visible_corners(seen, markers);
  for (const auto& at : next_to_markers)
    if (const auto c = search.find(at, seen.H, max_move_px)) out.corners.push_back(*c);
  if (out.corners.size() < min_corners_for_others) return out;
  // Corners whose markers were not read: too small, shaded or hidden in part.
  const auto H = search.plane_of(out.corners);
  for (int row = 1; row < parts_->facts.rows; ++row)
    for (int column = 1; column < parts_->facts.columns; ++column) {
      const auto same = [&](const BoardSquare& s) { return s.row == row && s.column == column; };
      if (std::ranges::any_of(next_to_markers, same)) continue;
      if (const auto c = search.find({column, row}, H, max_second_move_px)) out.corners.push_back(*c);
    }
  return out;
}

}  // namespace bole::rgbd
