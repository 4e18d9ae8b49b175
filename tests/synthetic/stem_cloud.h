// Points of a forest plot's stems as a walking sensor sees them, with exact truth: rays, range noise, passes with
// drift, taper, lean, clutter.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/raster.h"

namespace bole::synthetic {

struct TrueStem {
  Eigen::Vector2d base = Eigen::Vector2d::Zero();   // axis at the ground
  double dbh = 0.25;                                // perpendicular to the axis at 1.3 m along it, metres
  double taper = 0.01;                              // metres of diameter per metre
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  // metres per metre of height
  double length = 8;                                // along the axis
  double start = 0;                                 // along the axis: limbs of a fork begin above the ground
  double ellipse = 0;                               // relative: radius varies by +-ellipse with twice the bearing
  double flutes = 0;                                // relative: likewise with five times the bearing

  Eigen::Vector3d direction() const { return Eigen::Vector3d(slope.x(), slope.y(), 1).normalized(); }
  double radius_at(double along) const { return std::max(0.005, 0.5 * (dbh - taper * (along - 1.3))); }
};

struct StemCloudOptions {
  double range_noise = 0.015;  // along the ray, metres
  double angle_noise = 0.0;    // of the ray direction as recorded, radians
  double drift = 0.0;          // SD of the displacement of each pass, per axis, metres
  int passes = 3;
  double pass_step = 0.25;                          // sensor positions along each pass, metres
  double azimuth_step = 0.2, elevation_step = 1.0;  // degrees
  double lowest_elevation = -25, highest_elevation = 15;
  double max_range = 15;
  double ground_slope = 0;            // dz/dx
  int shrub_points = 0;               // scattered in balls around random places
  double outlier_share = 0;           // of returns, moved uniformly by up to +-0.3 m along the ray
  double offset_x = 0, offset_y = 0;  // of the cloud's origin
  unsigned seed = 1;
  bool rays = true, time = true;
};

struct StemCloud {
  PointCloud points;  // height_above_ground; with rays sensor_x/y/z and range; with time `time`
  Raster dem;
  std::vector<TrueStem> stems;
};

// The nearest hit of a ray with a stem; distance along the ray.
inline std::optional<double> hit(const TrueStem& stem, double ground_z, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& d) {
  const Eigen::Vector3d base(stem.base.x(), stem.base.y(), ground_z), a = stem.direction(), w = from - base;
  // A few rounds of a cylinder with the radius of the last hit settle taper and ellipse.
  double radius = stem.radius_at(1.3), t = -1;
  const Eigen::Vector3d d_across = d - d.dot(a) * a, w_across = w - w.dot(a) * a;
  for (int i = 0; i < 6; ++i) {
    const double A = d_across.squaredNorm(), B = w_across.dot(d_across), C = w_across.squaredNorm() - radius * radius,
                 q = B * B - A * C;
    if (q < 0 || A < 1e-9) return std::nullopt;
    t = (-B - std::sqrt(q)) / A;
    if (t <= 0) return std::nullopt;
    const Eigen::Vector3d p = w + t * d;
    const double along = p.dot(a);
    const Eigen::Vector3d across = p - along * a;
    const double bearing = std::atan2(across.y(), across.x());
    radius = stem.radius_at(along) * (1 + stem.ellipse * std::cos(2 * bearing) + stem.flutes * std::cos(5 * bearing));
  }
  const double along = (w + t * d).dot(a);
  if (along < stem.start || along > stem.length) return std::nullopt;
  return t;
}

class StemCloudMaker {
 public:
  StemCloudMaker(std::vector<TrueStem> stems, const StemCloudOptions& o) : o_(o), random_(o.seed) {
    out_.stems = std::move(stems);
  }

  // Passes are straight lines beside the stems' middle, at different bearings; the stand is assumed to be some 10 m
  // wide at most.
  StemCloud make() {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const auto& s : out_.stems) middle += s.base / static_cast<double>(out_.stems.size());
    for (int pass = 0; pass < o_.passes; ++pass) {
      const double bearing = 2 * std::numbers::pi * pass / o_.passes + 0.3;
      const Eigen::Vector2d side(std::cos(bearing), std::sin(bearing)), forward(-side.y(), side.x());
      const Eigen::Vector2d drift(normal(o_.drift), normal(o_.drift));
      for (double s = -3; s <= 3; s += o_.pass_step)
        scan(middle + 4.0 * side + s * forward, drift, 100.0 * pass + s + 3);
    }
    shrubs();
    return finish();
  }

  double ground(const Eigen::Vector2d& p) const { return o_.ground_slope * p.x(); }

