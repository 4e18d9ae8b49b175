#include "plant/core/separate/separate.h"

#include <algorithm>
#include <cmath>

#include "plant/core/separate/separation.h"

namespace bole::plant {

Separated Separation::all() {
  take_points();
  find_scale();
  find_up();
  find_table();
  find_pot_and_soil();
  label();
  return finished();
}

Separated Separation::finished() {
  const Eigen::Matrix3d back = to_level_.transpose();
  const Eigen::Vector2d slope = soil_->slope_at(base_.head<2>());
  const Eigen::Vector3d normal = Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
  scene_.soil_normal = back * normal;
  scene_.soil_offset = normal.dot(base_);
  scene_.base = back * base_;
  // Cells near one another share their errors: nine of them count as one. The soil next to the stem is seen worst.
  const double independent = std::max(1.0, static_cast<double>(soil_->cells) / 9);
  const double nearby = soil_->sigma / std::sqrt(3.0);
  scene_.soil_sd = std::hypot(soil_->sigma / std::sqrt(independent), 0.5 * nearby);
  if (pot_) {
    scene_.pot_rim = back * Eigen::Vector3d(pot_->centre.x(), pot_->centre.y(), pot_->rim_height);
    scene_.pot_foot = back * Eigen::Vector3d(pot_->centre.x(), pot_->centre.y(), pot_->foot_height);
    scene_.rim_radius = pot_->rim_radius;
    scene_.foot_radius = pot_->foot_radius;
  }
  Separated out;
  out.points = cloud_;
  out.points.set_column(part_column, Column(part_));
  put_scene(out.points.facts, scene_);
  if (options_.drop_floaters) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < part_.size(); ++i)
      if (part_[i] != static_cast<std::int32_t>(Part::floater)) kept.push_back(i);
    out.points = out.points.subset(kept);
  }
  for (int p = 0; p < 6; ++p)
    report_.counts[std::string(choice_name(static_cast<Part>(p)))] = std::ranges::count(part_, p);
  report_.metrics["soil_sd"] = {1000 * scene_.soil_sd, Unit::millimetre};
  report_.metrics["spacing"] = {1000 * spacing_, Unit::millimetre};
  if (pot_) report_.metrics["rim_radius"] = {1000 * pot_->rim_radius, Unit::millimetre};
  if (parts_.soil_gap > std::max(2 * options_.max_gap, unit_) && parts_.soil_gap < 1e6)
    report_.find(Severity::look, "plant_above_soil",
                 "The plant begins " + number_text(std::round(1e4 * parts_.soil_gap) / 10) +
                     " mm above the soil: the lower stem is missing in the cloud.");
  report_.facts["up"] = scene_.up_source;
  report_.facts["soil"] = scene_.soil_source;
  report_.facts["base"] = scene_.base_source;
  report_.message = std::to_string(report_.counts["plant"]) + " points of the plant, " +
                    std::to_string(report_.counts["floater"]) + " floaters";
  out.scene = scene_;
  out.report = std::move(report_);
  return out;
}

Separated separate(const PointCloud& points, const Trajectory* poses, bool depth_camera, const SeparateOptions& options,
                   const Run& run, const PointCloud* depth_surface) {
  return Separation(points, poses, depth_camera, options, run, depth_surface).all();
}

}  // namespace bole::plant
