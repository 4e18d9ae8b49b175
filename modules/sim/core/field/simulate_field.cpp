#include "sim/core/field/simulate_field.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/arrays.h"
#include "sim/core/field/field_scene.h"
#include "sim/core/field/livox_scanner.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

using namespace sim;

// A robot on a straight line over uneven ground: a constant tilt where it stands, and a sway.
class RobotMotion {
 public:
  RobotMotion(const Field& field, const FieldSimulationOptions& o, std::uint64_t seed) : field_(field), o_(o) {
    Random random(seed, Stream::walk, 31);
    roll_deg_ = o.tilt * random.bounded_normal();
    pitch_deg_ = o.tilt * random.bounded_normal();
    for (auto& wave : waves_)
      wave = {o.sway * random.uniform(0.2, 0.6), random.uniform(0.4, 3.5), random.angle(), random.chance(0.5)};
    const auto& s = field.recipe.sensor;
    start_ = {s.x_m + random.uniform(-0.15, 0.15), s.y_m + random.uniform(-0.1, 0.1)};
    heading_ = (s.heading_deg + random.uniform(-3, 3)) * rad_per_deg;
  }

  double heading_rad() const { return heading_; }
  // Roll and pitch (deg) at a time.
  Eigen::Vector2d tilt_deg(double t) const {
    Eigen::Vector2d tilt(roll_deg_, pitch_deg_);
    for (const auto& w : waves_) tilt[w.of_pitch ? 1 : 0] += w.size_deg * std::sin(two_pi * w.hz * t + w.phase);
    return tilt;
  }
  Pose pose(double t) const {
    const Eigen::Vector2d at = start_ + o_.speed * t * Eigen::Vector2d(std::cos(heading_), std::sin(heading_));
    const Eigen::Vector2d tilt = rad_per_deg * tilt_deg(t);
    Pose T = Pose::Identity();
    T.linear() = rotation_from_rpy(tilt[0], tilt[1], heading_ - std::numbers::pi / 2);
    T.translation() =
        Eigen::Vector3d(at.x(), at.y(), field_.terrain.height(at.x(), at.y()) + field_.recipe.sensor.height_m);
    return T;
  }

 private:
  struct Wave {
    double size_deg = 0, hz = 1, phase = 0;
    bool of_pitch = false;
  };
  const Field& field_;
  const FieldSimulationOptions& o_;
  double roll_deg_ = 0, pitch_deg_ = 0, heading_ = 0;
  Eigen::Vector2d start_;
  std::array<Wave, 6> waves_;
};

class FieldSimulator {
 public:
  FieldSimulator(const FieldSimulationOptions& o, const Run& run)
      : o_(o),
        run_(run),
        seed_(static_cast<std::uint64_t>(o.seed)),
        field_(plant_field(read_field(o.field), seed_)),
        scene_(build_field_scene(field_, seed_)),
        scanner_({}, o.noise, scene_, seed_),
        robot_(field_, o, seed_) {}

  FieldScan simulate() {
    FieldScan scan;
    std::int64_t returns = 0;
    for (int f = 0; f < o_.frames; ++f) {
      scan.frames.push_back(frame(f));
      returns += static_cast<std::int64_t>(scan.frames.back().size());
      run_.report((f + 1.0) / o_.frames, "scanning the field");
    }
    scan.attitude = attitude();
    scan.poses = poses();
    scan.marks = marks();
    scan.plants = field_plant_table(field_);
    scan.rows = field_row_table(field_);
    scan.report.counts["frames"] = o_.frames;
    scan.report.counts["returns"] = returns;
    scan.report.counts["plants"] = static_cast<std::int64_t>(scan.plants.rows());
    scan.report.message = fmt::format("{}: {} frames of {:g} s, {} returns, {} plants in {} rows", field_.recipe.title,
                                      o_.frames, o_.integration, returns, scan.plants.rows(), scan.rows.rows());
    return scan;
  }

