// Stems as a walked scanner sees them that is not the one of modules/sim: own path, own beam, own noise, own bark; true
// poses, exact truth. It shares no code and no constant with the simulator or with the stem fit, so that the fit cannot
// be right by having been written beside it.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <unordered_set>
#include <vector>

#include "cloud/known_facts.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "slam/core/map/view_column.h"

namespace bole::synthetic {

struct ForeignOptions {
  double noise = 0.015;                           // of a range at normal incidence, metres
  double noise_growth = 1;                        // added share at grazing incidence and for faint echoes: twice at 1
  double aperture_h = 0.013, aperture_v = 0.010;  // full widths at 1/e^2 where the beam leaves the scanner, metres
  double divergence_h = 3e-3, divergence_v = 1.5e-3;  // full angles, radians
  double merge = 0.4;                                 // echoes of one pulse nearer to each other are one, by energy
  double step = 0.004;                                // of ranges, metres
  double laser_bias = 0;                              // standard deviation of each laser's constant error
  double bark_low = 0.001, bark_high = 0.0025;        // depth of the facets, by stem
  double ovality = 0.05;                              // greatest relative amplitude of the second harmonic
  double harmonics = 0.01;                            // of the third and the fifth
  double thin = 0.08, thick = 0.28;                   // diameters, metres
  double pose_noise = 0;                              // per axis and pass: displacement, metres
  double voxel = 0.015;                               // one point of each pass in each cube of the map; 0: all
  double column = 0;                             // the same in columns along the view, as Bole thins its maps; 0: all
  double shift_x = 0, shift_y = 0, shift_z = 0;  // of the whole plot
  double tell_noise = 0.012, tell_divergence = 3.0, tell_aperture = 0.0095;  // facts of the cloud
  double lines = 4;                                                          // metres between the lines of the walk
  int side = 5;                                                              // stems along each side of the plot
  unsigned seed = 1;
};

struct ForeignStem {
  Eigen::Vector2d base = Eigen::Vector2d::Zero(), slope = Eigen::Vector2d::Zero();
  double radius = 0.1, taper = 0.005, bark = 0.0015;  // of radius per metre
  std::array<double, 6> amplitude{}, phase{};
  unsigned id = 0;
  double dbh = 0;  // tape over the hull at 1.3 m

