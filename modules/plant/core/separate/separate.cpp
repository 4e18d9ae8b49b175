#include "plant/core/separate/separate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/arrays.h"
#include "base/statistics.h"
#include "cloud/voxels.h"
#include "plant/core/separate/find_pot.h"
#include "plant/core/separate/level_surfaces.h"
#include "plant/core/separate/plant_parts.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_points = 100;
constexpr double max_below = 0.05;  // share of the points below what they stand on
constexpr double level_angle_rad = 12 * std::numbers::pi / 180;

std::vector<double> numbers_of(const std::string& text, std::size_t count, const char* option) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  std::vector<double> out;
  for (double v = 0; in >> v;) out.push_back(v);
  if (out.size() != count || !in.eof() || !std::ranges::all_of(out, [](double v) { return std::isfinite(v); }))
    throw bad_input("the option " + std::string(option) + " is '" + text + "'", std::to_string(count) + " numbers");
  return out;
}

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

  Separated all() {
    take_points();
    find_scale();
    find_up();
    find_table();
    find_pot_and_soil();
    label();
    return finished();
  }

 private:
  void take_points() {
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
      throw bad_input(
          "the cloud has " + std::to_string(points_.size()) + " points" + (box.empty() ? "" : " in the box"),
          "at least " + std::to_string(min_points), "check the reconstruction, or the option box");
    size_ = scene_size(points_);
    if (!(size_ > 0)) throw bad_input("all points of the cloud lie at one place", "a plant");
  }

  void find_scale() {
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

  void find_up() {
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

  // The depth surface, if there is one: a field leaves most of the table out.
  Points3 widest_view() const {
    if (depth_surface_ == nullptr) return thinned_by(points_, std::max(spacing_, size_ / 300));
    Points3 points;
    points.reserve(depth_surface_->size());
    for (std::size_t i = 0; i < depth_surface_->size(); ++i) points.push_back(depth_surface_->position(i));
    return thinned_by(points, std::max(spacing_, size_ / 300));
  }

  // Out of the largest plane, to the side of the cameras, or of most points where they are unknown.
  std::optional<Eigen::Vector3d> up_of_plane() {
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
    const auto plane =
        largest_plane(thin, std::max(size_ / 200, 2 * spacing_), 0.06, near, 65 * std::numbers::pi / 180, run_);
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

  // The table is the lowest wide level layer, with next to nothing below it.
  void find_table() {
    layers_ = level_layers(thin_, std::max(size_ / 150, 1.5 * spacing_), size_ / 60);
    double largest = 0;
    for (const auto& l : layers_) largest = std::max(largest, l.area);
    std::erase_if(layers_, [&](const Layer& l) { return l.area < 0.1 * largest; });
    for (const auto& l : layers_) {
      if (l.area < 0.3 * largest) continue;
      if (share_below(Eigen::Vector3d::UnitZ(), l.height, thin_) > 0.03) break;
      Points3 near;
      for (const auto& p : thin_)
        if (std::abs(p.z() - l.height) < size_ / 50) near.push_back(p);
      table_ = largest_plane(near, std::max(size_ / 250, 1.5 * spacing_), 0.3, Eigen::Vector3d::UnitZ(),
                             level_angle_rad, run_);
      if (table_) scene_.table_height = table_->offset;
      break;
    }
    // Without a table a layer with much below it is no soil but leaves.
    if (!table_)
      std::erase_if(layers_,
                    [&](const Layer& l) { return share_below(Eigen::Vector3d::UnitZ(), l.height, thin_) > max_below; });
  }

  double share_below(const Eigen::Vector3d& up, double height, const Points3& points) const {
    const auto below = std::ranges::count_if(points, [&](const auto& p) { return up.dot(p) < height - size_ / 60; });
    return static_cast<double>(below) / static_cast<double>(points.size());
  }

  double table_at(const Eigen::Vector3d& p) const {
    return (table_->offset - table_->normal.head<2>().dot(p.head<2>())) / table_->normal.z();
  }

  void find_pot_and_soil() {
    double bottom = level_.front().z(), top = bottom;
    for (const auto& p : thin_) {
      bottom = std::min(bottom, p.z());
      top = std::max(top, p.z());
    }
    if (table_) bottom = table_->offset + 1.5 * tolerance_;
    PotSearch search;
    search.bottom = bottom;
    search.top = std::min(top, bottom + (scene_.scale_known ? 0.4 : top - bottom));
    search.min_radius = scene_.scale_known ? 0.02 : size_ / 40;
    search.max_radius = scene_.scale_known ? 0.25 : size_ / 2;
    search.tolerance = std::max(tolerance_, 1.5 * spacing_);
    search.slice = std::max(1.5 * tolerance_, 2 * spacing_);
    Points3 above;
    for (const auto& p : thin_)
      if (!table_ || p.z() > table_at(p) + tolerance_) above.push_back(p);
    pot_ = find_pot(above, search, run_);
    if (pot_ && table_ && pot_->foot_height > bottom + 0.06 + 0.1 * size_) pot_.reset();  // it stands on the table
    std::optional<Eigen::Vector2d> given;
    if (!options_.base.empty()) {
      const auto v = numbers_of(options_.base, 3, "base");
      given_base_ = to_level_ * Eigen::Vector3d(v[0], v[1], v[2]);
      given = given_base_->head<2>();
    }
    if (pot_) {
      const double rim = pot_->rim_height, height = std::max(rim - pot_->foot_height, search.slice);
      soil_ = find_soil(level_, pot_->centre, 0.86 * pot_->rim_radius, rim - 0.7 * height, rim + 0.2 * height,
                        1.6 * tolerance_);
      if (depth_surface_ != nullptr) take_soil_of_depth(rim - 0.7 * height, rim + 0.2 * height);
      centre_ = pot_->centre;
      scene_.soil_source = "pot";
    } else {
      report_.find(Severity::look, "plant_pot_not_found",
                   "No round pot was found. Heights are counted from the level surface below the plant; check the "
                   "soil, or set base.");
      find_level_soil(given);
    }
    if (given) centre_ = *given;
    if (!soil_) soil_from_lowest(bottom);
    if (given_base_ && !soil_) {
      soil_.emplace();
      soil_->centre = *given;
      soil_->height = given_base_->z();
      soil_->sigma = tolerance_;
      scene_.soil_source = "option";
    }
  }

  void take_soil_of_depth(double bottom, double top) {
    Points3 level;
    level.reserve(depth_surface_->size());
    for (std::size_t i = 0; i < depth_surface_->size(); ++i) level.push_back(to_level_ * depth_surface_->position(i));
    const auto measured = find_soil(level, pot_->centre, 0.86 * pot_->rim_radius, bottom, top, 1.6 * tolerance_);
    if (!measured) return;
    if (soil_)
      report_.metrics["soil_by_depth"] = {1000 * (measured->at(pot_->centre) - soil_->at(pot_->centre)),
                                          Unit::millimetre};
    soil_ = measured;
  }

  // Without a pot: the highest level layer that holds a tenth of the widest, or the table itself.
  void find_level_soil(const std::optional<Eigen::Vector2d>& given) {
    if (layers_.empty()) return;
    const double height = given_base_ ? given_base_->z() : layers_.back().height;
    std::vector<double> x, y;
    for (const auto& p : thin_)
      if (p.z() > height + 2 * tolerance_) {
        x.push_back(p.x());
        y.push_back(p.y());
      }
    if (x.size() < 10) return;
    centre_ = given ? *given : Eigen::Vector2d(median(x), median(y));
    soil_ = find_soil(level_, centre_, std::max(2 * unit_, size_ / 10), height - 4 * tolerance_,
                      height + 4 * tolerance_, 1.6 * tolerance_);
    if (soil_) scene_.soil_source = layers_.size() > 1 ? "plane" : "table";
  }

  void soil_from_lowest(double bottom) {
    std::vector<double> z, x, y;
    for (const auto& p : thin_) {
      if (table_ && p.z() < table_at(p) + 2 * tolerance_) continue;
      z.push_back(p.z());
      x.push_back(p.x());
      y.push_back(p.y());
    }
    if (z.empty()) throw bad_input("nothing stands above the table", "a plant");
    if (!pot_ && options_.base.empty()) centre_ = {median(x), median(y)};
    std::ranges::sort(z);
    const double low = pot_ ? pot_->rim_height : z[static_cast<std::size_t>(0.002 * static_cast<double>(z.size()))];
    soil_.emplace();
    soil_->centre = centre_;
    soil_->height = pot_ ? low : std::max(low, bottom);
    soil_->sigma = pot_ ? 0.1 * (pot_->rim_height - pot_->foot_height) : 0.01 * (z.back() - z.front());
    scene_.soil_source = "lowest_point";
    report_.find(Severity::look, "plant_soil_not_found",
                 pot_ ? "The soil in the pot was not found: heights are counted from the rim."
                      : "No soil was found: heights are counted from the lowest point of the cloud.");
  }

  Part part_of(const Eigen::Vector3d& p) const {
    const double soil_tolerance = std::max(tolerance_, std::min(3 * soil_->sigma, 3 * tolerance_));
    if (pot_) {
      const double r = (p.head<2>() - pot_->centre).norm();
      const double wall = pot_->radius_at(p.z());
      const double outer = wall + std::max(pot_->lip, 0.0) + 1.5 * tolerance_;
      const double inner = std::min(0.93 * pot_->rim_radius, wall - 3 * tolerance_);
      const double soil = soil_->at(p.head<2>());
      const bool between = p.z() > pot_->foot_height - 3 * tolerance_ && p.z() < pot_->rim_height + tolerance_;
      if (between && r < outer && r > inner) return Part::pot;
      if (r <= inner && std::abs(p.z() - soil) <= soil_tolerance) return Part::soil;
      if (r <= inner && p.z() < soil && between) return Part::pot;
    } else if (scene_.soil_source != "lowest_point") {
      const Eigen::Vector2d d = p.head<2>() - soil_->centre;
      const double radius = 14 * soil_->cell;
      if (radius > 0 && d.norm() <= radius && std::abs(p.z() - soil_->at(p.head<2>())) <= soil_tolerance)
        return Part::soil;
      if (scene_.soil_source == "plane" && p.z() < soil_->height)
        return table_ && near_table(p) ? Part::mat : Part::pot;
    }
    if (table_) {
      if (near_table(p)) return Part::mat;
      if (p.z() < table_at(p)) return Part::floater;
    }
    return Part::plant;
  }

  bool near_table(const Eigen::Vector3d& p) const {
    return std::abs(p.z() - table_at(p)) <= std::max(1.6 * tolerance_, 3 * table_->sigma);
  }

  void label() {
    part_.assign(cloud_.size(), static_cast<std::int32_t>(Part::other));
    Points3 candidates;
    std::vector<std::uint32_t> of_candidate;
    for (std::size_t k = 0; k < level_.size(); ++k) {
      const Part part = part_of(level_[k]);
      part_[index_[k]] = static_cast<std::int32_t>(part);
      if (part != Part::plant) continue;
      candidates.push_back(level_[k]);
      of_candidate.push_back(index_[k]);
    }
    if (candidates.size() < 20)
      throw bad_input("only " + std::to_string(candidates.size()) + " points stand above soil, pot and table",
                      "a plant", "check the reconstruction, up and box");
    PartSearch search;
    search.link = std::max(3 * spacing_, scene_.scale_known ? 0.0015 : size_ / 400);
    search.max_gap = scene_.scale_known ? options_.max_gap : size_ / 30;
    search.centre = centre_;
    search.reach = pot_ ? pot_->rim_radius : 0;
    search.soil_height = soil_->at(centre_);
    parts_ = plant_parts(candidates, search, run_);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Part part = parts_.kind[k] == 1 ? Part::plant : parts_.kind[k] == 2 ? Part::other : Part::floater;
      part_[of_candidate[k]] = static_cast<std::int32_t>(part);
      if (part == Part::plant) plant_.push_back(candidates[k]);
    }
    place_base(search.link);
  }

  void place_base(double link) {
    if (given_base_) {
      base_ = *given_base_;
      scene_.base_source = "option";
      scene_.base_sd = tolerance_;
    } else if (const auto found = find_base(plant_, centre_, search_soil_height(), unit_, link)) {
      base_.head<2>() = found->place;
      scene_.base_sd = found->sd;
      scene_.base_source = "found";
    } else {
      base_.head<2>() = centre_;
      scene_.base_sd = unit_;
      scene_.base_source = pot_ ? "pot_axis" : "lowest_point";
      report_.find(Severity::look, "plant_base_not_found",
                   "The cloud has no stem near the soil: the middle of the pot is taken for its foot. Set base where "
                   "that is wrong.");
    }
    if (scene_.base_source != "option" || scene_.soil_source != "option") base_.z() = soil_->at(base_.head<2>());
  }

  double search_soil_height() const { return soil_->at(centre_); }

  Separated finished() {
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

}  // namespace

Separated separate(const PointCloud& points, const Trajectory* poses, bool depth_camera, const SeparateOptions& options,
                   const Run& run, const PointCloud* depth_surface) {
  return Separation(points, poses, depth_camera, options, run, depth_surface).all();
}

}  // namespace bole::plant
