#include "cloud/first_sight.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/angles.h"
#include "base/statistics.h"
#include "base/transform.h"
#include "cloud/robust_mean.h"
#include "cloud/stem_axes.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr std::size_t max_sample = 3'000'000;
constexpr std::size_t min_points = 100;
constexpr double breast_height_m = 1.3;
constexpr double half_window_m = 0.65;  // of stem above and below breast height, as the joint fit takes it

struct Sample {
  std::vector<Eigen::Vector3f> points;  // relative to the origin of the cloud
  double each = 1;                      // how many points of the cloud one of the sample stands for
};

Sample sample_of(const PointCloud& cloud) {
  const std::size_t stride = (cloud.size() + max_sample - 1) / max_sample;
  Sample out;
  out.each = static_cast<double>(stride);
  out.points.reserve(cloud.size() / stride + 1);
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    if (cloud.positions()[i].allFinite()) out.points.push_back(cloud.positions()[i]);
  return out;
}

float quantile(std::vector<float> values, double share) {
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, rank);
  return *rank;
}

std::vector<float> coordinates(const std::vector<Eigen::Vector3f>& points, int axis) {
  std::vector<float> out;
  out.reserve(points.size());
  for (const auto& p : points) out.push_back(p[axis]);
  return out;
}

struct Range {
  float low = 0, high = 0;
  float width() const { return high - low; }
};

Range range_of(std::vector<float> values, double share_outside) {
  return {quantile(values, 0.5 * share_outside), quantile(std::move(values), 1 - 0.5 * share_outside)};
}

std::uint64_t mixed(const Eigen::Vector3f& p) {
  std::uint64_t h = 0x9E3779B97F4A7C15ULL;
  for (int axis = 0; axis < 3; ++axis) {
    h ^= std::bit_cast<std::uint32_t>(p[axis] + 0.0F);  // -0 and 0 are the same place
    h *= 0xBF58476D1CE4E5B9ULL;
    h ^= h >> 29;
  }
  return h;
}

// The points are chosen by their coordinates, not by their number, so that all points of one place are chosen together.
double duplicated_share(const PointCloud& cloud) {
  const std::uint64_t one_in = cloud.size() / max_sample + 1;
  std::vector<std::uint64_t> keys;
  keys.reserve(cloud.size() / one_in + 1);
  for (const auto& p : cloud.positions())
    if (const auto key = mixed(p); key % one_in == 0) keys.push_back(key);
  if (keys.empty()) return 0;
  std::ranges::sort(keys);
  const auto places = std::distance(keys.begin(), std::unique(keys.begin(), keys.end()));
  return 1 - static_cast<double>(places) / static_cast<double>(keys.size());
}

// Lowest and highest points per square cell of the plan.
class CellHeights {
 public:
  CellHeights(const std::vector<Eigen::Vector3f>& points, double cell_m) : cell_m_(cell_m) {
    for (const auto& p : points) {
      auto& cell = cells_[key(index(p.x()), index(p.y()))];
      cell.low = std::min(cell.low, p.z());
      cell.high = std::max(cell.high, p.z());
      ++cell.count;
    }
  }

  std::size_t size() const { return cells_.size(); }
  double area_m2() const { return static_cast<double>(size()) * cell_m_ * cell_m_; }

  // The lowest point of the cells around a place. NaN where there are none.
  float low_around(double x, double y, int cells) const {
    float low = std::numeric_limits<float>::infinity();
    for (int dy = -cells; dy <= cells; ++dy)
      for (int dx = -cells; dx <= cells; ++dx)
        if (const auto* c = find(index(x) + dx, index(y) + dy)) low = std::min(low, c->low);
    return std::isinf(low) ? std::numeric_limits<float>::quiet_NaN() : low;
  }

  // The median of the lowest points of the cells around, so that a stray point below does not count.
  double ground_around(double x, double y, int cells) const {
    std::vector<double> lows;
    for (int dy = -cells; dy <= cells; ++dy)
      for (int dx = -cells; dx <= cells; ++dx)
        if (const auto* c = find(index(x) + dx, index(y) + dy)) lows.push_back(static_cast<double>(c->low));
    return upper_median(std::move(lows));
  }

