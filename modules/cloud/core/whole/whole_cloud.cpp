#include "cloud/core/whole/whole_cloud.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace bole {
inline namespace cloud {
namespace {

std::string place_text(const Eigen::Vector3d& p) { return fmt::format("{:.17g} {:.17g} {:.17g}", p.x(), p.y(), p.z()); }

std::optional<Eigen::Vector3d> place_of(const Facts& facts, const FactInfo& info) {
  const auto text = fact_text(facts, info);
  if (!text) return std::nullopt;
  std::istringstream in(*text);
  in.imbue(std::locale::classic());
  Eigen::Vector3d p;
  if (!(in >> p.x() >> p.y() >> p.z()) || !p.allFinite()) return std::nullopt;
  return p;
}

}  // namespace

std::optional<WholeCloud> whole_of(const Facts& facts) {
  const auto origin = place_of(facts, facts::whole_origin), low = place_of(facts, facts::whole_low);
  if (!origin || !low) return std::nullopt;
  return WholeCloud{*origin, *low};
}

std::optional<double> spacing_of_whole(const Facts& facts) {
  return whole_of(facts) ? fact_number(facts, facts::whole_spacing) : std::nullopt;
}

void set_whole(Facts& facts, const WholeCloud& whole, double spacing_m) {
  set_fact(facts, facts::whole_origin, place_text(whole.origin));
  set_fact(facts, facts::whole_low, place_text(whole.low));
  set_fact(facts, facts::whole_spacing, spacing_m);
}

void forget_whole(Facts& facts) {
  for (const auto* info : {&facts::whole_origin, &facts::whole_low, &facts::whole_spacing})
    facts.erase(std::string(info->key));
}

Eigen::Vector3d grid_anchor(const PointCloud& cloud, const Run& run) {
  // The difference of the origins is added: where both are the same, the offsets are those of the whole to the bit.
  if (const auto whole = whole_of(cloud.facts)) return whole->low + (whole->origin - cloud.origin);
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  const auto& positions = cloud.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (positions[i].allFinite()) low = low.cwiseMin(positions[i]);
  }
  return low.cast<double>();
}

Eigen::Vector2d aligned_corner(const Eigen::Vector2d& low, const Eigen::Vector2d& anchor, double cell_m) {
  return anchor.array() + ((low - anchor).array() / cell_m).floor() * cell_m;
}

}  // namespace cloud
}  // namespace bole