 private:
  PointCloud frame(int f) const {
    const double rate = scanner_.model().rate_hz;
    const auto count = static_cast<std::int64_t>(std::llround(o_.integration * rate));
    const std::int64_t first = f * count;
    std::vector<LivoxReturn> returns(static_cast<std::size_t>(count));
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, 256), [&](const auto& range) {
      for (auto i = range.begin(); i < range.end() && !run_.cancelled(); ++i)
        returns[static_cast<std::size_t>(i)] =
            scanner_.fire(robot_.pose(static_cast<double>(first + i) / rate), first + i);
    });
    run_.check_cancel();
    PointCloud::Positions points;
    std::vector<float> intensity;
    std::vector<double> time;
    std::vector<std::int32_t> tree;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto& r = returns[static_cast<std::size_t>(i)];
      if (!(r.range_m > 0)) continue;
      points.push_back((static_cast<double>(r.range_m) * r.direction).cast<float>());
      intensity.push_back(r.intensity);
      time.push_back(static_cast<double>(first + i) / rate);

      tree.push_back(r.tree_id);
    }
    PointCloud cloud(std::move(points));
    cloud.axes = Axes::sensor;
    cloud.set_column(arrays::intensity, std::move(intensity));
    cloud.set_column(arrays::time, std::move(time));
    cloud.set_column(arrays::tree_id, std::move(tree));
    return cloud;
  }

  Eigen::Vector2d imu_bias_deg() const {
    Random random(seed_, Stream::walk, 33);
    return o_.imu_bias * Eigen::Vector2d(random.bounded_normal(), random.bounded_normal());
  }

  Table attitude() const {
    constexpr double hz = 200;
    Random random(seed_, Stream::walk, 32);
    const auto bias = imu_bias_deg();
    std::vector<double> time, roll, pitch;
    for (double t = -1 / hz; t < o_.frames * o_.integration + 2 / hz; t += 1 / hz) {
      const auto tilt = robot_.tilt_deg(t);
      time.push_back(t);
      roll.push_back(tilt[0] + bias[0] + o_.imu_noise * random.normal());
      pitch.push_back(tilt[1] + bias[1] + o_.imu_noise * random.normal());
    }
    Table t;
    t.set("yaw_deg", std::vector<double>(time.size(), 0.0));
    t.set("time_s", std::move(time));
    t.set("roll_deg", std::move(roll));
    t.set("pitch_deg", std::move(pitch));
    return t;
  }

  Table poses() const {
    std::vector<std::int64_t> frame;
    std::vector<double> time, x, y, z, heading, roll, pitch, yaw;
    for (int f = 0; f < o_.frames; ++f) {
      const double t = (f + 0.5) * o_.integration;
      const Eigen::Vector3d at = robot_.pose(t).translation();
      const auto tilt = robot_.tilt_deg(t);
      frame.push_back(f);
      time.push_back(t);
      x.push_back(at.x());
      y.push_back(at.y());
      z.push_back(at.z());
      heading.push_back(robot_.heading_rad() / rad_per_deg);
      yaw.push_back(robot_.heading_rad() / rad_per_deg - 90);
      roll.push_back(tilt[0]);
      pitch.push_back(tilt[1]);
    }
    Table t;
    t.set("frame", frame);
    t.set("time_s", time);
    t.set("x_m", x);
    t.set("y_m", y);
    t.set("z_m", z);
    t.set("heading_deg", heading);
    t.set("roll_deg", roll);
    t.set("pitch_deg", pitch);
    t.set("yaw_deg", yaw);
    return t;
  }

  // SPEC B1: an antenna stands at E, F and G. Positions have the receiver's noise; the LiDAR sees the antenna with an
  // averaged range and a direction good to a few hundredths of a degree, levelled with the IMU's constant error.
  Table marks() const {
    Random random(seed_, Stream::targets, 71);
    const Pose T = robot_.pose(0.5 * o_.integration);
    const auto tilt = robot_.tilt_deg(0.5 * o_.integration);
    const Eigen::Vector2d seen_tilt = rad_per_deg * (tilt + imu_bias_deg());
    const Eigen::Matrix3d level = rotation_from_rpy(seen_tilt[0], seen_tilt[1], 0);
    std::vector<std::string> name;
    std::vector<double> x, y, z, range, sx, sy, sz;
    const std::array<Eigen::Vector3d, 3> places{
        {{-3.2, 7.5, 0.9}, {2.8, 6.0, 1.3}, {0.4, 4.0, 0.4}}};  // right, ahead, up
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Eigen::Vector3d nav =
          T.translation() + rotation_from_rpy(0, 0, robot_.heading_rad() - std::numbers::pi / 2) * places[i];
      Eigen::Vector3d seen = T.linear().transpose() * (nav - T.translation());
      const double range_sigma = scanner_.model().range_sigma_m * o_.noise / 4;
      const Eigen::Vector3d off(0.03 * rad_per_deg * random.normal(), 0.03 * rad_per_deg * random.normal(),
                                0.03 * rad_per_deg * random.normal());
      seen += seen.cross(off);
      seen *= 1 + range_sigma * random.normal() / seen.norm();
      const Eigen::Vector3d levelled = level * seen;
      name.emplace_back(1, static_cast<char>('E' + i));
      x.push_back(nav.x() + o_.mark_noise * random.normal());
      y.push_back(nav.y() + o_.mark_noise * random.normal());
      z.push_back(nav.z() + 2 * o_.mark_noise * random.normal());
      range.push_back(seen.norm());
      sx.push_back(levelled.x());
      sy.push_back(levelled.y());
      sz.push_back(levelled.z());
    }
    Table t;
    t.set("name", name);
    t.set("x_m", x);
    t.set("y_m", y);
    t.set("z_m", z);
    t.set("range_m", range);
    t.set("seen_x_m", sx);
    t.set("seen_y_m", sy);
    t.set("seen_z_m", sz);
    return t;
  }

  const FieldSimulationOptions& o_;
  const Run& run_;
  std::uint64_t seed_;
  Field field_;
  RayScene scene_;
  LivoxScanner scanner_;
  RobotMotion robot_;
};

}  // namespace

