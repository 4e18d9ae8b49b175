#include "sim/core/scene/beam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "sensor/core/spinning_beams.h"

namespace bole::sim {
namespace {

sensor::SensorModel one_laser() {
  sensor::SensorModel sensor = sensor::load_sensor_model("vlp32c");
  sensor.channels = {sensor::LaserChannel{}};
  return sensor;
}

// A wall at x, from y0 to y1, 20 m high, facing the sensor.
Piece wall(float x, float y0, float y1, Material material = Material::bark, float reflectivity = 0.4f) {
  Piece piece{{}, material, reflectivity, 0, 0};
  piece.mesh.vertices = {{x, y0, -10}, {x, y1, -10}, {x, y1, 10}, {x, y0, 10}};
  piece.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return piece;
}

BeamParameters exact() {
  BeamParameters p;
  p.noise = p.dropouts = 0;
  return p;
}

struct Shot {
  std::vector<Piece> pieces;
  BeamParameters parameters = exact();
  // Echoes of `count` pulses along +x.
  std::vector<sensor::LaserEcho> fire(int count) const {
    SceneModel model;
    model.pieces = pieces;
    const RayScene scene(model);
    const sensor::SensorModel sensor = one_laser();
    const Beam beam(sensor, parameters, scene, 1);
    std::vector<sensor::LaserEcho> echoes;
    for (int i = 0; i < count; ++i) echoes.push_back(beam.fire(Pose::Identity(), 0, 0, static_cast<std::uint64_t>(i)));
    return echoes;
  }
};

TEST(Beam, measures_a_wall_exactly_without_noise) {
  for (const auto& echo : Shot{{wall(7.25f, -5, 5)}}.fire(50)) EXPECT_NEAR(echo.range_m, 7.25, 1e-4);
}

// What a sensor measures of a wall and a floor comes back as one, wherever its lasers stand.
TEST(Beam, the_decoder_puts_lasers_where_the_simulator_has_them) {
  SceneModel model;
  Piece floor = wall(0, 0, 0);
  floor.mesh.vertices = {{-20, -20, -1.5}, {20, -20, -1.5}, {20, 20, -1.5}, {-20, 20, -1.5}};
  model.pieces = {wall(7.25f, -9, 9), floor};
  const RayScene scene(model);
  sensor::SensorModel sensor = sensor::load_sensor_model("vlp16");
  ASSERT_TRUE(sensor::has_laser_heights(sensor));
  sensor.channels[3].offsets = {0.9, 0.2, -0.03, 0, 0, false, 0};  // as a laser of an HDL-64E
  sensor.channels[4].offsets = {0, 0, 0, 0, 0, false, 1};
  BeamParameters parameters = exact();
  parameters.divergence = 0;
  const Beam beam(sensor, parameters, scene, 1);
  const sensor::SpinningBeams beams(sensor);
  for (std::size_t c = 0; c < sensor.channels.size(); ++c)
    for (const int azimuth_deg : {-30, 0, 20}) {
      const double azimuth_rad = azimuth_deg * std::numbers::pi / 180;
      const auto echo = beam.fire(Pose::Identity(), c, azimuth_rad, c);
      ASSERT_GT(echo.range_m, 0) << c;
      std::vector<sensor::VelodyneReturn> out;
      sensor::VelodyneFiring firing{0, true, 100.0 * azimuth_deg, 0, 0};
      beams.append(echo.range_m, 1, c, firing, 1, 0, 0, 1, out);
      const auto& p = out.at(0).position;
      EXPECT_LT(std::min(std::abs(p.x() - 7.25f), std::abs(p.z() + 1.5f)), 1e-4f) << c << " " << azimuth_deg;
    }
  sensor.channels[5].offsets.two_points = true;
  EXPECT_THROW(Beam(sensor, parameters, scene, 1), Error);
}

TEST(Beam, noise_has_the_sigma_of_the_sensor) {
  Shot shot{{wall(7.25f, -5, 5)}};
  shot.parameters.noise = 1;
  shot.parameters.laser_bias_m = 0;
  double sum = 0, squares = 0;
  const auto echoes = shot.fire(4000);
  for (const auto& e : echoes) {
    sum += e.range_m - 7.25;
    squares += std::pow(e.range_m - 7.25, 2);
  }
  const double n = static_cast<double>(echoes.size()), sigma = one_laser().range_sigma_m;
  EXPECT_NEAR(sum / n, 0, 4 * sigma / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), sigma, 0.05 * sigma);
}

TEST(Beam, lasers_have_biases_of_their_own) {
  SceneModel model;
  model.pieces = {wall(7.25f, -5, 5)};
  const RayScene scene(model);
  sensor::SensorModel sensor = one_laser();
  sensor.channels.resize(40);
  BeamParameters parameters = exact();
  parameters.noise = 1e-3;
  parameters.laser_bias_m = 4;  // metres, times the factor on noise: 4 mm
  const Beam beam(sensor, parameters, scene, 1);
  double squares = 0;
  for (std::size_t c = 0; c < 40; ++c) squares += std::pow(beam.fire(Pose::Identity(), c, 0, c).range_m - 7.25, 2);
  EXPECT_NEAR(std::sqrt(squares / 40), 0.004, 0.0015);
}

TEST(Beam, an_edge_before_a_near_wall_gives_mixed_pixels) {
  // The beam is half on the edge of a wall 0.3 m in front of another: ranges in between. 3 m apart: one or the other.
  int between_near = 0, between_far = 0;
  for (const auto& e : Shot{{wall(8, 0, 5), wall(8.3f, -5, 5)}}.fire(200))
    between_near += e.range_m > 8.02f && e.range_m < 8.28f;
  for (const auto& e : Shot{{wall(8, 0, 5), wall(11, -5, 5)}}.fire(200))
    between_far += e.range_m > 8.02f && e.range_m < 10.98f;
  EXPECT_GT(between_near, 150);
  EXPECT_EQ(between_far, 0);
}

TEST(Beam, without_divergence_there_are_no_mixed_pixels) {
  Shot shot{{wall(8, 0.001f, 5), wall(8.3f, -5, 5)}};
  shot.parameters.divergence = 0;
  for (const auto& e : shot.fire(100)) EXPECT_NEAR(e.range_m, 8.3, 1e-4);
}

TEST(Beam, an_edge_is_seen_from_outside_it) {
  // Aimed 1 cm past the edge, part of the beam still meets it: with nothing behind, the point is reported off the wall.
  int seen = 0;
  for (const auto& e : Shot{{wall(10, 0.01f, 5)}}.fire(100)) seen += e.range_m > 0;
  EXPECT_GT(seen, 90);
  seen = 0;
  for (const auto& e : Shot{{wall(10, 0.10f, 5)}}.fire(100)) seen += e.range_m > 0;
  EXPECT_EQ(seen, 0);
}

TEST(Beam, foil_shines_and_bark_does_not) {
  for (const auto& e : Shot{{wall(9, -5, 5, Material::retro, 1)}}.fire(100)) EXPECT_GE(e.intensity, 190);
  for (const auto& e : Shot{{wall(9, -5, 5)}}.fire(100)) {
    EXPECT_GE(e.intensity, 20);
    EXPECT_LE(e.intensity, 60);
  }
}

TEST(Beam, dark_surfaces_far_away_are_lost) {
  int near = 0, far = 0;
  for (const auto& e : Shot{{wall(20, -5, 5, Material::bark, 0.1f)}}.fire(200)) near += e.range_m > 0;
  for (const auto& e : Shot{{wall(180, -50, 50, Material::bark, 0.1f)}}.fire(200)) far += e.range_m > 0;
  EXPECT_GT(near, 195);
  EXPECT_LT(far, 40);
}

TEST(Beam, too_near_is_no_return) {
  for (const auto& e : Shot{{wall(0.3f, -5, 5)}}.fire(20)) EXPECT_EQ(e.range_m, 0);
}

TEST(Beam, the_same_pulse_gives_the_same_echo) {
  Shot shot{{wall(7, -5, 5)}};
  shot.parameters.noise = 1;
  const auto a = shot.fire(50), b = shot.fire(50);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].range_m, b[i].range_m);
  EXPECT_NE(a[0].range_m, a[1].range_m);
}