  double shape(double theta) const {
    double s = 1;
    for (std::size_t k = 2; k < amplitude.size(); ++k)
      s += amplitude[k] * std::cos(static_cast<double>(k) * theta + phase[k]);
    return s;
  }
  // Facets of the bark: plates some 2 cm wide and 7 cm high that lie up to `bark` below the ridges.
  double facet(double theta, double z) const {
    const auto i = static_cast<std::uint64_t>(std::floor((theta + 4) * radius / 0.02)),
               k = static_cast<std::uint64_t>(std::floor(z / 0.07 + 100));
    std::uint64_t h = (i * 0x9e3779b97f4a7c15ull) ^ (k * 0xc2b2ae3d27d4eb4full) ^ (id * 0x165667b19e3779f9ull);
    h ^= h >> 31, h *= 0xd6e8feb86659fd93ull, h ^= h >> 32;
    return bark * static_cast<double>(h & 0xffff) / 65535.0;
  }
  double tape() const {
    std::vector<Eigen::Vector2d> p;
    for (int i = 0; i < 720; ++i) {
      const double a = std::numbers::pi * i / 360;
      p.push_back(radius * shape(a) * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
    // Cauchy: the girth of a convex hull is pi times its mean width.
    double width = 0;
    for (int i = 0; i < 360; ++i) {
      const Eigen::Vector2d d(std::cos(std::numbers::pi * i / 360), std::sin(std::numbers::pi * i / 360));
      double low = 1e9, high = -1e9;
      for (const auto& q : p) low = std::min(low, d.dot(q)), high = std::max(high, d.dot(q));
      width += (high - low) / 360;
    }
    return width;
  }
};

struct ForeignCloud {
  PointCloud points;
  Raster dem;
  std::vector<ForeignStem> stems;
};

class ForeignScanner {
 public:
  explicit ForeignScanner(const ForeignOptions& o) : o_(o), random_(o.seed), columns_(std::max(1e-3, o.column)) {}

  ForeignCloud scan() {
    plant();
    for (auto& b : bias_) b = o_.laser_bias * normal();
    make_pattern();
    double time = 0;
    int pass = 0;
    for (double y = -half_ + 1; y <= half_ - 1 + 1e-9; y += o_.lines, ++pass, time += 20) {
      moved_ = o_.pose_noise * Eigen::Vector2d(normal(), normal());
      for (double x = -half_ - 1; x <= half_ + 1; x += 0.15, time += 0.15) {
        const double along = pass % 2 == 0 ? x : -x;
        turn({along, y + 0.25 * std::sin(0.9 * x), 1.7 + 0.02 * std::sin(11 * time)}, time, pass);
      }
    }
    return finish();
  }

 private:
  double normal() { return normal_(random_); }
  double uniform(double a, double b) { return a + (b - a) * uniform_(random_); }

  // Full widths are four standard deviations.
  void make_pattern() {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (auto& p : pattern_) p = {normal(), normal()}, mean += p / parts;
    Eigen::Array2d square = Eigen::Array2d::Zero();
    for (auto& p : pattern_) p -= mean, square += p.array().square() / parts;
    for (auto& p : pattern_) p = (0.25 * p.array() / square.sqrt()).matrix();
  }

  void plant() {
    const int side = o_.side;
    for (int i = 0; i < side * side; ++i) {
      ForeignStem s;
      s.id = static_cast<unsigned>(i + 1) + 100 * o_.seed;
      s.base = {2.4 * (i % side - 0.5 * (side - 1)) + uniform(-0.5, 0.5),
                2.4 * (i / side - 0.5 * (side - 1)) + uniform(-0.5, 0.5)};
      s.slope = {uniform(-0.04, 0.04), uniform(-0.04, 0.04)};
      s.radius = 0.5 * uniform(o_.thin, o_.thick), s.taper = uniform(0.002, 0.007),
      s.bark = uniform(o_.bark_low, o_.bark_high);
      // The width varies by twice the amplitude.
      s.amplitude[2] = uniform(0, 0.5 * o_.ovality), s.amplitude[3] = uniform(0, o_.harmonics),
      s.amplitude[5] = uniform(0, 0.6 * o_.harmonics);
      for (auto& p : s.phase) p = uniform(0, 2 * std::numbers::pi);
      s.dbh = s.tape();
      stems_.push_back(s);
    }
  }

  // Range of a thin ray to a stem; nothing: negative.
  double hit(const ForeignStem& s, const Eigen::Vector3d& from, const Eigen::Vector3d& d, double& cosine) const {
    double r = s.radius, t = -1;
    for (int i = 0; i < 4; ++i) {
      const double z = t > 0 ? from.z() + t * d.z() : 1.3;
      const Eigen::Vector2d c = s.base + z * s.slope;
      const Eigen::Vector2d a = from.head<2>() - c, v = d.head<2>();
      const double A = v.squaredNorm(), B = a.dot(v), C = a.squaredNorm() - r * r, q = B * B - A * C;
      if (q < 0) return -1;
      t = (-B - std::sqrt(q)) / A;
      const Eigen::Vector2d n = a + t * v;
      const double theta = std::atan2(n.y(), n.x()), height = from.z() + t * d.z();
      r = (s.radius - s.taper * (height - 1.3)) * s.shape(theta) - s.facet(theta, height);
      cosine = -n.normalized().dot(v);
    }
    return t;
  }

  void turn(const Eigen::Vector3d& at, double time, int pass) {
    constexpr double degree = std::numbers::pi / 180;
    const double start = uniform(0, 0.2);
    for (const auto& s : stems_) {
      const Eigen::Vector2d to = s.base + 1.3 * s.slope - at.head<2>();
      const double distance = to.norm();
      if (distance < 0.4 + s.radius || distance > 14) continue;
      const double half_window =
                       std::asin(std::min(0.9, (1.3 * s.radius + 0.06 + 0.002 * distance) / distance)) / degree,
                   middle = std::atan2(to.y(), to.x()) / degree;
      const double first = start + 0.2 * std::ceil((middle - half_window - start) / 0.2);
      for (double az = first; az < middle + half_window; az += 0.2)
        for (std::size_t laser = 0; laser < bias_.size(); ++laser) {
          const double el = -25 + 40.0 * static_cast<double>(laser) / (static_cast<double>(bias_.size()) - 1);
          const double z = at.z() + distance * std::tan(el * degree);
          if (z < 0.25 || z > 3.9) continue;
          pulse(s, at, az * degree, el * degree, laser, time, pass);
        }
    }
  }

  void pulse(const ForeignStem& s, const Eigen::Vector3d& at, double az, double el, std::size_t laser, double time,
             int pass) {
    const Eigen::Vector3d d(std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el)),
        right(-std::sin(az), std::cos(az), 0), up = d.cross(right);
    for (const auto& other : stems_) {  // hidden by a nearer one
      const Eigen::Vector2d c = other.base + 1.3 * other.slope - at.head<2>();
      const double along = c.dot(d.head<2>().normalized());
      if (&other != &s && along > 0 && along < (s.base - at.head<2>()).norm() - 0.3 &&
          std::sqrt(std::max(0.0, c.squaredNorm() - along * along)) < other.radius + 0.03)
        return;
    }
    struct Part {
      double range, energy, cosine;
    };
    std::array<Part, parts> found;
    std::size_t n = 0;
    for (const auto& p : pattern_) {
      const Eigen::Vector3d from = at + p.x() * o_.aperture_h * right + p.y() * o_.aperture_v * up,
                            v = (d + p.x() * o_.divergence_h * right + p.y() * o_.divergence_v * up).normalized();
      double cosine = 0;
      const double range = hit(s, from, v, cosine);
      if (range > 0 && cosine > 0) found[n++] = {range, cosine, cosine};
    }
    if (n == 0) return;
    std::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n),
              [](const Part& a, const Part& b) { return a.range < b.range; });
    double energy = 0, moment = 0, cosine = 0;
    for (std::size_t i = 0; i < n && found[i].range - found[0].range < o_.merge; ++i)
      energy += found[i].energy, moment += found[i].energy * found[i].range,
          cosine += found[i].energy * found[i].cosine;
    const double share = energy / parts;
    if (share < 0.03 * (1 + uniform(0, 1))) return;  // too faint
    const double incidence = cosine / energy, growth = std::max(1 - incidence, 1 - std::min(1.0, 2 * share));
    double range = moment / energy + bias_[laser] + o_.noise * (1 + o_.noise_growth * growth) * normal();
    if (o_.step > 0) range = o_.step * std::round(range / o_.step);
    const Eigen::Vector3d p = at + range * d + Eigen::Vector3d(moved_.x(), moved_.y(), 0);
    if (o_.voxel > 0) {
      const auto cell = [&](double v) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / o_.voxel)) & 0xfffff);
      };
      const std::uint64_t key = cell(p.x()) | cell(p.y()) << 20 | cell(p.z()) << 40;
      if (!seen_[static_cast<std::size_t>(pass)].insert(key).second) return;
    }
    if (o_.column > 0 && !seen_[static_cast<std::size_t>(pass)]
                              .insert(columns_.key(p, at + Eigen::Vector3d(moved_.x(), moved_.y(), 0)))
                              .second)
      return;
    positions_.push_back((p + Eigen::Vector3d(o_.shift_x, o_.shift_y, o_.shift_z)).cast<float>());
    height_.push_back(static_cast<float>(p.z()));
    sensor_x_.push_back(static_cast<float>(at.x() + moved_.x() + o_.shift_x)),
        sensor_y_.push_back(static_cast<float>(at.y() + moved_.y() + o_.shift_y));
    sensor_z_.push_back(static_cast<float>(at.z() + o_.shift_z));
    range_.push_back(static_cast<float>(range)), time_.push_back(time), pass_.push_back(pass);
    ring_.push_back(static_cast<std::uint16_t>(laser));
  }

  ForeignCloud finish() {
    ForeignCloud out;
    out.points = PointCloud(std::move(positions_));
    out.points.axes = Axes::plot;
    out.points.set_column(arrays::height_above_ground, std::move(height_));
    out.points.set_column(arrays::sensor_x, std::move(sensor_x_)),
        out.points.set_column(arrays::sensor_y, std::move(sensor_y_));
    out.points.set_column(arrays::sensor_z, std::move(sensor_z_)),
        out.points.set_column(arrays::range, std::move(range_));
    out.points.set_column(arrays::time, std::move(time_)), out.points.set_column(arrays::pass, std::move(pass_));
    set_fact(out.points.facts, facts::range_noise, o_.tell_noise),
        set_fact(out.points.facts, facts::beam_divergence, o_.tell_divergence),
        set_fact(out.points.facts, facts::beam_aperture, o_.tell_aperture);
    out.dem.cell_m = 0.5, out.dem.nx = out.dem.ny = 60;
    out.dem.origin = Eigen::Vector2d(-15 + o_.shift_x, -15 + o_.shift_y);
    out.dem.values.assign(3600, static_cast<float>(o_.shift_z));
    for (auto& s : stems_) s.base += Eigen::Vector2d(o_.shift_x, o_.shift_y);
    out.stems = std::move(stems_);
    return out;
  }

  static constexpr int parts = 16;
  static constexpr double half_ = 6.5;
  ForeignOptions o_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  slam::ViewColumns columns_;
  std::array<double, 32> bias_{};
  std::array<Eigen::Vector2d, parts> pattern_;
  Eigen::Vector2d moved_ = Eigen::Vector2d::Zero();
  std::vector<ForeignStem> stems_;
  std::array<std::unordered_set<std::uint64_t>, 32> seen_;
  PointCloud::Positions positions_;
  std::vector<float> height_, sensor_x_, sensor_y_, sensor_z_, range_;
  std::vector<double> time_;
  std::vector<std::int32_t> pass_;
  std::vector<std::uint16_t> ring_;
};

}  // namespace bole::synthetic
