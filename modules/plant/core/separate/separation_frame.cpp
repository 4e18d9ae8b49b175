#include "plant/core/separate/separation.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "base/angles.h"
#include "cloud/voxels.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_points = 100;

std::string fact_or(const PointCloud& points, const Trajectory* poses, std::string_view key) {
  if (const auto it = points.facts.find(key); it != points.facts.end()) return it->second;
  if (poses != nullptr)
    if (const auto it = poses->facts.find(key); it != poses->facts.end()) return it->second;
  return {};
}

// Middles of small cubes: the shape of the scene without its density.
Points3 thinned_by(const Points3& points, double cell) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) order.emplace_back(voxel_key(points[i], cell), i);
  std::ranges::sort(order);
  Points3 out;
  for (std::size_t i = 0; i < order.size();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t end = i;
    for (; end < order.size() && order[end].first == order[i].first; ++end) sum += points[order[end].second];
    out.push_back(sum / static_cast<double>(end - i));
    i = end;
  }
  return out;
}

}  // namespace

std::vector<double> numbers_of(const std::string& text, std::size_t count, const char* option) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  std::vector<double> out;
  for (double v = 0; in >> v;) out.push_back(v);
  if (out.size() != count || !in.eof() || !std::ranges::all_of(out, [](double v) { return std::isfinite(v); }))
    throw bad_input("the option " + std::string(option) + " is '" + text + "'", std::to_string(count) + " numbers");
  return out;
}

void Separation::take_points() {
  std::vector<double> box;
  if (!options_.box.empty()) {
    box = numbers_of(options_.box, 6, "box");
    for (std::size_t k = 0; k < 3; ++k)
      if (!(box[k] < box[k + 3]))
        throw bad_input("the option box is '" + options_.box + "'", "minimum before maximum on each axis");
  }
  for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
    const Eigen::Vector3d p = cloud_.position(i);
    if (!p.allFinite()) continue;
    if (!box.empty() &&
        (p.x() < box[0] || p.y() < box[1] || p.z() < box[2] || p.x() > box[3] || p.y() > box[4] || p.z() > box[5]))
      continue;
    index_.push_back(i);
    points_.push_back(p);
  }
  if (points_.size() < min_points)
    throw bad_input("the cloud has " + std::to_string(points_.size()) + " points" + (box.empty() ? "" : " in the box"),
                    "at least " + std::to_string(min_points), "check the reconstruction, or the option box");
  size_ = scene_size(points_);
  if (!(size_ > 0)) throw bad_input("all points of the cloud lie at one place", "a plant");
}

void Separation::find_scale() {
  const auto source = fact_or(cloud_, poses_, "scale_source");
  const auto axes = fact_or(cloud_, poses_, "world_axes");
  auto& known = scene_.scale_known;
  switch (options_.scale) {
    case ScaleChoice::metres:
      known = true;
      break;
    case ScaleChoice::unknown:
      known = false;
      break;
    case ScaleChoice::automatic:
      known = source != "unknown" && source != "none" &&
              (!source.empty() || axes == "board" || axes == "given" || depth_camera_);
  }
  // Lengths of a seedling in the unit of the cloud: where that is unknown, by the size of the scene.
  unit_ = known ? 0.02 : size_ / 25;
  spacing_ = point_spacing(points_);
  tolerance_ = std::max(known ? options_.tolerance : size_ / 200, 1.5 * spacing_);
  if (!known)
    report_.find(Severity::look, "plant_scale_unknown",
                 "The scale of the cloud is unknown: traits are in thousandths of its unit, not in millimetres. Use "
                 "a board (mat.json), a depth camera, or set scale=metres.");
  else if (size_ > 20 || size_ < 0.01)
    report_.find(Severity::look, "plant_scale_odd",
                 "The scene is " + number_text(size_) + " m across, which no potted seedling is: check the unit.");
}

void Separation::find_up() {
  const auto axes = fact_or(cloud_, poses_, "world_axes");
  const auto set = [&](const Eigen::Vector3d& up, const char* source) {
    scene_.up = up;
    scene_.up_source = source;
  };
  switch (options_.up) {
    case UpChoice::x:
      set(Eigen::Vector3d::UnitX(), "option");
      break;
    case UpChoice::y:
      set(Eigen::Vector3d::UnitY(), "option");
      break;
    case UpChoice::z:
      set(Eigen::Vector3d::UnitZ(), "option");
      break;
    case UpChoice::minus_y:
      set(-Eigen::Vector3d::UnitY(), "option");
      break;
    case UpChoice::automatic:
      if (axes == "board") {
        set(Eigen::Vector3d::UnitZ(), "board");
      } else if (const auto up = up_of_plane()) {
        set(*up, "plane");
      } else {
        set(Eigen::Vector3d::UnitZ(), "assumed");
        report_.find(Severity::look, "plant_up_assumed",
                     "No table, mat or soil was found that shows which way is up: z is taken. Check it, or set up.");
      }
  }
  to_level_ = levelling(scene_.up);
  level_.reserve(points_.size());
  for (const auto& p : points_) level_.push_back(to_level_ * p);
  thin_ = thinned_by(level_, std::max(spacing_, size_ / 300));
}

Points3 Separation::widest_view() const {
  if (depth_surface_ == nullptr) return thinned_by(points_, std::max(spacing_, size_ / 300));
  Points3 points;
  points.reserve(depth_surface_->size());
  for (std::size_t i = 0; i < depth_surface_->size(); ++i) points.push_back(depth_surface_->position(i));
  return thinned_by(points, std::max(spacing_, size_ / 300));
}

std::optional<Eigen::Vector3d> Separation::up_of_plane() {
  const auto thin = widest_view();
  std::optional<Eigen::Vector3d> near;
  Eigen::Vector3d up_of_cameras = Eigen::Vector3d::Zero(), place = Eigen::Vector3d::Zero();
  if (poses_ != nullptr && !poses_->empty()) {
    for (const auto& pose : poses_->poses) {
      up_of_cameras -= pose.T_target_sensor.linear().col(1);
      place += pose.T_target_sensor.translation();
    }
    place /= static_cast<double>(poses_->poses.size());
    if (up_of_cameras.norm() > 0.3 * static_cast<double>(poses_->poses.size())) near = up_of_cameras.normalized();
  }
  const auto plane = largest_plane(thin, std::max(size_ / 200, 2 * spacing_), 0.06, near, radians(65), run_);
  if (!plane) return std::nullopt;
  double side = 0;
  if (near) {
    side = plane->normal.dot(place) - plane->offset;
  } else {
    for (const auto& p : thin) {
      const double d = plane->normal.dot(p) - plane->offset;
      if (std::abs(d) > size_ / 100) side += d > 0 ? 1 : -1;
    }
  }
  const Eigen::Vector3d up = side < 0 ? Eigen::Vector3d(-plane->normal) : plane->normal;
  // A leaf is flat too, but what lies below a table or the soil is next to nothing.
  const double offset = side < 0 ? -plane->offset : plane->offset;
  if (share_below(up, offset, thin) > max_below) return std::nullopt;
  return up;
}

}  // namespace bole::plant