TEST(Beam, wet_bark_is_darker_and_loses_pulses) {
  Shot shot{{wall(9, -5, 5)}};
  double dry = 0, wet = 0, kept = 0;
  const int n = 2000;
  for (const auto& e : shot.fire(n)) dry += e.intensity;
  shot.parameters.wet = 1;
  for (const auto& e : shot.fire(n)) {
    if (!(e.range_m > 0)) continue;
    EXPECT_NEAR(e.range_m, 9, 1e-4);
    wet += e.intensity;
    kept += 1;
  }
  EXPECT_NEAR(kept / n, 0.9, 0.02);
  EXPECT_NEAR(wet / kept, 0.5 * dry / n, 0.05 * dry / n);
  // Foil stays what it is.
  Shot foil{{wall(9, -5, 5, Material::retro, 1)}};
  foil.parameters.wet = 1;
  for (const auto& e : foil.fire(100)) EXPECT_GE(e.intensity, 190);
}

// A wall at 45 degrees tells by its range where the beam points.
TEST(Beam, lasers_point_beside_their_angles_by_a_constant_error) {
  SceneModel model;
  Piece slanted{{}, Material::bark, 0.4f, 0, 0};
  slanted.mesh.vertices = {{0, 10, -10}, {20, -10, -10}, {20, -10, 10}, {0, 10, 10}};
  slanted.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  model.pieces = {slanted};
  const RayScene scene(model);
  sensor::SensorModel sensor = one_laser();
  sensor.channels.resize(60);
  BeamParameters parameters = exact();
  parameters.angle_error_rad = 0.002;
  parameters.divergence = 0;
  const Beam beam(sensor, parameters, scene, 3);
  double squares = 0;
  for (std::size_t c = 0; c < 60; ++c) {
    const double range = static_cast<double>(beam.fire(Pose::Identity(), c, 0, c).range_m);
    EXPECT_NEAR(static_cast<double>(beam.fire(Pose::Identity(), c, 0, c + 1000).range_m), range, 1e-5);  // constant
    squares += std::pow((range - 10) / 10, 2);  // range of the slant: 10 / (1 - tan a)
  }
  EXPECT_NEAR(std::sqrt(squares / 60), 0.002, 0.0006);
}

