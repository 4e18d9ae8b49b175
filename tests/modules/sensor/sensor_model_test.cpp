#include "sensor/core/sensor_model.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "base/error.h"
#include "checks.h"

namespace bole::sensor {
namespace {

using testing::HasSubstr;
using testing_checks::error_of;

nlohmann::json small_model() {
  return nlohmann::json::parse(
      R"({"elevation_deg": [1, -1], "azimuth_offset_deg": [0, 0], "firing_time_us": [0, 2], "sequence_period_us": 50, "rotation_hz": 10,
    "range_quantum_m": 0.002, "min_range_m": 0.5, "max_range_m": 100, "range_sigma_m": 0.02, "beam_divergence_horizontal_mrad": 3, "beam_divergence_vertical_mrad": 1.5,
    "aperture_horizontal_mm": 9.5, "aperture_vertical_mm": 12.7})");
}

TEST(SensorModel, EveryFileLoadsAndNumbersItsRingsFromTheLowestBeam) {
  for (const auto& name : sensor_model_names()) {
    const auto model = load_sensor_model(name);
    EXPECT_EQ(model.id, name);
    EXPECT_FALSE(model.source.empty()) << name;
    EXPECT_GT(model.range_sigma_m, 0) << name;
    EXPECT_GT(model.beam_divergence_horizontal_rad, 0) << name;
    EXPECT_EQ(model.pattern() == ScanPattern::rosette, model.channels.empty()) << name;
    std::set<int> rings;
    for (const auto& c : model.channels) rings.insert(c.ring);
    if (model.rosette) continue;
    EXPECT_EQ(static_cast<int>(rings.size()), model.rings()) << name;
    EXPECT_EQ(*rings.begin(), 0) << name;
    const auto elevations = model.ring_elevations_rad();
    EXPECT_TRUE(std::ranges::is_sorted(elevations)) << name;
  }
  EXPECT_THAT(sensor_model_names(),
              testing::IsSupersetOf({"vlp16", "vlp32c", "vls128", "hdl32e", "hdl64e_s2", "os0_32", "os0_64", "os0_128",
                                     "os1_32", "os1_64", "os1_128", "os2_32", "os2_64", "os2_128", "pandar_xt32",
                                     "pandar40p", "horizon", "avia", "mid360"}));
}

// VLP-16 user manual, table 9-1: millimetres by the laser's angle.
TEST(SensorModel, LasersOfTheVlp16HaveTheHeightsOfItsManual) {
  const std::map<int, double> heights_mm{{15, -11.2}, {13, -9.7}, {11, -8.1}, {9, -6.6},
                                         {7, -5.1},   {5, -3.7},  {3, -2.2},  {1, -0.7}};
  for (const auto& c : load_sensor_model("vlp16").channels) {
    const auto angle_deg = static_cast<int>(std::lround(c.elevation_rad * 180 / std::numbers::pi));
    const double height_mm = angle_deg > 0 ? heights_mm.at(angle_deg) : -heights_mm.at(-angle_deg);
    EXPECT_NEAR(1e3 * c.offsets.height, height_mm, 1e-9) << angle_deg;
  }
  auto json = small_model();
  EXPECT_FALSE(has_laser_heights(sensor_model_from_json(json, "own")));
  json["height_offset_mm"] = {5, -5};
  EXPECT_NEAR(sensor_model_from_json(json, "own").channels[1].offsets.height, -0.005, 1e-15);
  json["height_offset_mm"] = {5};
  EXPECT_THAT(error_of([&] { sensor_model_from_json(json, "own"); }), HasSubstr("height_offset_mm"));
}

TEST(SensorModel, NamesAreFoundAsTheMakerWritesThem) {
  for (const auto& [name, id] : std::map<std::string, std::string>{{"VLS-128", "vls128"},
                                                                   {"OS1-128", "os1_128"},
                                                                   {"OS1-64 Rev7", "os1_64_rev7"},
                                                                   {"Ouster OS0-32", "os0_32"},
                                                                   {"PandarXT-32", "pandar_xt32"},
                                                                   {"XT-32", "pandar_xt32"},
                                                                   {"Livox Mid-360", "mid360"}})
    EXPECT_EQ(load_sensor_model(name).id, id) << name;
  EXPECT_THAT(error_of([] { load_sensor_model("128"); }), HasSubstr("there is no sensor '128'"));
  EXPECT_THAT(error_of([] { load_sensor_model("0_32"); }), HasSubstr("there is no sensor"));
}

TEST(SensorModel, TheFieldsOfViewAreThoseOfTheDataSheets) {
  constexpr double deg = std::numbers::pi / 180;
  const std::map<std::string, std::pair<double, double>> fields{
      {"vls128", {-25, 15}},       {"os0_128", {-45, 45}},     {"os1_32", {-21.2, 21.2}},
      {"os2_64", {-11.25, 11.25}}, {"pandar_xt32", {-16, 15}}, {"pandar40p", {-24.985, 14.794}}};
  for (const auto& [name, field] : fields) {
    const auto elevations = load_sensor_model(name).ring_elevations_rad();
    EXPECT_NEAR(elevations.front(), field.first * deg, 1e-6) << name;
    EXPECT_NEAR(elevations.back(), field.second * deg, 1e-6) << name;
  }
}

TEST(SensorModel, ARosetteHasAFieldOfViewAndNoLines) {
  constexpr double deg = std::numbers::pi / 180;
  const auto model = load_sensor_model("mid360");
  ASSERT_TRUE(model.rosette);
  EXPECT_EQ(model.pattern(), ScanPattern::rosette);
  EXPECT_EQ(model.rings(), 1);
  EXPECT_TRUE(model.ring_elevations_rad().empty());
  EXPECT_EQ(model.rosette->points_per_s, 200000);
  EXPECT_NEAR(model.sequence_period_s, 4 / 200000.0, 1e-12);
  EXPECT_NEAR(model.rosette->horizontal_fov_rad, 360 * deg, 1e-9);
  EXPECT_NEAR(model.rosette->min_elevation_rad, -7 * deg, 1e-9);
  EXPECT_NEAR(model.rosette->max_elevation_rad, 52 * deg, 1e-9);
  EXPECT_TRUE(model.beam_assumed);
}

TEST(SensorModel, Vlp32cHasTheBeamsOfTheManual) {
  const auto model = load_sensor_model("VLP-32C");
  constexpr double deg = std::numbers::pi / 180;
  EXPECT_EQ(model.id, "vlp32c");
  ASSERT_EQ(model.rings(), 32);
  EXPECT_NEAR(model.channels[0].elevation_rad, -25 * deg, 1e-9);
  EXPECT_NEAR(model.channels[0].azimuth_offset_rad, 1.4 * deg, 1e-9);
  EXPECT_NEAR(model.channels[1].azimuth_offset_rad, -4.2 * deg, 1e-9);
  EXPECT_NEAR(model.channels[29].elevation_rad, 15 * deg, 1e-9);
  EXPECT_EQ(model.channels[0].ring, 0);
  EXPECT_EQ(model.channels[29].ring, 31);
  EXPECT_NEAR(model.channels[31].firing_time_s, 15 * 2.304e-6, 1e-12);
}

TEST(SensorModel, ErrorsNameTheEntry) {
  EXPECT_THAT(error_of([] { load_sensor_model("vlp99"); }), HasSubstr("vlp16, vlp32c"));
  EXPECT_THAT(error_of([] { load_sensor_model("/nowhere/x.json"); }), HasSubstr("/nowhere/x.json"));
  auto json = small_model();
  EXPECT_EQ(sensor_model_from_json(json, "mine").rings(), 2);
  json["azimuth_offset_deg"] = {0};
  EXPECT_THAT(error_of([&] { sensor_model_from_json(json, "mine"); }), HasSubstr("'azimuth_offset_deg' has 1 entries"));
  json = small_model();
  json["range_quantum_m"] = "two";
  EXPECT_THAT(error_of([&] { sensor_model_from_json(json, "mine"); }), HasSubstr("range_quantum_m"));
  json = small_model();
  json["packet"] = "velodyne";
  json["sequences_per_block"] = 1;
  EXPECT_THAT(error_of([&] { sensor_model_from_json(json, "mine"); }), HasSubstr("2 lasers"));
}

}  // namespace
}  // namespace bole::sensor