  // Share of the cells whose height lies on the straight line between the heights on both sides: a surface that goes
  // on, whatever its slope.
  double continuing_share(bool top) const {
    constexpr double tolerance_m = 0.15;
    std::size_t checked = 0, continuing = 0;
    const auto height = [top](const Cell& c) { return top ? c.high : c.low; };
    for (const auto& [k, c] : cells_) {
      const auto [ix, iy] = place(k);
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
        const auto *before = find(ix - dx, iy - dy), *after = find(ix + dx, iy + dy);
        if (before == nullptr || after == nullptr) continue;
        ++checked;
        if (std::abs(height(c) - 0.5F * (height(*before) + height(*after))) < tolerance_m) ++continuing;
      }
    }
    constexpr std::size_t min_checked = 20;
    return checked < min_checked ? 0 : static_cast<double>(continuing) / static_cast<double>(checked);
  }

 private:
  struct Cell {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    std::uint32_t count = 0;
  };
  int index(double v) const { return static_cast<int>(std::floor(std::clamp(v / cell_m_, -1e9, 1e9))); }
  static std::uint64_t key(int ix, int iy) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(ix)) << 32 | static_cast<std::uint32_t>(iy);
  }
  static std::pair<int, int> place(std::uint64_t key) {
    return {static_cast<int>(static_cast<std::uint32_t>(key >> 32)), static_cast<int>(static_cast<std::uint32_t>(key))};
  }
  const Cell* find(int ix, int iy) const {
    const auto it = cells_.find(key(ix, iy));
    return it == cells_.end() ? nullptr : &it->second;
  }

  double cell_m_;
  std::unordered_map<std::uint64_t, Cell> cells_;
};

// Cells of a metre, larger where a cloud is so wide or so sparse that few of them would hold points.
double cell_size_m(const std::vector<Eigen::Vector3f>& points, int axis) {
  double area = 1;
  for (int a = 0; a < 3; ++a)
    if (a != axis) area *= std::max(0.01F, range_of(coordinates(points, a), 0.002).width());
  constexpr double points_per_cell = 4;
  return std::max(1.0, std::sqrt(points_per_cell * area / static_cast<double>(points.size())));
}

Eigen::Vector3f z_up(const Eigen::Vector3f& p, int up) {
  if (up == 1) return {p.x(), -p.z(), p.y()};
  if (up == 0) return {-p.z(), p.y(), p.x()};
  return p;
}

AxisEvidence evidence_for(const std::vector<Eigen::Vector3d>& thinned_points, const Sample& sample, int axis,
                          const Run& run) {
  AxisEvidence out;
  constexpr double max_lean_deg = 25;
  for (const auto& s : find_stem_axes(thinned_points, Eigen::Vector3d::Unit(axis), radians(max_lean_deg), run)) {
    ++out.stems;
    out.stem_metres += s.length_m;
  }
  std::vector<Eigen::Vector3f> turned;
  turned.reserve(sample.points.size());
  for (const auto& p : sample.points) turned.push_back(z_up(p, axis));
  const CellHeights cells(turned, cell_size_m(turned, 2));
  out.ground_seen = cells.continuing_share(false);
  out.top_continues = cells.continuing_share(true);
  return out;
}

// An axis with several stems along it and next to none along the others.
std::optional<int> upright_axis(const std::array<AxisEvidence, 3>& along) {
  constexpr std::size_t min_stems = 3;
  constexpr double min_metres = 8, times_the_next = 4;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& e = along[static_cast<std::size_t>(axis)];
    double next = 0;
    for (int other = 0; other < 3; ++other)
      if (other != axis) next = std::max(next, along[static_cast<std::size_t>(other)].stem_metres);
    if (e.stems >= min_stems && e.stem_metres >= min_metres && e.stem_metres > times_the_next * next &&
        e.ground_seen >= e.top_continues)
      return axis;
  }
  return {};
}

