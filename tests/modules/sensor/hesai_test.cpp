#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "hesai_packets.h"
#include "sensor/core/hesai_decoder.h"

namespace bole::sensor {
namespace {

using testing::HasSubstr;
namespace hesai_maker = testing_hesai;

constexpr double deg = std::numbers::pi / 180;

std::span<const std::uint8_t> packet_bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Blocks 0.18 (XT-32) or 0.2 degrees apart, 10 turns per second; every unit its own range.
std::vector<hesai_maker::Block> blocks(int count, int lasers, double step_deg, bool dual) {
  std::vector<hesai_maker::Block> out(static_cast<std::size_t>(count));
  for (int b = 0; b < count; ++b) {
    auto& block = out[static_cast<std::size_t>(b)];
    const int firing = dual ? b / 2 : b;
    block.azimuth_centideg = static_cast<unsigned>(std::lround(35960 + firing * step_deg * 100)) % 36000;
    for (int l = 0; l < lasers; ++l)
      block.units.push_back({static_cast<std::uint16_t>(1000 + 10 * l + (dual && b % 2 == 0 && l % 2 == 1 ? 500 : 0)),
                             static_cast<std::uint8_t>(dual && b % 2 == 0 ? 9 : l)});
  }
  return out;
}

std::vector<VelodyneReturn> decode(HesaiPackets& packets, const std::string& packet) {
  EXPECT_TRUE(packets.take(packet_bytes(packet)));
  std::vector<VelodyneFiring> firings;
  std::vector<VelodyneReturn> returns;
  packets.firings(firings);
  packets.decode(firings, 0, firings.size(), returns);
  return returns;
}

double azimuth_deg(const VelodyneReturn& r) { return std::atan2(-r.position.y(), r.position.x()) / deg; }

TEST(Hesai, Xt32TimesAnglesAndRangesAreThoseOfTheManual) {
  const auto packet = hesai_maker::xt32_packet(blocks(8, 32, 0.18, false), 0x37, {59, 30, 500'000});
  const auto* layout = hesai_layout(packet_bytes(packet));
  ASSERT_NE(layout, nullptr);
  HesaiPackets packets(*layout, load_sensor_model(layout->sensor));
  const auto returns = decode(packets, packet);
  ASSERT_EQ(returns.size(), 8U * 32);
  // Block i starts at t0 + 5.632 - 50 (8 - i) us, its channel n fires 0.28 + 1.512 (n - 1) us later.
  EXPECT_NEAR(packets.past_hour_us(), (59 * 60 + 30) * 1e6 + 500'000 + 5.632 - 350, 1);
  EXPECT_NEAR(returns[5 * 32 + 9].time_offset_s, 5 * 50e-6 + (0.28 + 1.512 * 9) * 1e-6, 1e-9);
  EXPECT_NEAR(returns[9].range_m, 1090 * 0.004, 1e-5);
  EXPECT_EQ(returns[9].intensity, 9);
  EXPECT_NEAR(std::asin(returns[9].position.z() / returns[9].range_m), 6 * deg, 1e-6);
  EXPECT_EQ(returns[0].ring, 31);
  EXPECT_EQ(returns[31].ring, 0);
  // The rotor turns on while the channels fire: 3600 degrees per second. The hesai_maker's table of firing times, 6
  // + 1.512 (n
  // - 1) us, counts from the block's azimuth.
  EXPECT_NEAR(azimuth_deg(returns[2 * 32 + 9]), -0.4 + 2 * 0.18 + 3600 * 19.608e-6, 2e-3);
}

TEST(Hesai, Pandar40pChannelsFireBeforeTheTimeOfTheirBlock) {
  const auto packet = hesai_maker::pandar40p_packet(blocks(10, 40, 0.2, false), 0x38, {0, 0, 100});
  const auto* layout = hesai_layout(packet_bytes(packet));
  ASSERT_NE(layout, nullptr);
  ASSERT_STREQ(layout->sensor, "pandar40p");
  HesaiPackets packets(*layout, load_sensor_model(layout->sensor));
  const auto returns = decode(packets, packet);
  ASSERT_EQ(returns.size(), 10U * 40);
  EXPECT_STREQ(packets.return_mode(), "last");
  // Block i is at t0 - 28.58 - 55.56 (10 - i) us; channel 8 fires first, 54.67 us before it. The hour wraps.
  EXPECT_NEAR(packets.past_hour_us(), 3600e6 + 100 - 28.58 - 9 * 55.56 - 54.67, 1);
  EXPECT_NEAR(returns[7].time_offset_s, 0, 1e-9);
  EXPECT_NEAR(returns[40 * 3 + 3].time_offset_s, 3 * 55.56e-6 + (54.67 - 3.62) * 1e-6, 1e-9);
  EXPECT_NEAR(azimuth_deg(returns[40 * 3 + 3]), -0.4 + 3 * 0.2 - 1.042 - 3600 * 3.62e-6, 2e-3);
  EXPECT_NEAR(azimuth_deg(returns[40 * 3 + 7]), -0.4 + 3 * 0.2 - 5.208 - 3600 * 54.67e-6, 2e-3);
}

TEST(Hesai, DualReturnsComeStrongestFirstAndDuplicatesOnce) {
  for (const bool xt : {true, false}) {
    const int lasers = xt ? 32 : 40, count = xt ? 8 : 10;
    const auto content = blocks(count, lasers, 0.2, true);
    const auto packet =
        xt ? hesai_maker::xt32_packet(content, 0x39, {}) : hesai_maker::pandar40p_packet(content, 0x39, {});
    const auto* layout = hesai_layout(packet_bytes(packet));
    ASSERT_NE(layout, nullptr);
    HesaiPackets packets(*layout, load_sensor_model(layout->sensor));
    const auto returns = decode(packets, packet);
    ASSERT_EQ(returns.size(), static_cast<std::size_t>(count / 2 * (lasers + lasers / 2)));
    EXPECT_EQ(std::ranges::count(returns, 2, &VelodyneReturn::return_number), count / 2 * lasers / 2);
    for (std::size_t i = 0; i < returns.size(); ++i) {
      if (returns[i].return_number == 1) continue;
      EXPECT_EQ(returns[i].intensity, 9);
      EXPECT_EQ(returns[i - 1].channel, returns[i].channel);
      EXPECT_NEAR(returns[i].range_m, returns[i - 1].range_m + 2, 1e-4);
      EXPECT_EQ(returns[i].time_offset_s, returns[i - 1].time_offset_s);
    }
  }
}

TEST(Hesai, TheCorrectionFileOfAUnitWins) {
  auto model = load_sensor_model("pandar_xt32");
  std::string csv = "Laser id,Elevation,Azimuth\n";
  for (int i = 1; i <= 32; ++i)
    csv += std::to_string(i) + "," + std::to_string(15.25 - i) + "," + std::to_string(0.01 * i) + "\n";
  apply_hesai_correction(csv + "\n", model);
  EXPECT_NEAR(model.channels[4].elevation_rad, 10.25 * deg, 1e-9);
  EXPECT_NEAR(model.channels[4].azimuth_offset_rad, 0.05 * deg, 1e-9);
  EXPECT_EQ(model.channels[4].ring, 27);
  const auto error_of = [&](const std::string& text) {
    try {
      apply_hesai_correction(text, model);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(error_of("a,b\n1,2\n"), HasSubstr("no correction table"));
  EXPECT_THAT(error_of("Laser id,Elevation,Azimuth\n1,2,3\n"), HasSubstr("1 lasers"));
  EXPECT_THAT(error_of("Laser id,Elevation,Azimuth\n99,2,3\n"), HasSubstr("'99,2,3'"));
  EXPECT_THAT(error_of("Laser id,Elevation,Azimuth\n-1,2,3\n"), HasSubstr("'-1,2,3'"));
}

TEST(Hesai, OtherPayloadsAreRefused) {
  auto packet = hesai_maker::xt32_packet(blocks(8, 32, 0.18, false), 0x37, {});
  HesaiPackets packets(*hesai_layout(packet_bytes(packet)), load_sensor_model("pandar_xt32"));
  EXPECT_EQ(hesai_layout(packet_bytes(packet.substr(0, 1000))), nullptr);
  EXPECT_EQ(hesai_layout({}), nullptr);
  EXPECT_NE(hesai_layout(packet_bytes(packet.substr(0, 1076))), nullptr);  // without the sequence number
  EXPECT_FALSE(packets.take(packet_bytes(hesai_maker::pandar40p_packet(blocks(10, 40, 0.2, false), 0x37, {}))));
  packet[2] = 1;
  EXPECT_FALSE(packets.take(packet_bytes(packet)));
  EXPECT_THROW(
      HesaiPackets(*hesai_layout(packet_bytes(hesai_maker::pandar40p_packet(blocks(10, 40, 0.2, false), 0x37, {}))),
                   load_sensor_model("pandar_xt32")),
      Error);
}

}  // namespace
}  // namespace bole::sensor
