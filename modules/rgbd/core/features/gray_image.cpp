#include "rgbd/core/features/gray_image.h"

#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace bole::rgbd {

cv::Mat gray_image(const ColorImage& color) {
  if (color.channels != 3 && color.channels != 1)
    throw bad_input("an image has " + std::to_string(color.channels) + " channels", "1 or 3");
  const cv::Mat pixels(color.height, color.width, color.channels == 3 ? CV_8UC3 : CV_8UC1,
                       const_cast<std::uint8_t*>(color.values.data()));  // NOLINT: read only
  cv::Mat gray;
  if (color.channels == 3)
    cv::cvtColor(pixels, gray, cv::COLOR_RGB2GRAY);
  else
    gray = pixels.clone();
  return gray;
}

}  // namespace bole::rgbd