// One stem, and nothing beside its foot.
bool is_single_tree(const std::vector<Eigen::Vector3f>& points) {
  const auto z = coordinates(points, 2);
  const float bottom = quantile(z, 0.001), top = quantile(z, 0.999);
  constexpr float foot_m = 0.3F, trunk_from_m = 0.5F, trunk_to_m = 2.0F;
  if (top - bottom < trunk_to_m) return false;
  std::vector<Eigen::Vector3f> foot, trunk;
  for (const auto& p : points) {
    if (p.z() < bottom + foot_m) foot.push_back(p);
    if (p.z() > bottom + trunk_from_m && p.z() < bottom + trunk_to_m) trunk.push_back(p);
  }
  constexpr std::size_t min_foot = 10, min_trunk = 30;
  if (foot.size() < min_foot || trunk.size() < min_trunk) return false;
  constexpr double outside = 0.05;
  constexpr float max_foot_m = 1.2F, max_trunk_m = 2.5F;
  Eigen::Vector2f middle;
  for (int axis = 0; axis < 2; ++axis) {
    const auto range = range_of(coordinates(foot, axis), outside);
    if (range.width() > max_foot_m) return false;
    middle[axis] = 0.5F * (range.low + range.high);
  }
  const auto at_foot = std::ranges::count_if(trunk, [&](const Eigen::Vector3f& p) {
    return (p.head<2>() - middle).cwiseAbs().maxCoeff() < 0.5F * max_trunk_m;
  });
  constexpr double min_share = 0.75;
  return static_cast<double>(at_foot) > min_share * static_cast<double>(trunk.size());
}

// A circle by least squares of the algebraic distance (Kasa), points far off it left out step by step.
struct RoughCircle {
  double radius_m = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> points;  // on it
};

RoughCircle rough_circle(std::vector<Eigen::Vector2d> points) {
  RoughCircle out;
  constexpr int rounds = 8;
  constexpr std::size_t min_on_circle = 5;
  for (int round = 0; round < rounds; ++round) {
    if (points.size() < min_on_circle) break;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& p : points) {
      const Eigen::Vector3d row(p.x(), p.y(), 1);
      normal += row * row.transpose();
      right += p.squaredNorm() * row;
    }
    const Eigen::Vector3d s = normal.ldlt().solve(right);
    const Eigen::Vector2d centre = 0.5 * s.head<2>();
    const double radius = std::sqrt(std::max(0.0, s.z() + centre.squaredNorm()));
    std::vector<double> off;
    for (const auto& p : points) off.push_back(std::abs((p - centre).norm() - radius));
    const double limit = std::max(0.02, 3 * upper_median(std::vector(off)));
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (off[i] <= limit) kept.push_back(points[i]);
    out.radius_m = radius;
    out.centre = centre;
    const bool settled = kept.size() == points.size();
    points = std::move(kept);
    if (settled) break;
  }
  out.points = std::move(points);
  return out;
}

