// The simulator from end to end: what the files hold is the scene as the sensor would have seen it.
#include "sim/core/plot/simulate.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "cloud/trajectory.h"
#include "modules/sim/plots.h"
#include "sensor/core/velodyne_decoder.h"
#include "sim/core/plot/forest.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Simulation : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("bole_sim_" + std::to_string(::getpid()) + "_" +
                                        testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(dir_);
    recipe_ = sim::bare_plot(3);
    options_.plot = (dir_ / "bare.json").string();
    options_.max_time = 0.5;
    options_.stand_still = 0;
  }
  void TearDown() override { fs::remove_all(dir_); }

  Report run(const std::string& name, const bole::Run& with = {}) {
    std::ofstream(dir_ / "bare.json") << sim::to_json(recipe_);
    return simulate(options_, dir_ / name, with);
  }
  std::string bytes(const std::string& file) const {
    std::ifstream in(dir_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path dir_;
  sim::PlotRecipe recipe_;
  SimulationOptions options_;
};

struct Point {
  Eigen::Vector3d in_plot;
  double range_m;
  Eigen::Vector3d sensor;
};

Trajectory read_tum(const std::string& text) {
  Trajectory trajectory;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    StampedPose pose;
    Eigen::Vector3d t;
    Eigen::Quaterniond q;
    words >> pose.time_s >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
    pose.T_target_sensor.linear() = q.toRotationMatrix();
    pose.T_target_sensor.translation() = t;
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

// Packets of a pcap with the time of each, from its own clock (microseconds past the hour).
std::vector<Point> points_of(const std::string& pcap, const Trajectory& trajectory) {
  const sensor::VelodyneDecoder decoder(sensor::load_sensor_model("vlp32c"));
  std::vector<Point> points;
  std::vector<sensor::VelodyneReturn> returns;
  const double hour = 3600 * std::floor(simulation_epoch_s / 3600);
  for (std::size_t at = 24; at + 16 + 42 + sensor::velodyne_packet_bytes <= pcap.size();
       at += 16 + 42 + sensor::velodyne_packet_bytes) {
    const auto* payload = reinterpret_cast<const std::uint8_t*>(pcap.data()) + at + 16 + 42;
    const auto packet = sensor::parse_velodyne_packet({payload, sensor::velodyne_packet_bytes});
    if (!packet) continue;
    returns.clear();
    decoder.decode(*packet, returns);
    for (const auto& r : returns) {
      const double time = hour + 1e-6 * packet->time_us + static_cast<double>(r.time_offset_s);
      const Pose T = trajectory.at(time);
      points.push_back({T * r.position.cast<double>(), r.range_m, T.translation()});
    }
  }
  return points;
}

TEST_F(Simulation, packets_and_true_poses_give_back_the_ground) {
  recipe_.terrain.slope_deg = 5;
  options_.laser_bias = 0;
  options_.speed = 2;  // rolling shutter matters
  options_.max_time = 3;
  options_.rotation_hz = 20;
  run("out");
  const auto points = points_of(bytes("out/walk.pcap"), read_tum(bytes("out/trajectory.tum")));
  const sim::Forest forest = sim::make_forest(recipe_, 1);
  const sim::Terrain& terrain = forest.terrain;
  const auto beside_something = [&](const Eigen::Vector3d& p) {
    return std::ranges::any_of(forest.trees,
                               [&](const auto& t) { return (t.stem.foot - p).template head<2>().norm() < 0.6; }) ||
           std::ranges::any_of(forest.targets,
                               [&](const auto& t) { return (t.middle - p).template head<2>().norm() < 0.3; });
  };
  double n = 0, sum = 0, squares = 0;
  for (const auto& p : points) {
    if (p.range_m > 6 || p.in_plot.head<2>().cwiseAbs().maxCoeff() > 5) continue;
    if (beside_something(p.in_plot)) continue;
    const double above = p.in_plot.z() - terrain.height(p.in_plot.x(), p.in_plot.y());
    // Turned into an error of range: the ground is a plane here.
    const Eigen::Vector3d ray = (p.in_plot - p.sensor) / p.range_m;
    const double error =
        -above / std::abs(ray.dot(terrain.normal(p.in_plot.x(), p.in_plot.y()))) * terrain.normal(0, 0).z();
    n += 1;
    sum += error;
    squares += error * error;
  }
  ASSERT_GT(n, 20000);
  EXPECT_NEAR(sum / n, 0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / n), sensor::load_sensor_model("vlp32c").range_sigma_m, 0.001);
}

TEST_F(Simulation, the_same_seed_gives_the_same_bytes_at_any_thread_count) {
  recipe_.understorey.shrubs_per_ha = 500;
  run("a");
  {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    run("b");
  }
  for (const char* file :
       {"walk.pcap", "trees.csv", "trajectory.tum", "dem.tif", "targets.csv", "saplings.csv", "recipe.json"}) {
    const std::string a = bytes(std::string("a/") + file), b = bytes(std::string("b/") + file);
    EXPECT_FALSE(a.empty()) << file;
    EXPECT_TRUE(a == b) << file;
  }
  options_.seed = 2;
  run("c");
  EXPECT_FALSE(bytes("a/walk.pcap") == bytes("c/walk.pcap"));
  EXPECT_FALSE(bytes("a/trees.csv") == bytes("c/trees.csv"));
}

TEST_F(Simulation, reports_and_writes_its_truth) {
  const Report report = run("out");
  EXPECT_EQ(report.counts.at("trees"), 3);
  EXPECT_GT(report.counts.at("returns"), 10000);
  EXPECT_EQ(report.counts.at("pulses") % 32, 0);
  EXPECT_THAT(bytes("out/trees.csv"), testing::StartsWith("tree_id,x_m,y_m,z_m,dbh_cm,height_m,lean_deg,lean_azimuth_"
                                                          "deg,state,in_plot,species,base_x_m,base_y_m,twin_of\n1,"));
  EXPECT_THAT(bytes("out/targets.csv"), HasSubstr("\ncentre,0.0000,0.0000,1.5000,"));
  EXPECT_THAT(bytes("out/targets.csv"), HasSubstr("\nnorth,0.0000,5.0000,"));
  const auto recipe = nlohmann::json::parse(bytes("out/recipe.json"));
  EXPECT_EQ(recipe["options"]["seed"], 1);
  EXPECT_EQ(recipe["plot"]["trees"]["count"], 3);
}

TEST_F(Simulation, targets_shine_where_they_stand) {
  options_.max_time = 1;
  run("out");
  const Trajectory trajectory = read_tum(bytes("out/trajectory.tum"));
  const std::string pcap = bytes("out/walk.pcap");
  const sensor::VelodyneDecoder decoder(sensor::load_sensor_model("vlp32c"));
  int bright = 0, elsewhere = 0;
  std::vector<sensor::VelodyneReturn> returns;
  for (std::size_t at = 24 + 58; at + sensor::velodyne_packet_bytes <= pcap.size();
       at += 58 + sensor::velodyne_packet_bytes) {
    const auto packet = sensor::parse_velodyne_packet(
        {reinterpret_cast<const std::uint8_t*>(pcap.data()) + at, sensor::velodyne_packet_bytes});
    ASSERT_TRUE(packet);
    returns.clear();
    decoder.decode(*packet, returns);
    for (const auto& r : returns) {
      if (r.intensity < 150) continue;
      const Eigen::Vector3d p = trajectory.at(3600 * std::floor(simulation_epoch_s / 3600) + 1e-6 * packet->time_us +
                                              static_cast<double>(r.time_offset_s)) *
                                r.position.cast<double>();
      const double d = std::min((p - Eigen::Vector3d(0, 0, 1.5)).norm(), (p - Eigen::Vector3d(0, 5, 1.5)).norm());
      (d < 0.25 ? bright : elsewhere) += 1;
    }
  }
  EXPECT_GT(bright, 50);
  EXPECT_EQ(elsewhere, 0);
}

TEST_F(Simulation, ring_sensors_give_frames_with_times_and_rings) {
  options_.sensor = "os1_64";
  const Report report = run("out");
  const std::string points = bytes("out/frames/000001.bin"), times = bytes("out/frames/000001.time"),
                    rings = bytes("out/frames/000001.ring");
  ASSERT_GT(points.size(), 16u * 5000);
  const std::size_t n = points.size() / 16;
  EXPECT_EQ(times.size(), 4 * n);
  EXPECT_EQ(rings.size(), 2 * n);
  float last_time = -1;
  for (std::size_t i = 0; i < n; ++i) {
    float time = 0;
    std::memcpy(&time, times.data() + 4 * i, 4);
    EXPECT_GE(time, last_time);
    EXPECT_LT(time, 0.1f);
    last_time = time;
  }
  EXPECT_THAT(bytes("out/frames/sensor.json"), HasSubstr("os1_64"));
  std::istringstream starts(bytes("out/frames/times.txt"));
  double first = 0, second = 0;
  starts >> first >> second;
  EXPECT_NEAR(first, simulation_epoch_s, 1e-5);
  EXPECT_NEAR(second - first, 0.1, 1e-3);
}

// A sensor of the user's own: the reader finds its description beside the frames.
TEST_F(Simulation, the_description_of_an_own_sensor_lies_beside_its_frames) {
  options_.sensor = std::string(BOLE_SOURCE_DIR) + "/tests/bench/stems/dome_64.json";
  options_.max_time = 0.5;
  run("out");
  std::ifstream own(options_.sensor);
  EXPECT_EQ(bytes("out/frames/sensor.json"), std::string(std::istreambuf_iterator<char>(own), {}));
}

TEST_F(Simulation, stops_when_cancelled) {
  std::stop_source source;
  bole::Run with;
  with.cancel = source.get_token();
  options_.max_time = 100;
  with.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.07) source.request_stop();
  };
  try {
    run("out", with);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::cancelled);
  }
}

