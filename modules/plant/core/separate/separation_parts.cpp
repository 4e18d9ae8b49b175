#include "plant/core/separate/separation.h"

#include <algorithm>
#include <cmath>

namespace bole::plant {

Part Separation::part_of(const Eigen::Vector3d& p) const {
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
    if (scene_.soil_source == "plane" && p.z() < soil_->height) return table_ && near_table(p) ? Part::mat : Part::pot;
  }
  if (table_) {
    if (near_table(p)) return Part::mat;
    if (p.z() < table_at(p)) return Part::floater;
  }
  return Part::plant;
}

bool Separation::near_table(const Eigen::Vector3d& p) const {
  return std::abs(p.z() - table_at(p)) <= std::max(1.6 * tolerance_, 3 * table_->sigma);
}

void Separation::label() {
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
    throw bad_input("only " + std::to_string(candidates.size()) + " points stand above soil, pot and table", "a plant",
                    "check the reconstruction, up and box");
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

void Separation::place_base(double link) {
  if (given_base_) {
    base_ = *given_base_;
    scene_.base_source = "option";
    scene_.base_sd = tolerance_;
  } else if (const auto found = find_base(plant_, centre_, soil_->at(centre_), unit_, link)) {
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

}  // namespace bole::plant
