#include "io/core/scans/hesai_capture.h"

#include <gmock/gmock.h>

#include <cmath>

#include "../sensor/hesai_packets.h"
#include "cloud/core/laser_facts.h"
#include "io_test_tools.h"
#include "pcap_bytes.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;
namespace maker = testing_hesai;

constexpr double start_s = 1.7e9 - std::int64_t{1'700'000'000} % 3600 + 3599.9;  // an hour ends during the recording

// A PandarXT-32 in a round room of 6 m, 10 turns per second, a block every 50 us.
std::string capture(double seconds, bool dual) {
  PcapBytes out;
  const int firings = dual ? 4 : 8;
  const auto packets = static_cast<int>(seconds / (firings * 50e-6));
  for (int p = 0; p < packets; ++p) {
    std::vector<maker::Block> blocks(8);
    for (int b = 0; b < 8; ++b) {
      const int firing = p * firings + (dual ? b / 2 : b);
      blocks[static_cast<std::size_t>(b)].azimuth_centideg = static_cast<unsigned>(firing * 18 % 36000);
      blocks[static_cast<std::size_t>(b)].units.assign(
          32, {static_cast<std::uint16_t>(dual && b % 2 == 0 ? 2000 : 1500), 7});
    }
    const double stamp_s = start_s + (p * firings + firings - 1) * 50e-6;
    const double past_hour_s = std::fmod(stamp_s, 3600);
    const auto us = static_cast<std::int64_t>(std::floor(past_hour_s * 1e6));
    out.add(maker::xt32_packet(blocks, dual ? 0x39 : 0x37,
                               {static_cast<int>(us / 60'000'000), static_cast<int>(us / 1'000'000 % 60),
                                static_cast<std::uint32_t>(us % 1'000'000)}),
            stamp_s + 0.001, 2368);
  }
  return out.bytes();
}

TEST(HesaiCapture, FramesAreWholeTurnsThroughTheHour) {
  const TempDir folder;
  write_file(folder / "walk.pcap", capture(0.55, false));
  Report report;
  const auto source = open_frame_source(folder / "walk.pcap", {}, {}, report);
  EXPECT_EQ(source->size(), 5U);
  EXPECT_EQ(source->sensor_model(), "pandar_xt32");
  EXPECT_EQ(report.counts.at("lost_packets"), 0);
  ScanFrame frame;
  for (std::size_t i = 0; i < source->size(); ++i) {
    source->read(i, frame);
    EXPECT_NEAR(
        frame.start_time_s,
        start_s + 0.05 + 0.1 * static_cast<double>(i) - 0.1 * (source->frame_time_s(0) < start_s + 0.04 ? 1 : 0),
        0.0002);
    EXPECT_EQ(frame.size(), 2000U * 32) << i;
    for (const auto& p : frame.positions) EXPECT_NEAR(p.norm(), 6, 1e-4);
  }
  EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("correction file")));
  EXPECT_EQ(fact_number(source->facts(), facts::beam_divergence), 3);
  EXPECT_EQ(fact_number(source->facts(), facts::beam_divergence_sd), 1);  // that of a similar sensor
  EXPECT_EQ(fact_number(source->facts(), facts::lasers), 32);
}

TEST(HesaiCapture, DualReturnsAreInTheFrames) {
  const TempDir folder;
  write_file(folder / "walk.pcap", capture(0.35, true));
  Report report;
  const auto source = open_frame_source(folder / "walk.pcap", {}, {}, report);
  EXPECT_EQ(report.facts.at("return_mode"), "dual");
  ScanFrame frame;
  source->read(1, frame);
  EXPECT_EQ(frame.size(), 2U * 2000 * 32);
  EXPECT_EQ(std::ranges::count(frame.return_number, 2), 2000 * 32);
}

TEST(HesaiCapture, TheCorrectionFileIsFoundBesideTheCapture) {
  const TempDir folder;
  write_file(folder / "walk.pcap", capture(0.25, false));
  std::string csv = "Laser id,Elevation,Azimuth\n";
  for (int i = 1; i <= 32; ++i) csv += std::to_string(i) + "," + std::to_string(16.5 - i) + ",0\n";
  write_file(folder / "angles.csv", csv);
  Report report;
  const auto source = open_frame_source(folder / "walk.pcap", {}, {}, report);
  EXPECT_EQ(report.facts.at("calibration"), "angles.csv");
  EXPECT_NEAR(source->ring_elevations_rad().back(), 15.5 * 3.14159265358979 / 180, 1e-6);
  write_file(folder / "more.csv", csv);
  EXPECT_THAT(error_of([&] { open_frame_source(folder / "walk.pcap"); }), HasSubstr("several correction files"));
  FrameSourceOptions named;
  named.sensor = (folder / "more.csv").string();
  EXPECT_EQ(open_frame_source(folder / "walk.pcap", named)->size(), source->size());
  write_file(folder / "walk.csv", "Laser id,Elevation,Azimuth\n1,1,1\n");
  EXPECT_THAT(error_of([&] { open_frame_source(folder / "walk.pcap"); }), HasSubstr("1 lasers"));
}

TEST(HesaiCapture, ACutCaptureGivesTheFramesBeforeTheCut) {
  const TempDir folder;
  const auto bytes = capture(0.55, false);
  write_file(folder / "walk.pcap", bytes.substr(0, bytes.size() / 2));
  Report report;
  const auto source = open_frame_source(folder / "walk.pcap", {}, {}, report);
  EXPECT_EQ(source->size(), 2U);
  ASSERT_FALSE(report.findings.empty());
  write_file(folder / "none.pcap", bytes.substr(0, 24));
  EXPECT_THAT(error_of([&] { open_frame_source(folder / "none.pcap"); }), HasSubstr("no Velodyne data packet"));
}

}  // namespace
}  // namespace bole::io
