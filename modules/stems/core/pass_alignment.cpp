#include "stems/core/pass_alignment.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "stems/core/circle_fit.h"

namespace bole {
namespace {

constexpr double step_s = 1.0;       // of the tables
constexpr double bandwidth_s = 6.0;  // poses of SLAM drift within seconds
constexpr double as_good_as = 4;     // sightings that the mean of the pass counts for, against those near in time
constexpr double spread_m = 0.01;    // of the sightings of one moment
constexpr int rounds = 20;

// Weighted mean of values by time, drawn towards `centre`.
Eigen::Vector2d near_in_time(const std::vector<std::pair<double, Eigen::Vector2d>>& values, double time,
                             const Eigen::Vector2d& centre) {
  double weight = as_good_as;
  Eigen::Vector2d sum = as_good_as * centre;
  for (const auto& [t, v] : values) {
    const double u = (t - time) / bandwidth_s;
    if (std::abs(u) > 4) continue;
    const double w = std::exp(-0.5 * u * u) * tukey_weight((v - centre).norm() / (3 * spread_m));
    weight += w, sum += w * v;
  }
  return sum / weight;
}

Eigen::Vector2d middle(const std::vector<std::pair<double, Eigen::Vector2d>>& values) {
  std::vector<double> x, y;
  for (const auto& [t, v] : values) x.push_back(v.x()), y.push_back(v.y());
  return {median_of(x), median_of(y)};
}

// Puts every stem where most of its sightings agree, given the displacements.
void move_stems(const std::vector<PassSighting>& sightings, const std::vector<Eigen::Vector2d>& shift,
                std::map<int, Eigen::Vector2d>& place) {
  std::map<int, std::pair<Eigen::Vector2d, double>> sums;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const Eigen::Vector2d v = sightings[i].offset - shift[i];
    auto& [sum, weight] = sums.try_emplace(sightings[i].stem, Eigen::Vector2d::Zero(), 0).first->second;
    const double w = 0.01 + tukey_weight((v - place[sightings[i].stem]).norm() / (3 * spread_m));
    sum += w * v, weight += w;
  }
  for (const auto& [stem, sum] : sums) place[stem] = sum.first / sum.second;
}

}  // namespace

PassAlignment::PassAlignment(const std::vector<PassSighting>& sightings) {
  if (sightings.empty()) return;
  std::vector<Eigen::Vector2d> shift(sightings.size(), Eigen::Vector2d::Zero());
  std::map<int, Eigen::Vector2d> place;  // of each stem, less where it was put
  std::map<std::int32_t, std::vector<std::pair<double, Eigen::Vector2d>>> by_pass;
  for (int round = 0; round < rounds; ++round) {
    by_pass.clear();
    for (const auto& s : sightings)
      by_pass[s.pass].emplace_back(s.time_s, s.offset - place.try_emplace(s.stem, 0, 0).first->second);
    std::map<std::int32_t, Eigen::Vector2d> of_pass;
    for (const auto& [pass, values] : by_pass) of_pass[pass] = middle(values);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      const auto& s = sightings[i];
      shift[i] = near_in_time(by_pass[s.pass], s.time_s, of_pass[s.pass]);
      mean += shift[i] / static_cast<double>(sightings.size());
    }
    for (std::size_t i = 0; i < sightings.size(); ++i) shift[i] -= mean;
    move_stems(sightings, shift, place);
  }
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& d : shift) mean += d / static_cast<double>(shift.size());
  for (const auto& d : shift) rms_m_ += (d - mean).squaredNorm() / (2 * static_cast<double>(shift.size()));
  rms_m_ = std::sqrt(rms_m_);
  for (const auto& [pass, values] : by_pass) {
    const auto [first, last] = std::ranges::minmax_element(values, {}, &std::pair<double, Eigen::Vector2d>::first);
    Table table{first->first, {}};
    const Eigen::Vector2d centre = middle(values);
    for (double t = first->first; table.shift.empty() || t < last->first + step_s; t += step_s)
      table.shift.push_back(near_in_time(values, t, centre) - mean);
    tables_.emplace(pass, std::move(table));
  }
}

Eigen::Vector2d PassAlignment::at(std::int32_t pass, double time_s) const {
  const auto found = tables_.find(pass);
  if (found == tables_.end()) return Eigen::Vector2d::Zero();
  const auto& [first, shift] = found->second;
  const double last = static_cast<double>(shift.size() - 1);
  const double at = std::isfinite(time_s) ? std::clamp((time_s - first) / step_s, 0.0, last) : 0;
  const auto k = std::min(static_cast<std::size_t>(at), shift.size() - 1), next = std::min(k + 1, shift.size() - 1);
  return shift[k] + (at - static_cast<double>(k)) * (shift[next] - shift[k]);
}

PointCloud aligned(const PointCloud& points, const PassAlignment& alignment) {
  const auto* pass = points.has(arrays::pass) ? &points.values<std::int32_t>(arrays::pass) : nullptr;
  const auto* time = points.has(arrays::time) ? &points.values<double>(arrays::time) : nullptr;
  const bool rays = points.has(arrays::sensor_x) && points.has(arrays::sensor_y);
  auto positions = points.positions();
  auto x = rays ? points.values<float>(arrays::sensor_x) : std::vector<float>(),
       y = rays ? points.values<float>(arrays::sensor_y) : std::vector<float>();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size()), [&](const auto& block) {
    for (auto i = block.begin(); i != block.end(); ++i) {
      const Eigen::Vector2f d = alignment.at(pass ? (*pass)[i] : 0, time ? (*time)[i] : 0).template cast<float>();
      positions[i].template head<2>() -= d;
      if (rays) x[i] -= d.x(), y[i] -= d.y();
    }
  });
  PointCloud out = points;
  out.set_positions(std::move(positions));
  if (rays) out.set_column(arrays::sensor_x, std::move(x)), out.set_column(arrays::sensor_y, std::move(y));
  return out;
}

}  // namespace bole
