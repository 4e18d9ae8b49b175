#include "rgbd/core/board/corner_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace bole::rgbd {
namespace {

constexpr int min_window = 2, max_window = 6;  // half, pixels
constexpr double min_edge_px = 2;              // with less of the squares around it, the markers disturb the corner
constexpr double min_contrast = 20;            // of 255
constexpr double max_unlike = 0.4;             // of the contrast, between squares of one colour

double brightness(const cv::Mat& gray, const Eigen::Vector2d& at) {
  const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
  const double fx = at.x() - x, fy = at.y() - y;
  const auto value = [&](int px, int py) { return static_cast<double>(gray.at<std::uint8_t>(py, px)); };
  return (1 - fy) * ((1 - fx) * value(x, y) + fx * value(x + 1, y)) +
         fy * ((1 - fx) * value(x, y + 1) + fx * value(x + 1, y + 1));
}

}  // namespace

std::optional<Eigen::Vector2d> refine_chess_corner(const cv::Mat& gray, const Eigen::Vector2d& start,
                                                   const Eigen::Vector2d& along_x, const Eigen::Vector2d& along_y,
                                                   bool black, double max_move_px) {
  const double edge = std::min(along_x.norm(), along_y.norm());
  if (!(edge >= min_edge_px)) return std::nullopt;
  const int window = std::clamp(static_cast<int>(0.9 * edge), min_window, max_window);
  const int border = max_window + 3 + static_cast<int>(std::ceil(along_x.norm() + along_y.norm()));
  if (!(start.x() >= border) || !(start.y() >= border) || !(start.x() < gray.cols - border) ||
      !(start.y() < gray.rows - border))
    return std::nullopt;
  std::vector<cv::Point2f> corner{{static_cast<float>(start.x()), static_cast<float>(start.y())}};
  cv::cornerSubPix(gray, corner, {window, window}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 40, 0.002});
  const Eigen::Vector2d found(static_cast<double>(corner[0].x), static_cast<double>(corner[0].y));
  if (!found.allFinite() || !((found - start).norm() <= max_move_px)) return std::nullopt;

  constexpr double reach = 0.6;
  std::array<double, 4> dark{}, light{};
  int darks = 0, lights = 0;
  for (const int sx : {1, -1})
    for (const int sy : {1, -1}) {
      const double value = brightness(gray, found + reach * (sx * along_x + sy * along_y));
      if ((sx == sy) == black)
        dark[static_cast<std::size_t>(darks++)] = value;
      else
        light[static_cast<std::size_t>(lights++)] = value;
    }
  const double contrast = (light[0] + light[1] - dark[0] - dark[1]) / 2;
  if (!(contrast >= min_contrast)) return std::nullopt;
  if (std::abs(light[0] - light[1]) > max_unlike * contrast || std::abs(dark[0] - dark[1]) > max_unlike * contrast)
    return std::nullopt;
  return found;
}

}  // namespace bole::rgbd