// Two copies of a stem, a step s apart towards the bearing b, lie on one circle with residuals of +-s/2 cos(t - b) at
// the bearing t: their squares rise and fall with 2 t, by s^2/8, and at the faces they come in two groups. Noise, oval
// stems and displacements that differ from stem to stem do neither.
void see_doubled_walls(const std::vector<RoughCircle>& circles, FirstSight& out) {
  constexpr std::size_t min_circles = 5, min_on_circle = 30, min_pooled = 300;
  std::vector<double> cosines, sines;
  for (const auto& c : circles) {
    if (c.points.size() < min_on_circle) continue;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& p : c.points) {
      const Eigen::Vector2d off = p - c.centre;
      const double t = std::atan2(off.y(), off.x()), residual = off.norm() - c.radius_m;
      const Eigen::Vector3d row(1, std::cos(2 * t), std::sin(2 * t));
      normal += row * row.transpose();
      right += residual * residual * row;
    }
    const Eigen::Vector3d s = normal.ldlt().solve(right);
    cosines.push_back(s.y());
    sines.push_back(s.z());
  }
  if (cosines.size() < min_circles) return;
  const double b = median(std::move(cosines)), c = median(std::move(sines));
  const double step_m = std::sqrt(8 * std::hypot(b, c)), direction = 0.5 * std::atan2(c, b);
  std::vector<double> faces, flanks;  // distances from the circles
  for (const auto& circle : circles)
    for (const auto& p : circle.points) {
      const Eigen::Vector2d off = p - circle.centre;
      const double along = std::abs(std::cos(std::atan2(off.y(), off.x()) - direction));
      const double distance = std::abs(off.norm() - circle.radius_m);
      if (distance > step_m) continue;  // no bark
      if (along > 0.8) faces.push_back(distance);
      if (along < 0.3) flanks.push_back(distance);
    }
  constexpr double min_step_m = 0.02;
  if (step_m < min_step_m || faces.size() < min_pooled || flanks.size() < min_pooled) return;
  // Between two walls there is little: one bell has 0.3 and more of its points there.
  constexpr double times_flanks = 1.5, middle_of_step = 0.2, max_in_middle = 0.22;
  const auto in_middle = std::ranges::count_if(faces, [&](double d) { return d < middle_of_step * step_m; });
  const double middle_share = static_cast<double>(in_middle) / static_cast<double>(faces.size());
  const double ratio = median(std::move(faces)) / median(std::move(flanks));
  if (middle_share > max_in_middle || ratio < times_flanks) return;
  out.doubled_by_m = step_m;
  out.doubled_bearing_deg = std::fmod(90 - degrees(direction) + 360, 180);
}

// `ground_z`: where the ground is not seen, as under the crown of a tree that was cut out.
void see_stems(const std::vector<StemAxis>& axes, const Sample& sample, const CellHeights& cells,
               std::optional<double> ground_z, FirstSight& out) {
  constexpr double reach_m = 0.6, grid_m = 2;
  struct Stem {
    StemAxis axis;
    double breast_height_z;
    std::vector<Eigen::Vector2d> around;
  };
  std::vector<Stem> stems;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> near;
  const auto square = [](double x, double y) {
    return static_cast<std::int64_t>(std::floor(x / grid_m)) * 4'000'000 +
           static_cast<std::int64_t>(std::floor(y / grid_m));
  };
  for (const auto& a : axes) {
    // The foot of the axis, found from the ground below its middle.
    Eigen::Vector3d foot = a.middle;
    for (int round = 0; round < 2; ++round) {
      const double ground = ground_z ? *ground_z : cells.ground_around(foot.x(), foot.y(), 1);
      if (std::isnan(ground)) break;
      foot = a.middle + a.direction * ((ground - a.middle.z()) / a.direction.z());
    }
    Stem stem{a, foot.z() + breast_height_m, {}};
    stem.axis.middle = foot + a.direction * (breast_height_m / a.direction.z());
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        near[square(stem.axis.middle.x() + dx * grid_m, stem.axis.middle.y() + dy * grid_m)].push_back(stems.size());
    stems.push_back(std::move(stem));
  }
  for (const auto& p : sample.points) {
    const auto it = near.find(square(p.x(), p.y()));
    if (it == near.end()) continue;
    for (const auto k : it->second) {
      auto& s = stems[k];
      if (std::abs(static_cast<double>(p.z()) - s.breast_height_z) > half_window_m) continue;
      const Eigen::Vector3d off = p.cast<double>() - s.axis.middle;
      const Eigen::Vector3d across = off - off.dot(s.axis.direction) * s.axis.direction;
      if (across.norm() < reach_m) s.around.emplace_back(across.head<2>());
    }
  }
  std::vector<double> counts, diameters;
  std::vector<RoughCircle> circles;
  for (auto& s : stems) {
    circles.push_back(rough_circle(std::move(s.around)));
    counts.push_back(sample.each * static_cast<double>(circles.back().points.size()));
    if (std::isfinite(circles.back().radius_m)) diameters.push_back(2 * circles.back().radius_m);
  }
  see_doubled_walls(circles, out);
  out.stems = stems.size();
  if (!counts.empty()) out.points_per_stem = median(std::move(counts));
  if (!diameters.empty()) out.stem_diameter_m = median(std::move(diameters));
}

