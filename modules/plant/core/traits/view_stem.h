// A stretch of the stem as one view shows it: where its sections lie in the picture, and what hides them.
#pragma once

#include <span>
#include <vector>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "plant/core/traits/edge_profile.h"
#include "plant/core/traits/stem_strips.h"

namespace bole::plant {

constexpr double max_half_width_px = 90;  // a stem that fills the picture is measured from others

// Where a section lies in the picture.
struct ViewSection {
  double z = 0, depth = 0, pixels_per_unit = 0;
  Eigen::Vector2d place, across, along;  // pixels; across points to the right of the stem's way up
};

// Depth of what is nearest to a camera and not the stem, in blocks of pixels.
class NearestDepth {
 public:
  explicit NearestDepth(const CameraModel& camera);
  void add(const Eigen::Vector2d& pixel, double splat, float depth);
  float at(const Eigen::Vector2d& pixel) const;  // the largest float where there is nothing

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  int columns_, rows_;
  std::vector<float> nearest_;
};

class ViewStem {
 public:
  // Camera and search are referred to.
  ViewStem(const CameraModel& camera, const Pose& T_plant_camera, const StripSearch& search);

  const std::vector<ViewSection>& sections() const { return sections_; }
  Eigen::Vector3d centre() const { return T_plant_camera_.translation(); }
  // Unit, in plant axes.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  // Takes the sections out that something nearer hides; returns how many.
  std::size_t remove_hidden(const NearestDepth& nearest, double spacing);
  // The picture's own pixels in a strip one and a half pixels thick.
  std::vector<StripPixel> pixels_of(const ViewSection& section, double half_length, const ColorImage& image) const;

 private:
  const CameraModel& camera_;
  Pose T_plant_camera_;
  const StripSearch& search_;
  std::vector<ViewSection> sections_;
};

// What hides the stretches of one view: all points around them but those of the stem itself. `spacing`: of the cloud.
NearestDepth depth_around(const CameraModel& camera, const Pose& T_camera_plant, std::span<const ViewStem> stems,
                          std::span<const StripSearch> searches, const Points3& cloud, double spacing);

}  // namespace bole::plant
