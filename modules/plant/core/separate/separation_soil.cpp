#include "plant/core/separate/separation.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr double level_angle_rad = radians(12);

}  // namespace

void Separation::find_table() {
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
    table_ = largest_plane(near, std::max(size_ / 250, 1.5 * spacing_), 0.3, Eigen::Vector3d::UnitZ(), level_angle_rad,
                           run_);
    if (table_) scene_.table_height = table_->offset;
    break;
  }
  // Without a table a layer with much below it is no soil but leaves.
  if (!table_)
    std::erase_if(layers_,
                  [&](const Layer& l) { return share_below(Eigen::Vector3d::UnitZ(), l.height, thin_) > max_below; });
}

double Separation::share_below(const Eigen::Vector3d& up, double height, const Points3& points) const {
  const auto below = std::ranges::count_if(points, [&](const auto& p) { return up.dot(p) < height - size_ / 60; });
  return static_cast<double>(below) / static_cast<double>(points.size());
}

double Separation::table_at(const Eigen::Vector3d& p) const {
  return (table_->offset - table_->normal.head<2>().dot(p.head<2>())) / table_->normal.z();
}

void Separation::find_pot_and_soil() {
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

void Separation::take_soil_of_depth(double bottom, double top) {
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

void Separation::find_level_soil(const std::optional<Eigen::Vector2d>& given) {
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
  soil_ = find_soil(level_, centre_, std::max(2 * unit_, size_ / 10), height - 4 * tolerance_, height + 4 * tolerance_,
                    1.6 * tolerance_);
  if (soil_) scene_.soil_source = layers_.size() > 1 ? "plane" : "table";
}

void Separation::soil_from_lowest(double bottom) {
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

}  // namespace bole::plant
