// What lies under the cursor.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cloud/point_cloud.h"
#include "render/scene/point_nodes.h"
#include "render/scene/stem_shapes.h"

namespace bole::render {

// A view of `width_px` x `height_px`; the matrix takes coordinates relative to `origin`.
struct PickView {
  Eigen::Matrix4d world_to_clip = Eigen::Matrix4d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double width_px = 1, height_px = 1;
};

// Pixels from the lower left corner; depth grows away from the eye. Nothing behind the eye.
struct OnScreen {
  Eigen::Vector2d px = Eigen::Vector2d::Zero();
  double depth = 0;
};
std::optional<OnScreen> on_screen(const PickView& view, const Eigen::Vector3d& world);

// The ends of a stretch on the screen, cut off at the eye; nothing when all of it lies behind.
std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segment_on_screen(const PickView& view,
                                                                             const Eigen::Vector3d& a,
                                                                             const Eigen::Vector3d& b);

// Where the ray through a pixel meets the plane z = `z`; nothing when it runs away from it.
std::optional<Eigen::Vector3d> on_plane(const PickView& view, const Eigen::Vector2d& at_px, double z);

// The place on the line through `at` along `direction` (of length 1) that comes nearest to the ray through a pixel;
// nothing where the two are nearly parallel.
std::optional<Eigen::Vector3d> on_line(const PickView& view, const Eigen::Vector2d& at_px, const Eigen::Vector3d& at,
                                       const Eigen::Vector3d& direction);

// The place below a pixel at the depth of OnScreen.
Eigen::Vector3d at_depth(const PickView& view, const Eigen::Vector2d& at_px, double depth);

// Whether a place within the box, world axes, may be seen within `reach_px` of a pixel.
bool may_be_near(const PickView& view, const Eigen::AlignedBox3d& box, const Eigen::Vector2d& at_px, double reach_px);

// Coordinates relative to `origin` against a pixel; those of points are relative to that of their cloud.
class AboutPixel {
 public:
  AboutPixel(const PickView& view, const Eigen::Vector3d& origin, const Eigen::Vector2d& at_px);
  struct Place {
    double right_px, up_px;  // from the pixel, times w: nothing is divided for the many places that are far from it
    double w;                // behind the eye where it is not positive
    bool within(double reach_px) const {
      return w > 1e-9 && right_px * right_px + up_px * up_px <= reach_px * reach_px * w * w;
    }
  };
  Place operator()(const Eigen::Vector3d& p) const {
    return {right_.head<3>().dot(p) + right_[3], up_.head<3>().dot(p) + up_[3], away_.head<3>().dot(p) + away_[3]};
  }
  double depth(const Eigen::Vector3d& p) const { return depth_.head<3>().dot(p) + depth_[3]; }  // times w

 private:
  Eigen::Vector4d right_, up_, depth_, away_;
};

// The foremost of `indices` within `reach_px` of a place: of those hardly deeper than the nearest, the one closest to
// it.
std::optional<std::uint32_t> pick_point(const PickView& view, const PointCloud& cloud,
                                        std::span<const std::uint32_t> indices, const Eigen::Vector2d& at_px,
                                        double reach_px);

// The same of several clouds.
struct PickedPoint {
  std::shared_ptr<const PointCloud> cloud;
  std::uint32_t index = 0;
  Eigen::Vector3d position() const { return cloud->position(index); }
};
std::optional<PickedPoint> pick_point(const PickView& view, const std::vector<PointSet>& drawn,
                                      const Eigen::Vector2d& at_px, double reach_px);

struct PickedStem {
  std::int64_t tree_id = 0;
  double depth = 0;
};
// The foremost stem that a place lies on, or passes within `reach_px` of.
std::optional<PickedStem> pick_stem(const PickView& view, const std::vector<StemShape>& stems,
                                    const Eigen::Vector2d& at_px, double reach_px);

// What is known of a point, in one line each: coordinates, height above ground, range, time, and so on.
std::vector<std::string> describe_point(const PointCloud& cloud, std::uint32_t index);

}  // namespace bole::render