TEST_F(Simulation, finishes_early_when_asked) {
  std::stop_source source;
  bole::Run with;
  with.finish = source.get_token();
  options_.max_time = 100;
  with.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.07) source.request_stop();
  };
  const Report report = run("out", with);
  EXPECT_EQ(report.status, Status::finished_early);
  EXPECT_GT(report.counts.at("returns"), 0);
  EXPECT_LT(report.counts.at("pulses"), 5000000);
}

TEST_F(Simulation, wrong_options_are_explained) {
  const auto error = [&](auto&& change) -> std::string {
    SimulationOptions o = options_;
    change(o);
    try {
      simulate(o, dir_ / "out", {});
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error([](auto& o) { o.plot = "plot9"; }),
              testing::AllOf(HasSubstr("plot9"), HasSubstr("demo"), HasSubstr("plot1")));
  EXPECT_THAT(error([](auto& o) {
                o.plot = "demo";
                o.sensor = "vlp99";
              }),
              HasSubstr("vlp99"));
  EXPECT_THAT(error([](auto& o) {
                o.plot = "demo";
                o.walk = "/nowhere.csv";
              }),
              HasSubstr("/nowhere.csv"));
  OptionSet set(option_table(static_cast<const SimulationOptions*>(nullptr)));
  EXPECT_THROW(set.set_text("max_time", "0.01"), Error);
  EXPECT_THROW(set.set_text("speed", "50"), Error);
}

TEST_F(Simulation, follows_a_walk_from_a_file) {
  std::ofstream(dir_ / "walk.csv") << "x_m,y_m\n-3,-4\n3,-4\n";
  options_.walk = (dir_ / "walk.csv").string();
  options_.max_time.reset();
  options_.speed = 3;
  options_.rotation_hz = 5;
  run("out");
  const Trajectory trajectory = read_tum(bytes("out/trajectory.tum"));
  EXPECT_LT((trajectory.poses.front().T_target_sensor.translation().head<2>() - Eigen::Vector2d(-3, -4)).norm(), 0.5);
  EXPECT_LT((trajectory.poses.back().T_target_sensor.translation().head<2>() - Eigen::Vector2d(3, -4)).norm(), 0.5);
}

// The unit has random streams of its own: the recording beside it is the same to the byte.
TEST_F(Simulation, an_inertial_unit_leaves_the_recording_alone) {
  run("without");
  options_.imu = ImuGrade::consumer;
  run("with");
  EXPECT_EQ(bytes("with/walk.pcap"), bytes("without/walk.pcap"));
  EXPECT_EQ(bytes("with/trajectory.tum"), bytes("without/trajectory.tum"));
  EXPECT_FALSE(fs::exists(dir_ / "without/imu.csv"));
  const auto text = bytes("with/imu.csv");
  EXPECT_THAT(text, HasSubstr("# T_sensor_imu: 0.045000 -0.030000 -0.060000 "));
  EXPECT_THAT(text, HasSubstr("\ntime_s,gyro_x_rad_s,"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 101 + 7);
  options_.imu_mount_known = false;
  run("unknown");
  EXPECT_THAT(bytes("unknown/imu.csv"), testing::Not(HasSubstr("T_sensor_imu")));
}

TEST_F(Simulation, wind_and_all_that_spoils_a_scan_give_the_same_bytes_at_any_thread_count) {
  recipe_.understorey.poles_per_ha = 300;
  options_.max_time = 0.3;
  options_.wind = 6;
  options_.wet = 0.5;
  options_.dual_return = true;
  options_.operator_body = true;
  options_.angle_error = 0.05;
  options_.clock_jitter = 0.001;
  options_.carrier = Carrier::backpack;
  run("a");
  {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    run("b");
  }
  EXPECT_FALSE(bytes("a/walk.pcap").empty());
  EXPECT_TRUE(bytes("a/walk.pcap") == bytes("b/walk.pcap"));
  options_.wind = 0;
  run("c");
  EXPECT_FALSE(bytes("a/walk.pcap") == bytes("c/walk.pcap"));
  EXPECT_TRUE(bytes("a/trees.csv") == bytes("c/trees.csv"));  // the truth is that of trees at rest
}

TEST_F(Simulation, dual_returns_are_in_the_packets) {
  recipe_.understorey.shrubs_per_ha = 3000;
  options_.dual_return = true;
  const Report report = run("out");
  const sensor::VelodyneDecoder decoder(sensor::load_sensor_model("vlp32c"));
  const std::string pcap = bytes("out/walk.pcap");
  std::vector<sensor::VelodyneReturn> returns;
  std::int64_t first = 0, second = 0;
  for (std::size_t at = 24 + 58; at + sensor::velodyne_packet_bytes <= pcap.size();
       at += 58 + sensor::velodyne_packet_bytes) {
    const auto packet = sensor::parse_velodyne_packet(
        {reinterpret_cast<const std::uint8_t*>(pcap.data()) + at, sensor::velodyne_packet_bytes});
    ASSERT_TRUE(packet);
    EXPECT_TRUE(packet->is_dual());
    returns.clear();
    decoder.decode(*packet, returns);
    for (const auto& r : returns) (r.return_number == 1 ? first : second) += 1;
  }
  EXPECT_GT(second, first / 200);
  EXPECT_NEAR(static_cast<double>(first + second), static_cast<double>(report.counts.at("returns")), 10);
  options_.sensor = "os1_64";
  EXPECT_THROW(run("frames"), Error);
}

// Sensors of other makers: packets, with the file that readers find beside them.
TEST_F(Simulation, dual_returns_of_other_makers_are_in_packets) {
  recipe_.understorey.shrubs_per_ha = 3000;
  options_.max_time = 0.3;
  for (const auto& [name, beside] : {std::pair{"os0_32", "walk.json"}, std::pair{"pandar_xt32", "walk.csv"}}) {
    options_.sensor = name;
    options_.dual_return = false;
    const auto single = run(std::string(name) + "_single").counts.at("returns");
    EXPECT_TRUE(fs::exists(dir_ / (std::string(name) + "_single") / "frames"));
    options_.dual_return = true;
    const auto both = run(name).counts.at("returns");
    EXPECT_GT(both, single + single / 200) << name;
    EXPECT_TRUE(fs::exists(dir_ / name / "walk.pcap"));
    EXPECT_TRUE(fs::exists(dir_ / name / beside));
  }
}

// Points of a rosette and true poses give back the ground; its frames last 0.1 s and cover the field of view.
TEST_F(Simulation, rosettes_give_frames_over_their_field_of_view) {
  recipe_.size_m = 40;
  options_.sensor = "mid360";
  options_.max_time = 1.2;
  options_.noise = 0;
  options_.mount_tilt = 180;  // the field of view looks up, so that the sensor hangs upside down
  run("out");
  const Trajectory trajectory = read_tum(bytes("out/trajectory.tum"));
  const std::string points = bytes("out/frames/000005.bin"), times = bytes("out/frames/000005.time"),
                    rings = bytes("out/frames/000005.ring");
  const std::size_t n = points.size() / 16;
  ASSERT_GT(n, 10000u);
  ASSERT_LE(n, 20100u);
  std::istringstream starts(bytes("out/frames/times.txt"));
  double start = 0;
  for (int i = 0; i <= 5; ++i) starts >> start;
  EXPECT_NEAR(start, simulation_epoch_s + 0.5, 1e-3);
  const sim::Terrain terrain = sim::make_forest(recipe_, 1).terrain;
  double lowest = 90, highest = -90;
  int on_ground = 0;
  std::vector<int> sector(36);
  for (std::size_t i = 0; i < n; ++i) {
    float p[4], time = 0;
    std::uint16_t ring = 9;
    std::memcpy(p, points.data() + 16 * i, 16);
    std::memcpy(&time, times.data() + 4 * i, 4);
    std::memcpy(&ring, rings.data() + 2 * i, 2);
    EXPECT_EQ(ring, 0);
    EXPECT_LT(time, 0.1f);
    const double elevation = 57.2958 * std::atan2(p[2], std::hypot(p[0], p[1]));
    lowest = std::min(lowest, elevation);
    highest = std::max(highest, elevation);
    sector[static_cast<std::size_t>(18 + std::floor(17.999 * std::atan2(p[1], p[0]) / std::numbers::pi))] += 1;
    const Eigen::Vector3d at = trajectory.at(start + static_cast<double>(time)) * Eigen::Vector3d(p[0], p[1], p[2]);
    on_ground += std::abs(at.z() - terrain.height(at.x(), at.y())) < 0.03;
  }
  EXPECT_GT(on_ground, static_cast<int>(0.8 * static_cast<double>(n)));
  EXPECT_GE(lowest, -7.01);
  EXPECT_NEAR(highest, 52, 0.5);
  for (const int count : sector) EXPECT_GT(count, 150);
  EXPECT_THAT(bytes("out/frames/sensor.json"), HasSubstr("mid360"));
}

}  // namespace
}  // namespace bole::sim