void see_lean(const std::vector<StemAxis>& axes, FirstSight& out) {
  constexpr std::size_t min_stems = 5;
  if (axes.size() < min_stems) return;
  std::vector<Eigen::VectorXd> samples;
  std::vector<double> weights;
  for (const auto& a : axes) {
    samples.emplace_back(a.direction.head<2>() / a.direction.z());
    weights.push_back(std::min(a.length_m, 6.0));
  }
  const auto mean = robust_mean(samples, weights, radians(0.2));
  out.stem_direction = Eigen::Vector3d(mean.mean(0), mean.mean(1), 1).normalized();
  out.lean_deg = degrees(std::atan(mean.mean.norm()));
  out.lean_error_deg = degrees(mean.standard_error);
}

void see_heights(const Sample& sample, const CellHeights& cells, FirstSight& out) {
  std::vector<float> heights;
  heights.reserve(sample.points.size());
  std::size_t at_breast_height = 0;
  for (const auto& p : sample.points) {
    const float h = p.z() - cells.low_around(p.x(), p.y(), 1);
    heights.push_back(h);
    if (h > 1.2F && h < 1.4F) ++at_breast_height;
  }
  out.top_height_m = static_cast<double>(quantile(std::move(heights), 0.999));
  out.points_per_m2 = sample.each * static_cast<double>(sample.points.size()) / cells.area_m2();
  out.breast_height_points_per_m2 = sample.each * static_cast<double>(at_breast_height) / cells.area_m2();
}

CloudKind kind_of(const FirstSight& sight) {
  constexpr double sparse_per_m2 = 100, wide_m = 30, low_m = 2;
  if (sight.stems > 0) return CloudKind::plot;
  if (sight.points_per_m2 > sparse_per_m2 && sight.top_height_m > low_m) return CloudKind::plot;
  return sight.extent_m.head<2>().minCoeff() > wide_m ? CloudKind::airborne : CloudKind::unknown;
}

}  // namespace

FirstSight first_sight(const PointCloud& cloud, const Run& run) {
  FirstSight out;
  out.points = cloud.size();
  if (cloud.size() < min_points) return out;
  run.report(0.0, "Looking at the cloud");
  auto sample = sample_of(cloud);
  if (sample.points.size() < min_points) return out;
  for (int axis = 0; axis < 3; ++axis)
    out.extent_m[axis] = static_cast<double>(range_of(coordinates(sample.points, axis), 0.002).width());
  out.duplicated_share = duplicated_share(cloud);
  run.check_cancel();

  auto thin = thinned(cloud, run);
  for (int axis = 0; axis < 3; ++axis) {
    out.along[static_cast<std::size_t>(axis)] = evidence_for(thin, sample, axis, run);
    run.report(0.2 * (axis + 1), "Looking at the cloud");
  }
  out.up = upright_axis(out.along);
  if (out.up && *out.up != 2) {
    for (auto& p : sample.points) p = z_up(p, *out.up);
    for (auto& p : thin) p = z_up(p.cast<float>(), *out.up).cast<double>();
  }

  constexpr double max_lean_deg = 25;
  const auto axes = find_stem_axes(thin, Eigen::Vector3d::UnitZ(), radians(max_lean_deg), run);
  const CellHeights cells(sample.points, cell_size_m(sample.points, 2));
  see_heights(sample, cells, out);
  const bool single_tree = is_single_tree(sample.points);
  std::optional<double> ground_z;
  if (single_tree) ground_z = static_cast<double>(quantile(coordinates(sample.points, 2), 0.001));
  see_stems(axes, sample, cells, ground_z, out);
  see_lean(axes, out);
  out.kind = single_tree ? CloudKind::single_tree : kind_of(out);
  run.report(1.0, "Looking at the cloud");
  return out;
}

}  // namespace cloud
}  // namespace bole
