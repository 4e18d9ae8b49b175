// A flat picture behind everything else in a scene: a map below a survey.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace bole::render {

// Red, green, blue and alpha; the first row is the northernmost.
struct GroundPicture {
  int width = 0, height = 0;       // px
  std::vector<std::uint8_t> rgba;  // 4 x width x height
};

// Each pixel is the mean of `step` x `step`, or fewer at the borders; what is transparent does not count.
GroundPicture coarser(const GroundPicture& picture, int step);

// Shares the pixels, and keeps them alive. `smaller_too`: with all smaller sizes of the picture, for views that show it
// small; of a picture of 4096 x 4096 pixels they take 0.1 s to make.
vtkSmartPointer<vtkTexture> ground_texture(const std::shared_ptr<const GroundPicture>& picture, bool smaller_too);

// `corners` of the picture, relative to the origin of the scene: north-west, north-east, south-east, south-west. It is
// drawn behind whatever is in the scene: points below its plane are seen too.
vtkSmartPointer<vtkActor> ground_actor(vtkTexture* texture, const std::array<Eigen::Vector3d, 4>& corners,
                                       double opacity);

}  // namespace bole::render
