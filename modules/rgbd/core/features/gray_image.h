// For .cpp files that call OpenCV.
#pragma once

#include <vector>

#include "camera/image.h"

namespace cv {
class Mat;
}

namespace bole::rgbd {

// The brightness of a colour image, 8 bit (a copy).
cv::Mat gray_image(const ColorImage& color);

}  // namespace bole::rgbd
