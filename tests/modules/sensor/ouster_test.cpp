#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "base/error.h"
#include "checks.h"
#include "ouster_packets.h"
#include "sensor/core/ouster_decoder.h"
#include "sensor/core/ouster_encoder.h"

namespace bole::sensor {
namespace {

using testing::HasSubstr;
using testing_checks::error_of;
namespace maker = testing_ouster;

maker::Sensor small_sensor(const std::string& profile) {
  maker::Sensor sensor;
  sensor.profile = profile;
  for (int i = 0; i < 32; ++i) {
    sensor.elevations_deg.push_back(15.5 - i);
    sensor.azimuths_deg.push_back(i % 2 == 0 ? 0 : -1.4);
  }
  return sensor;
}

std::span<const std::uint8_t> bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

maker::Column column(int id, std::uint32_t first_mm, std::uint32_t second_mm) {
  maker::Column c;
  c.id = static_cast<std::uint16_t>(id);
  c.time_ns = 1'000'000'000U + static_cast<std::uint64_t>(id) * 100'000;
  c.first.assign(32, {first_mm, 40});
  c.second.assign(32, {second_mm, 50});
  return c;
}

std::string packet_of(const maker::Sensor& sensor, int first_column = 0) {
  std::vector<maker::Column> columns;
  for (int i = 0; i < 16; ++i) columns.push_back(column(first_column + i, 4000, 8000));
  return sensor.packet(77, columns);
}

TEST(Ouster, BothLayoutsOfTheMetadataSayTheSame) {
  const auto sensor = small_sensor("RNG15_RFL8_NIR8");
  for (const bool nested : {false, true}) {
    const auto text = sensor.metadata(nested).dump();
    EXPECT_TRUE(looks_like_ouster_metadata(text));
    const auto m = parse_ouster_metadata(text);
    EXPECT_EQ(m.model.id, "os1_32");
    EXPECT_EQ(m.model.name, "OS-1-32");
    EXPECT_EQ(m.model.rings(), 32);
    EXPECT_EQ(m.model.channels[0].ring, 31);
    EXPECT_EQ(m.profile, OusterProfile::low_rate);
    EXPECT_EQ(m.columns_per_frame, 64);
    EXPECT_NEAR(m.beam_origin_forward_m, 0.015806, 1e-9);
    EXPECT_NEAR(m.T_sensor_lidar.translation().z(), 0.03618, 1e-9);
    EXPECT_NEAR(m.T_sensor_imu.translation().x(), 0.006253, 1e-9);
    EXPECT_EQ(m.serial_number, 992137000142U);
    EXPECT_FALSE(m.series_assumed);
  }
}

TEST(Ouster, ErrorsOfTheMetadataNameTheEntry) {
  const auto good = small_sensor("LEGACY").metadata(false);
  const auto error_with = [&](const char* key, const nlohmann::json& value) {
    auto json = good;
    json[key] = value;
    return error_of([&] { parse_ouster_metadata(json.dump()); });
  };
  EXPECT_THAT(error_of([] { parse_ouster_metadata("{\"a\": 1}"); }), HasSubstr("beam_altitude_angles"));
  EXPECT_THAT(error_of([] { parse_ouster_metadata("not json"); }), HasSubstr("not a JSON object"));
  EXPECT_THAT(error_with("beam_azimuth_angles", {1, 2}), HasSubstr("32 beam altitude angles and 2"));
  EXPECT_THAT(error_with("udp_profile_lidar", "FIVE_WORD_PIXEL"), HasSubstr("FIVE_WORD_PIXEL"));
  EXPECT_THAT(error_with("lidar_to_sensor_transform", std::vector<double>(16, 1)), HasSubstr("no rigid motion"));
  EXPECT_THAT(error_with("columns_per_packet", 1e9), HasSubstr("columns_per_packet"));
  EXPECT_THAT(error_with("column_window", {0, 64}), HasSubstr("column_window"));
}

TEST(Ouster, EveryProfileGivesTheRangesThatWereWritten) {
  for (const std::string profile :
       {"LEGACY", "RNG19_RFL8_SIG16_NIR16", "RNG19_RFL8_SIG16_NIR16_DUAL", "RNG15_RFL8_NIR8"}) {
    const auto sensor = small_sensor(profile);
    const OusterDecoder decoder(parse_ouster_metadata(sensor.metadata(true).dump()));
    const auto packet = packet_of(sensor);
    ASSERT_EQ(packet.size(), decoder.lidar_packet_bytes()) << profile;
    const auto head = decoder.head(bytes(packet));
    ASSERT_TRUE(head);
    EXPECT_EQ(head->frame_id, 77);
    EXPECT_EQ(head->valid_columns, 16);
    EXPECT_EQ(head->first_time_ns, 1'000'000'000);
    EXPECT_EQ(head->last_time_ns, 1'001'500'000);
    std::vector<OusterReturn> returns;
    decoder.decode(bytes(packet), returns);
    const bool dual = profile.ends_with("DUAL");
    ASSERT_EQ(returns.size(), dual ? 1024U : 512U) << profile;
    for (const auto& r : returns) {
      EXPECT_FLOAT_EQ(r.range_m, r.return_number == 1 ? 4 : 8) << profile;
      EXPECT_EQ(r.reflectivity, r.return_number == 1 ? 40 : 50) << profile;
    }
  }
}

// Where the settings order the returns by distance, the signals tell which is the strongest.
TEST(Ouster, TheStrongestReturnIsNumberOneInAnyOrder) {
  const auto model = load_sensor_model("os0_32");
  std::vector<std::uint8_t> packet;
  OusterEncoder encoder(model, 10, true,
                        [&](std::span<const std::uint8_t> p, double) { packet.assign(p.begin(), p.end()); });
  const std::vector<LaserEcho> near(32, {3, 10}), far(32, {7, 200});
  for (int c = 0; c < 16; ++c)
    encoder.add(1.7e9 + c * model.sequence_period_s, std::numbers::pi * (1 + c / 512.0), near, far);
  encoder.flush();
  for (const std::string order : {"", "STRONGEST_TO_WEAKEST", "NEAREST_TO_FARTHEST", "LAST_RETURN_FIRST"}) {
    auto json = nlohmann::json::parse(encoder.metadata());
    if (!order.empty()) json["config_params"]["return_order"] = order;
    const OusterDecoder decoder(parse_ouster_metadata(json.dump()));
    EXPECT_EQ(decoder.metadata().return_order, order);
    std::vector<OusterReturn> returns;
    decoder.decode(packet, returns);
    ASSERT_EQ(returns.size(), 2U * 16 * 32);
    const bool as_sent = order.empty() || order == "STRONGEST_TO_WEAKEST";
    for (const auto& r : returns) EXPECT_FLOAT_EQ(r.range_m, (r.return_number == 1) == as_sent ? 3 : 7) << order;
  }
}

TEST(Ouster, AxesAreForwardLeftUpAndTheColumnsTurnClockwise) {
  const auto sensor = small_sensor("RNG19_RFL8_SIG16_NIR16");
  auto json = sensor.metadata(true);
  json["beam_intrinsics"]["beam_altitude_angles"][15] = 0;
  const OusterDecoder decoder(parse_ouster_metadata(json.dump()));
  const Eigen::Vector3f up(0, 0, 0.03618F);
  const std::vector<std::pair<int, Eigen::Vector3f>> expected{
      {0, {-4, 0, 0}}, {16, {0, 4, 0}}, {32, {4, 0, 0}}, {48, {0, -4, 0}}};
  for (const auto& [id, place] : expected) {
    std::vector<OusterReturn> returns;
    auto c = column(id, 0, 0);
    c.first[14] = {4000, 1};  // azimuth offset 0, elevation 1.5 degrees
    c.first[15] = {4000, 1};  // azimuth offset -1.4 degrees: anticlockwise, elevation 0
    decoder.decode(bytes(sensor.packet(1, std::vector<maker::Column>(16, c))), returns);
    ASSERT_EQ(returns.size(), 32U);
    // The beam leaves 15.806 mm off the axis: the range is along the beam from there on.
    const double elevation = 1.5 * std::numbers::pi / 180;
    const double horizontal = 0.015806 + (4 - 0.015806) * std::cos(elevation);
    const Eigen::Vector3f straight = place / 4 * static_cast<float>(horizontal) +
                                     Eigen::Vector3f(0, 0, static_cast<float>((4 - 0.015806) * std::sin(elevation)));
    EXPECT_LT((returns[0].position - straight - up).norm(), 1e-5) << id;
    const Eigen::Vector3f turned = returns[1].position - up;
    EXPECT_NEAR(turned.z(), 0, 1e-6);
    EXPECT_GT(place.cross(turned).z(), 0) << id;  // left of the column's direction
  }
}

TEST(Ouster, ColumnsThatAreNotValidOrNotInTheFrameAreLeftOut) {
  const auto sensor = small_sensor("LEGACY");
  const OusterDecoder decoder(parse_ouster_metadata(sensor.metadata(false).dump()));
  std::vector<maker::Column> columns;
  for (int i = 0; i < 16; ++i) {
    columns.push_back(column(i == 3 ? 64 : i, 4000, 0));
    columns.back().valid = i != 5;
  }
  columns[7].time_ns = std::numeric_limits<std::int64_t>::max() - 55'000;  // the year 2262: damage
  const auto packet = sensor.packet(9, columns);
  EXPECT_EQ(decoder.head(bytes(packet))->valid_columns, 13);
  std::vector<OusterReturn> returns;
  decoder.decode(bytes(packet), returns);
  EXPECT_EQ(returns.size(), 13U * 32);
  EXPECT_FALSE(decoder.head(bytes(packet.substr(1))));
  returns.clear();
  decoder.decode(bytes(packet.substr(1)), returns);
  EXPECT_TRUE(returns.empty());
}

TEST(Ouster, InertialPacketsAreInStandardUnits) {
  const auto packet = maker::Sensor::inertial_packet(5'000'000'000, {0, 0.5F, 1}, {180, 0, -90});
  const auto sample = OusterDecoder::inertial_sample(bytes(packet));
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->time_s, 5, 1e-12);
  EXPECT_NEAR(sample->specific_force_m_s2.z(), 9.80665, 1e-9);
  EXPECT_NEAR(sample->specific_force_m_s2.y(), 0.5 * 9.80665, 1e-9);
  EXPECT_NEAR(sample->angular_rate_rad_s.x(), std::numbers::pi, 1e-9);
  EXPECT_NEAR(sample->angular_rate_rad_s.z(), -std::numbers::pi / 2, 1e-9);
  EXPECT_FALSE(OusterDecoder::inertial_sample(bytes(packet.substr(1))));
}

}  // namespace
}  // namespace bole::sensor
