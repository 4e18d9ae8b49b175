#include "ground/core/given_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "cloud/core/regions/point_edits.h"

namespace bole::ground {

std::vector<LowPoint> given_candidates(const PointCloud& cloud, const std::vector<std::uint8_t>& given,
                                       const GridShape& shape) {
  std::map<std::uint32_t, std::pair<Eigen::Vector3d, double>> cells;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto& p = cloud.positions()[i];
    if (given[i] != ground_class || !p.allFinite()) continue;
    const int ix = std::clamp(shape.column(static_cast<double>(p.x())), 0, shape.nx - 1),
              iy = std::clamp(shape.row(static_cast<double>(p.y())), 0, shape.ny - 1);
    auto& [sum, points] =
        cells.try_emplace(static_cast<std::uint32_t>(shape.index(ix, iy)), Eigen::Vector3d::Zero(), 0.0).first->second;
    sum += p.cast<double>();
    points += 1;
  }
  std::vector<LowPoint> out;
  for (const auto& [cell, held] : cells) out.push_back({held.first / held.second, cell});
  return out;
}

FootedCandidates with_given(const FootedCandidates& found, const std::vector<LowPoint>& given) {
  FootedCandidates out;
  std::size_t next_given = 0, next_foot = 0;
  const auto put_given = [&] {
    out.feet.push_back(static_cast<std::uint32_t>(out.candidates.size()));
    out.candidates.push_back(given[next_given++]);
  };
  for (std::size_t i = 0; i < found.candidates.size(); ++i) {
    const auto cell = found.candidates[i].cell;
    while (next_given < given.size() && given[next_given].cell < cell) put_given();
    const bool foot = next_foot < found.feet.size() && found.feet[next_foot] == i;
    if (foot) ++next_foot;
    if (next_given < given.size() && given[next_given].cell == cell) {
      put_given();
      continue;
    }
    if (foot) out.feet.push_back(static_cast<std::uint32_t>(out.candidates.size()));
    out.candidates.push_back(found.candidates[i]);
  }
  while (next_given < given.size()) put_given();
  return out;
}

GroundModel model_edited_ground(const PointCloud& cloud, const std::vector<std::uint8_t>& given, const Raster* terrain,
                                const GroundOptions& options, const Run& run) {
  std::vector<std::uint32_t> kept;
  std::vector<std::uint8_t> given_of_kept;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (given[i] != noise_class) {
      kept.push_back(static_cast<std::uint32_t>(i));
      given_of_kept.push_back(given[i]);
    }
  if (kept.empty())
    throw bad_input(fmt::format("all {} points are given to noise", cloud.size()), "points of ground and trees",
                    "Undo the edits of points");
  const auto part = cloud.subset(kept);
  auto model =
      terrain != nullptr ? ground_of(part, *terrain, options, run) : model_ground(part, options, run, given_of_kept);
  std::vector<float> heights(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  std::vector<std::uint8_t> classes(cloud.size(), noise_class);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    heights[kept[k]] = model.height_above_ground[k];
    classes[kept[k]] = given_of_kept[k] != 0 ? given_of_kept[k] : model.classification[k];
  }
  model.height_above_ground = std::move(heights);
  model.classification = std::move(classes);
  auto& counts = model.report.counts;
  counts["points"] = static_cast<std::int64_t>(cloud.size());
  counts["points_given_to_noise"] = static_cast<std::int64_t>(cloud.size() - kept.size());
  counts["points_given_to_ground"] = std::ranges::count(given, ground_class);
  return model;
}

}  // namespace bole::ground