TEST(Beam, dual_return_tells_two_surfaces_apart) {
  SceneModel model;
  model.pieces = {wall(8, 0, 5), wall(11, -5, 5)};  // half of the beam meets each
  const RayScene scene(model);
  const sensor::SensorModel sensor = one_laser();
  BeamParameters parameters = exact();
  parameters.dual = true;
  const Beam beam(sensor, parameters, scene, 1);
  int both = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Echoes e = beam.fire(Pose::Identity(), 0, 0, i, 0);
    EXPECT_NEAR(e.last.range_m, 11, 1e-3);
    both += std::abs(e.strongest.range_m - 8) < 1e-3f;
    // Without dual return the strongest is the same where it is not the last.
    const auto single = Beam(sensor, exact(), scene, 1).fire(Pose::Identity(), 0, 0, i);
    if (std::abs(single.range_m - 8) < 1e-3f) {
      EXPECT_EQ(single.range_m, e.strongest.range_m);
    }
  }
  EXPECT_EQ(both, 200);
  // The two strongest are the same two, the stronger first.
  parameters.by_strength = true;
  const Beam by_strength(sensor, parameters, scene, 1);
  int nearer_first = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Echoes pair = by_strength.fire(Pose::Identity(), 0, 0, i, 0);
    const auto single = Beam(sensor, exact(), scene, 1).fire(Pose::Identity(), 0, 0, i);
    EXPECT_EQ(pair.strongest.range_m, single.range_m);
    EXPECT_NEAR(pair.strongest.range_m + pair.last.range_m, 19, 2e-3);
    nearer_first += pair.strongest.range_m < 9;
  }
  EXPECT_GT(nearer_first, 100);
  // One surface: both are the same.
  parameters.by_strength = false;
  SceneModel alone;
  alone.pieces = {wall(9, -5, 5)};
  const RayScene one(alone);
  const Echoes e = Beam(sensor, parameters, one, 1).fire(Pose::Identity(), 0, 0, 0, 0);
  EXPECT_NEAR(e.strongest.range_m, 9, 1e-3);
  EXPECT_EQ(e.strongest.range_m, e.last.range_m);
}

}  // namespace
}  // namespace bole::sim
