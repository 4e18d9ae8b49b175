#include "sensor/core/sensor_model.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "base/error.h"

namespace bole::sensor {
namespace {

using testing::HasSubstr;

template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

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
    std::set<int> rings;
    for (const auto& c : model.channels) rings.insert(c.ring);
    EXPECT_EQ(static_cast<int>(rings.size()), model.rings()) << name;
    EXPECT_EQ(*rings.begin(), 0) << name;
    const auto elevations = model.ring_elevations_rad();
    EXPECT_TRUE(std::ranges::is_sorted(elevations)) << name;
  }
  EXPECT_THAT(sensor_model_names(), testing::IsSupersetOf({"vlp16", "vlp32c", "hdl32e", "hdl64e_s2", "os1_64"}));
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