const OptionTable& option_table(const FieldSimulationOptions*) {
  using S = FieldSimulationOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"field",
                             &S::field,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Field recipe: a name in resources/fields or the path of a recipe file."},
      Option<S, int>{"seed",
                     &S::seed,
                     Unit::none,
                     {0, 2'000'000'000},
                     Tier::basic,
                     "Seed of all randomness. The same seed gives the same data."},
      Option<S, double>{"integration",
                        &S::integration,
                        Unit::second,
                        {0.01, 10},
                        Tier::basic,
                        "Integration time of a frame. A longer time gives more points."},
      Option<S, int>{"frames", &S::frames, Unit::none, {1, 1000}, Tier::basic, "Number of consecutive frames."},
      Option<S, double>{
          "speed", &S::speed, Unit::metre_per_second, {0, 5}, Tier::basic, "Speed of the robot along its heading."},
      Option<S, double>{"tilt",
                        &S::tilt,
                        Unit::degree,
                        {0, 10},
                        Tier::advanced,
                        "Standard deviation of the constant roll and pitch of the robot."},
      Option<S, double>{
          "sway", &S::sway, Unit::degree, {0, 10}, Tier::advanced, "Amplitude of the sway in roll and pitch."},
      Option<S, double>{"imu_noise",
                        &S::imu_noise,
                        Unit::degree,
                        {0, 5},
                        Tier::advanced,
                        "Standard deviation of a single roll or pitch of the IMU."},
      Option<S, double>{"imu_bias",
                        &S::imu_bias,
                        Unit::degree,
                        {0, 5},
                        Tier::advanced,
                        "Standard deviation of the constant roll and pitch error of the IMU."},
      Option<S, double>{
          "noise", &S::noise, Unit::none, {0, 10}, Tier::advanced, "Factor on the range noise of the sensor."},
      Option<S, double>{"mark_noise",
                        &S::mark_noise,
                        Unit::metre,
                        {0, 1},
                        Tier::advanced,
                        "Standard deviation of the antenna positions used for resection."},
  });
  return table;
}

FieldScan simulate_field(const FieldSimulationOptions& options, const Run& run) {
  return FieldSimulator(options, run).simulate();
}

}  // namespace bole::sim
