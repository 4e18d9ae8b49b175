// The steps of separate(), in order, and what they hand on: the frame (separation_frame.cpp), table, pot and soil
// (separation_soil.cpp), the parts (separation_parts.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plant/core/separate/find_pot.h"
#include "plant/core/separate/level_surfaces.h"
#include "plant/core/separate/plant_parts.h"
#include "plant/core/separate/point_grid.h"
#include "plant/core/separate/separate.h"

namespace bole::plant {

// The numbers of an option that holds `count` of them. Throws Error{bad_input}.
std::vector<double> numbers_of(const std::string& text, std::size_t count, const char* option);

constexpr double max_below = 0.05;  // share of the points below what they stand on

class Separation {
 public:
  Separation(const PointCloud& cloud, const Trajectory* poses, bool depth_camera, const SeparateOptions& options,
             const Run& run, const PointCloud* depth_surface)
      : cloud_(cloud),
        poses_(poses),
        depth_camera_(depth_camera),
        options_(options),
        run_(run),
        depth_surface_(depth_surface) {}

  Separated all();

 private:
  // Points, scale and the way up.
  void take_points();
  void find_scale();
  void find_up();
  // The depth surface, if there is one: a field leaves most of the table out.
  Points3 widest_view() const;
  // Out of the largest plane, to the side of the cameras, or of most points where they are unknown.
  std::optional<Eigen::Vector3d> up_of_plane();

  // Below the plant.
  // The table is the lowest wide level layer, with next to nothing below it.
  void find_table();
  double share_below(const Eigen::Vector3d& up, double height, const Points3& points) const;
  double table_at(const Eigen::Vector3d& p) const;
  void find_pot_and_soil();
  void take_soil_of_depth(double bottom, double top);
  // Without a pot: the highest level layer that holds a tenth of the widest, or the table itself.
  void find_level_soil(const std::optional<Eigen::Vector2d>& given);
  void soil_from_lowest(double bottom);

  // Every point its part.
  Part part_of(const Eigen::Vector3d& p) const;
  bool near_table(const Eigen::Vector3d& p) const;
  void label();
  void place_base(double link);

  Separated finished();

  const PointCloud& cloud_;
  const Trajectory* poses_;
  bool depth_camera_;
  const SeparateOptions& options_;
  const Run& run_;
  const PointCloud* depth_surface_;

  Report report_;
  PlantScene scene_;
  std::vector<std::uint32_t> index_;  // of points_ in the cloud
  Points3 points_, level_, thin_, plant_;
  double size_ = 0, unit_ = 0, spacing_ = 0, tolerance_ = 0;
  Eigen::Matrix3d to_level_ = Eigen::Matrix3d::Identity();
  std::vector<Layer> layers_;
  std::optional<FoundPlane> table_;
  std::optional<FoundPot> pot_;
  std::optional<FoundSoil> soil_;
  std::optional<Eigen::Vector3d> given_base_;
  Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
  Eigen::Vector3d base_ = Eigen::Vector3d::Zero();
  std::vector<std::int32_t> part_;
  PlantParts parts_;
};

}  // namespace bole::plant