 private:
  double normal(double sd) { return sd > 0 ? std::normal_distribution<double>(0, sd)(random_) : 0; }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  void scan(const Eigen::Vector2d& at, const Eigen::Vector2d& drift, double time) {
    const Eigen::Vector3d sensor(at.x(), at.y(), ground(at) + 1.6);
    constexpr double degree = std::numbers::pi / 180;
    const double start = uniform(0, o_.azimuth_step);
    for (double azimuth = start; azimuth < 360; azimuth += o_.azimuth_step)
      for (double elevation = o_.lowest_elevation; elevation <= o_.highest_elevation; elevation += o_.elevation_step) {
        const double az = azimuth * degree, el = elevation * degree;
        const Eigen::Vector3d d(std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el));
        double nearest = o_.max_range;
        bool any = false;
        for (const auto& s : out_.stems)
          if (const auto t = hit(s, ground(s.base), sensor, d); t && *t < nearest) {
            nearest = *t;
            any = true;
          }
        if (!any) continue;
        double range = nearest + normal(o_.range_noise);
        if (uniform(0, 1) < o_.outlier_share) range += uniform(-0.3, 0.3);
        const Eigen::Vector3d recorded =
            (d + Eigen::Vector3d(normal(o_.angle_noise), normal(o_.angle_noise), normal(o_.angle_noise))).normalized();
        const Eigen::Vector3d moved(drift.x(), drift.y(), 0);
        add(sensor + range * recorded + moved, sensor + moved, time);
      }
  }

  void shrubs() {
    for (int i = 0; i < o_.shrub_points;) {
      const Eigen::Vector3d centre(uniform(-4, 4), uniform(-4, 4), uniform(0.2, 1.4));
      const double size = uniform(0.2, 0.6);
      for (int k = 0; k < 200 && i < o_.shrub_points; ++k, ++i) {
        const Eigen::Vector3d p = centre + size * Eigen::Vector3d(normal(0.5), normal(0.5), normal(0.5));
        add(p + Eigen::Vector3d(0, 0, ground(p.head<2>())), Eigen::Vector3d(4, 0, 1.6), uniform(0, 300));
      }
    }
  }

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& sensor, double time) {
    positions_.push_back(p.cast<float>());
    height_.push_back(static_cast<float>(p.z() - ground(p.head<2>())));
    sensor_x_.push_back(static_cast<float>(sensor.x()));
    sensor_y_.push_back(static_cast<float>(sensor.y()));

    sensor_z_.push_back(static_cast<float>(sensor.z()));
    range_.push_back(static_cast<float>((p - sensor).norm()));
    time_.push_back(time);
  }

  StemCloud finish() {
    const Eigen::Vector3d origin(o_.offset_x, o_.offset_y, 0);
    out_.points = PointCloud(std::move(positions_), origin);
    out_.points.axes = Axes::plot;
    out_.points.set_column(arrays::height_above_ground, std::move(height_));
    if (o_.rays) {
      out_.points.set_column(arrays::sensor_x, std::move(sensor_x_));

      out_.points.set_column(arrays::sensor_y, std::move(sensor_y_));
      out_.points.set_column(arrays::sensor_z, std::move(sensor_z_));

      out_.points.set_column(arrays::range, std::move(range_));
    }
    if (o_.time) out_.points.set_column(arrays::time, std::move(time_));
    out_.dem.cell_m = 0.25;
    out_.dem.nx = out_.dem.ny = 120;
    out_.dem.origin = origin.head<2>().array() - 15.0;
    out_.dem.values.resize(120 * 120);
    for (int iy = 0; iy < 120; ++iy)
      for (int ix = 0; ix < 120; ++ix)
        out_.dem.at(ix, iy) = static_cast<float>(ground(Eigen::Vector2d(-15 + (ix + 0.5) * 0.25, 0)));
    return std::move(out_);
  }

  StemCloudOptions o_;
  std::mt19937 random_;
  StemCloud out_;
  PointCloud::Positions positions_;
  std::vector<float> height_, sensor_x_, sensor_y_, sensor_z_, range_;
  std::vector<double> time_;
};

inline StemCloud make_stem_cloud(std::vector<TrueStem> stems, const StemCloudOptions& options = {}) {
  return StemCloudMaker(std::move(stems), options).make();
}

// `n` stems on a jittered grid some 2 m apart, diameters between `thin` and `thick`, slight leans.
inline std::vector<TrueStem> random_stand(int n, double thin, double thick, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<TrueStem> stems;
  const int side = static_cast<int>(std::ceil(std::sqrt(n)));
  for (int i = 0; i < n; ++i) {
    TrueStem s;
    s.base = {2.0 * (i % side - 0.5 * (side - 1)) + 0.5 * (u(random) - 0.5),
              2.0 * (i / side - 0.5 * (side - 1)) + 0.5 * (u(random) - 0.5)};
    s.dbh = thin + (thick - thin) * u(random);
    s.taper = 0.005 + 0.01 * u(random);
    s.slope = {0.1 * (u(random) - 0.5), 0.1 * (u(random) - 0.5)};
    stems.push_back(s);
  }
  return stems;
}

}  // namespace bole::synthetic
