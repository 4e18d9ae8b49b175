#include "stems/core/shared/pass_alignment.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

constexpr double bandwidth_s = 6.0;  // poses of SLAM drift within seconds
constexpr double as_good_as = 4;     // sightings that the mean of the pass counts for, against those near in time
constexpr double spread_m = 0.01;    // of the sightings of one moment
constexpr int rounds = 12;

using Moments = std::vector<std::pair<double, Eigen::Vector2d>>;  // displacements by rising time

// Weighted mean of values by time, drawn towards `centre`.
Eigen::Vector2d near_in_time(const Moments& values, double time, const Eigen::Vector2d& centre) {
  double weight = as_good_as;
  Eigen::Vector2d sum = as_good_as * centre;
  auto it = std::ranges::lower_bound(values, time - 4 * bandwidth_s, {}, &Moments::value_type::first);
  for (; it != values.end() && it->first <= time + 4 * bandwidth_s; ++it) {
    const double u = (it->first - time) / bandwidth_s;
    const double w = std::exp(-0.5 * u * u) * tukey_weight((it->second - centre).norm() / (3 * spread_m));
    weight += w, sum += w * it->second;
  }
  return sum / weight;
}

Eigen::Vector2d middle(const Moments& values) {
  std::vector<double> x, y;
  for (const auto& [t, v] : values) x.push_back(v.x()), y.push_back(v.y());
  return {upper_median(x), upper_median(y)};
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
  std::map<std::int32_t, Moments> by_pass;
  for (int round = 0; round < rounds; ++round) {
    by_pass.clear();
    for (const auto& s : sightings)
      by_pass[s.pass].emplace_back(s.time_s, s.offset - place.try_emplace(s.stem, 0, 0).first->second);
    std::map<std::int32_t, Eigen::Vector2d> of_pass;
    for (auto& [pass, values] : by_pass)
      std::ranges::stable_sort(values, {}, &Moments::value_type::first), of_pass[pass] = middle(values);
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
    Table table;
    const Eigen::Vector2d centre = middle(values);
    for (const auto& [t, v] : values)
      if (table.time_s.empty() || t > table.time_s.back())
        table.time_s.push_back(t), table.shift.push_back(near_in_time(values, t, centre) - mean);
    tables_.emplace(pass, std::move(table));
  }
}

Eigen::Vector2d PassAlignment::at(std::int32_t pass, double time_s) const {
  const auto found = tables_.find(pass);
  if (found == tables_.end()) return Eigen::Vector2d::Zero();
  const auto& [times, shift] = found->second;
  const auto next = static_cast<std::size_t>(std::ranges::lower_bound(times, time_s) - times.begin());
  if (next == 0 || !std::isfinite(time_s)) return shift.front();
  if (next == times.size()) return shift.back();
  const double share = (time_s - times[next - 1]) / (times[next] - times[next - 1]);
  return shift[next - 1] + share * (shift[next] - shift[next - 1]);
}

PointCloud aligned(const PointCloud& points, const PassAlignment& alignment, const Run& run) {
  const auto* pass = points.has(arrays::pass) ? &points.values<std::int32_t>(arrays::pass) : nullptr;
  const auto* time = points.has(arrays::time) ? &points.values<double>(arrays::time) : nullptr;
  const bool rays = points.has(arrays::sensor_x) && points.has(arrays::sensor_y);
  auto positions = points.positions();
  auto x = rays ? points.values<float>(arrays::sensor_x) : std::vector<float>(),
       y = rays ? points.values<float>(arrays::sensor_y) : std::vector<float>();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1 << 16), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) {
      const Eigen::Vector2f d = alignment.at(pass ? (*pass)[i] : 0, time ? (*time)[i] : 0).template cast<float>();
      positions[i].template head<2>() -= d;
      if (rays) x[i] -= d.x(), y[i] -= d.y();
    }
  });
  run.check_cancel();
  PointCloud out = points;
  out.set_positions(std::move(positions));
  if (rays) out.set_column(arrays::sensor_x, std::move(x)), out.set_column(arrays::sensor_y, std::move(y));
  return out;
}

}  // namespace bole::stems
