#include "io/core/scans/velodyne_pcap.h"
#include "io/core/scans/packet_clock.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include "cloud/known_facts.h"
#include "io/core/clouds/cloud_reader.h"
#include "io_test_tools.h"
#include "modules/sensor/velodyne_calibration.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

// A round room of 10 m around a sensor that stands still.
struct Recorder {
  sensor::SensorModel model;
  double start_time_s = 1.7e9 + 3590;  // an hour ends after ten seconds
  double rotation_hz = 10;
  double start_azimuth_rad = 0;
  sensor::VelodyneReturnMode mode = sensor::VelodyneReturnMode::strongest;

  std::vector<std::pair<sensor::VelodyneEncoder::Bytes, double>> packets(double seconds) const {
    std::vector<std::pair<sensor::VelodyneEncoder::Bytes, double>> out;
    sensor::VelodyneEncoder encoder(model, mode, [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) {
      out.emplace_back(bytes, time_s);
    });
    const std::vector<sensor::LaserEcho> echoes(model.channels.size(), {10.F, 50}),
        far(model.channels.size(), {20.F, 20});
    const auto sequences = static_cast<std::int64_t>(seconds / model.sequence_period_s);
    for (std::int64_t s = 0; s < sequences; ++s) {
      const double t = static_cast<double>(s) * model.sequence_period_s;
      encoder.add(start_time_s + t, start_azimuth_rad + 2 * std::numbers::pi * rotation_hz * t, echoes, far);
    }
    return out;
  }
};

std::filesystem::path write_pcap(const std::filesystem::path& path,
                                 const std::vector<std::pair<sensor::VelodyneEncoder::Bytes, double>>& packets,
                                 double capture_shift_s = 0) {
  sensor::PcapWriter writer(path);
  for (const auto& [bytes, time_s] : packets) writer.write(bytes, time_s + capture_shift_s);
  writer.close();
  return path;
}

double azimuth_deg(const Eigen::Vector3f& p) {
  return std::fmod(std::atan2(-p.y(), p.x()) * 180 / std::numbers::pi + 360, 360);
}

TEST(VelodynePcap, FramesAreWholeTurnsFromTheCutAngle) {
  const TempDir dir;
  for (const char* name : {"vlp16", "vlp32c", "hdl32e", "hdl64e_s2"}) {
    SCOPED_TRACE(name);
    const Recorder recorder{sensor::load_sensor_model(name)};
    const auto path = write_pcap(dir / (std::string(name) + ".pcap"), recorder.packets(1.05));
    FrameSourceOptions options;
    options.cut_angle_deg = 90;
    const VelodynePcapSource source(path, options, {});
    EXPECT_EQ(source.sensor_model(), name);
    const auto model = sensor::load_sensor_model(name);
    EXPECT_EQ(source.facts().at("sensor"), model.name);
    EXPECT_EQ(source.facts().at("clock"), "utc");
    EXPECT_EQ(fact_number(source.facts(), facts::range_noise), model.range_sigma_m);
    EXPECT_EQ(fact_number(source.facts(), facts::beam_aperture), model.aperture_horizontal_m);
    EXPECT_DOUBLE_EQ(*fact_number(source.facts(), facts::beam_divergence), 1e3 * model.beam_divergence_horizontal_rad);
    EXPECT_EQ(source.size(), 10U);  // from 0.025 s on: ten whole turns, the first quarter and what is left are dropped
    ScanFrame frame;
    std::size_t points = 0;
    for (std::size_t i = 0; i < source.size(); ++i) {
      source.read(i, frame);
      EXPECT_NEAR(frame.start_time_s, recorder.start_time_s + 0.025 + 0.1 * static_cast<double>(i), 2e-4);
      EXPECT_NEAR(frame.end_time_s - frame.start_time_s, 0.1, 3e-4);
      EXPECT_NEAR(static_cast<double>(frame.size()), 0.1 / recorder.model.sequence_period_s * recorder.model.rings(),
                  3.0 * recorder.model.rings());
      points += frame.size();
      for (std::size_t k = 0; k < frame.size(); ++k) {
        const auto laser = std::ranges::find(model.channels, frame.ring[k], &sensor::LaserChannel::ring);
        const Eigen::Vector3d height(0, 0, laser->offsets.height);
        EXPECT_NEAR((frame.positions[k].cast<double>() - height).norm(), 10, 0.003);
        // Where the rotor was then, plus the laser's own offset.
        const double rotor = std::fmod(90 + 3600 * frame.time_offset_s[k], 360);
        EXPECT_LT(std::abs(std::remainder(azimuth_deg(frame.positions[k]) - rotor, 360)), 4.3 + 0.5);
      }
      EXPECT_TRUE(std::ranges::is_sorted(frame.time_offset_s.begin(), frame.time_offset_s.end(),
                                         [](float a, float b) { return a < b - 1e-4F; }));
    }
    EXPECT_EQ(source.report().counts.at("lost_packets"), 0);
    // Units of the HDL-64E differ, and this one has no calibration.
    EXPECT_EQ(source.report().warnings.size(), model.channels.size() == 64 ? 1U : 0U);
    EXPECT_EQ(source.report().facts.at("clock"), "sensor (UTC)");
    ScanFrame again;
    source.read(3, again);
    source.read(9, frame);
    source.read(3, frame);
    EXPECT_EQ(again.positions, frame.positions);
  }
}

TEST(VelodynePcap, NoReturnIsLostOrTwiceAcrossFrames) {
  const TempDir dir;
  Recorder recorder{sensor::load_sensor_model("vlp32c")};
  const auto packets = recorder.packets(0.5);
  FrameSourceOptions options;
  options.keep_partial_frames = true;
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", packets), options, {});
  std::size_t points = 0;
  ScanFrame frame;
  double last_time_s = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    source.read(i, frame);
    EXPECT_GT(frame.start_time_s, last_time_s);
    last_time_s = frame.end_time_s;
    points += frame.size();
  }
  EXPECT_EQ(points, packets.size() * 12 * 32);
}

TEST(VelodynePcap, TheHourRollsOver) {
  const TempDir dir;
  Recorder recorder{sensor::load_sensor_model("vlp16")};
  recorder.start_time_s = std::floor(1.7e9 / 3600) * 3600 + 3599.5;
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", recorder.packets(1)), {}, {});
  for (std::size_t i = 1; i < source.size(); ++i)
    EXPECT_NEAR(source.frame_time_s(i) - source.frame_time_s(i - 1), 0.1, 1e-3);
  EXPECT_TRUE(source.report().warnings.empty());
  ScanFrame frame;
  for (std::size_t i = 0; i < source.size(); ++i) {
    source.read(i, frame);
    EXPECT_LT(std::ranges::max(frame.time_offset_s), 0.101F);
  }
}

TEST(VelodynePcap, ASensorWithoutGpsTakesTheTimeOfTheCapture) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", recorder.packets(0.5), 1000), {}, {});
  EXPECT_NEAR(source.frame_time_s(0), recorder.start_time_s + 1000.05, 1e-3);
  EXPECT_THAT(source.report().facts.at("clock"), HasSubstr("capture"));
}

TEST(VelodynePcap, GapsAreCountedAndFramesGoOn) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp32c")};
  auto packets = recorder.packets(3);
  const std::size_t before = packets.size();
  std::erase_if(packets, [&](const auto& p) {
    return p.second > recorder.start_time_s + 1.02 && p.second < recorder.start_time_s + 2.03;
  });
  const auto gone = static_cast<std::int64_t>(before - packets.size());
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", packets), {}, {});
  EXPECT_EQ(source.report().counts.at("lost_packets"), gone);
  EXPECT_EQ(source.report().counts.at("incomplete_frames"), 2);
  ScanFrame frame;
  for (std::size_t i = 0; i < source.size(); ++i) {
    source.read(i, frame);
    EXPECT_LT(frame.end_time_s - frame.start_time_s, 0.11);
  }
  // Half a turn is lost within a frame: it stays one frame.
  packets = recorder.packets(1);
  std::erase_if(packets, [&](const auto& p) {
    return p.second > recorder.start_time_s + 0.46 && p.second < recorder.start_time_s + 0.51;
  });
  EXPECT_EQ(VelodynePcapSource(write_pcap(dir / "b.pcap", packets), {}, {}).size(), 9U);
  // The cut lies within the gap: the next frame begins behind it.
  packets = recorder.packets(1);
  std::erase_if(packets, [&](const auto& p) {
    return p.second > recorder.start_time_s + 0.43 && p.second < recorder.start_time_s + 0.53;
  });
  const VelodynePcapSource cut(write_pcap(dir / "c.pcap", packets), {}, {});
  EXPECT_EQ(cut.size(), 9U);
  EXPECT_EQ(cut.report().counts.at("incomplete_frames"), 2);
}

TEST(VelodynePcap, PacketsOutOfOrderAreCounted) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  auto packets = recorder.packets(1);
  for (std::size_t i = 100; i < 300; i += 50) std::swap(packets[i].first, packets[i + 1].first);
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", packets), {}, {});
  EXPECT_EQ(source.report().counts.at("packets_out_of_order"), 4);
  EXPECT_EQ(source.size(), 9U);
}

TEST(VelodynePcap, SwapsAtTheCutMakeNoExtraFrame) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  const auto packets = recorder.packets(1);
  for (std::size_t i = 30; i < 50; ++i) {
    auto swapped = packets;
    std::swap(swapped[i].first, swapped[i + 1].first);
    EXPECT_EQ(VelodynePcapSource(write_pcap(dir / "a.pcap", swapped), {}, {}).size(), 9U) << i;
  }
}

TEST(VelodynePcap, DualReturns) {
  const TempDir dir;
  Recorder recorder{sensor::load_sensor_model("vlp32c")};
  recorder.mode = sensor::VelodyneReturnMode::dual;
  const VelodynePcapSource source(write_pcap(dir / "a.pcap", recorder.packets(0.5)), {}, {});
  ASSERT_EQ(source.size(), 4U);
  ScanFrame frame;
  source.read(1, frame);
  EXPECT_NEAR(static_cast<double>(frame.size()), 2 * 32 * 0.1 / recorder.model.sequence_period_s, 4 * 32);
  for (std::size_t i = 0; i < frame.size(); ++i)
    EXPECT_NEAR(frame.positions[i].norm(), frame.return_number[i] == 1 ? 10 : 20, 0.003);
  EXPECT_EQ(source.report().facts.at("return_mode"), "dual");
  EXPECT_EQ(source.report().counts.at("lost_packets"), 0);
}

TEST(VelodynePcap, AFileThatIsCutOffKeepsItsFrames) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  const auto whole = file_text(write_pcap(dir / "a.pcap", recorder.packets(1)));
  write_file(dir / "b.pcap", whole.substr(0, whole.size() * 2 / 3 + 100));
  const VelodynePcapSource source(dir / "b.pcap", {}, {});
  EXPECT_EQ(source.size(), 6U);
  ASSERT_FALSE(source.report().warnings.empty());
  EXPECT_THAT(source.report().warnings[0], HasSubstr("cut off"));
  ScanFrame frame;
  source.read(source.size() - 1, frame);
  EXPECT_GT(frame.size(), 20000U);
}

TEST(VelodynePcap, OptionsAreObeyedAndTheLocatorNamesThem) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  FrameSourceOptions options;
  options.max_range = 9.5;
  options.cut_angle_deg = 10.5;
  const auto source = open_frame_source(write_pcap(dir / "a.pcap", recorder.packets(0.5)), options);
  ScanFrame frame;
  source->read(0, frame);
  EXPECT_EQ(frame.size(), 0U);
  const auto again = open_frame_source(dir / "a.pcap", options);
  EXPECT_EQ(again->locator(), source->locator());
  EXPECT_EQ(again->frame_time_s(1), source->frame_time_s(1));
  EXPECT_THAT(error_of([&] { source->read(99, frame); }), HasSubstr("frame 99"));
}

TEST(VelodynePcap, ErrorsSayWhatTheFileIs) {
  const TempDir dir;
  write_file(dir / "a.pcap", "this is a letter");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "a.pcap"); }), HasSubstr("is not a capture"));
  write_file(dir / "b.pcap", "");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "b.pcap"); }), HasSubstr("is not a capture"));
  {
    sensor::PcapWriter writer(dir / "c.pcap");
    writer.write(std::vector<std::uint8_t>(100), 1);
    writer.close();
  }
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "c.pcap"); }),
              HasSubstr("1 UDP datagram but no Velodyne data packet"));
  {
    sensor::PcapWriter writer(dir / "d.pcap");
    sensor::VelodynePacket packet;
    packet.product_id = 0x63;
    writer.write(sensor::pack_velodyne_packet(packet), 1);
    writer.close();
  }
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "d.pcap"); }), HasSubstr("product id 0x63"));
  FrameSourceOptions options;
  options.sensor = "vlp16";
  EXPECT_EQ(open_frame_source(dir / "d.pcap", options)->sensor_model(), "vlp16");
  options.port = 9;
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "d.pcap", options); }), HasSubstr("port 9"));
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "nothing.pcap"); }), HasSubstr("there is no"));
  EXPECT_THAT(error_of([&] { open_frame_source(""); }), HasSubstr("no scan is named"));
  EXPECT_THAT(error_of([&] { open_frame_source(dir.path()); }), HasSubstr("holds no frames"));
}

TEST(VelodynePcap, ACancelledIndexStops) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THAT(error_of([&] { open_frame_source(write_pcap(dir / "a.pcap", recorder.packets(1)), {}, run); }),
              HasSubstr("cancelled"));
}

// What else was on the wire must not keep a person waiting.
TEST(VelodynePcap, ACaptureOfOtherTrafficCanBeCancelled) {
  const TempDir dir;
  constexpr std::size_t payload = 100, packets = 3000, file_header = 24, record = 16 + 14 + 20 + 8 + payload;
  {
    sensor::PcapWriter writer(dir / "tcp.pcap");
    for (std::size_t i = 0; i < packets; ++i)
      writer.write(std::vector<std::uint8_t>(payload), 1 + 1e-3 * static_cast<double>(i));
    writer.close();
  }
  std::string bytes(std::filesystem::file_size(dir / "tcp.pcap"), '\0');
  std::ifstream(dir / "tcp.pcap", std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  ASSERT_EQ(bytes.size(), file_header + packets * record);
  for (std::size_t i = 0; i < packets; ++i) {
    char& protocol = bytes[file_header + i * record + 16 + 14 + 9];
    ASSERT_EQ(protocol, 17);
    protocol = 6;
  }
  write_file(dir / "tcp.pcap", bytes);
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "tcp.pcap"); }), HasSubstr("0 UDP datagrams"));
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  int reports = 0;
  run.progress = [&](double, std::string_view) { ++reports, stop.request_stop(); };
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "tcp.pcap", {}, run); }), HasSubstr("cancelled"));
  EXPECT_EQ(reports, 1);
}

TEST(VelodynePcap, RealCaptures) {
  BOLE_NEEDS_SHARED("VELODYNE_pcaps");
  const auto vlp16 = open_frame_source(shared("VELODYNE_pcaps/mrpt_vlp16_gps.pcap"));
  EXPECT_EQ(vlp16->sensor_model(), "vlp16");
  const auto hdl32 = open_frame_source(shared("VELODYNE_pcaps/mrpt_hdl32.pcap"));
  EXPECT_EQ(hdl32->sensor_model(), "hdl32e");
  ScanFrame frame;
  for (const auto& source : {vlp16, hdl32}) {
    ASSERT_GE(source->size(), 1U);
    source->read(0, frame);
    EXPECT_GT(frame.size(), 5000U);
    EXPECT_NEAR(frame.end_time_s - frame.start_time_s, 0.1, 0.02);
  }
}

TEST(VelodynePcap, AgreesWithAnotherDecoderOnAVlp32c) {
  BOLE_NEEDS_SHARED("NEBULA_velodyne");
  FrameSourceOptions options;
  options.keep_partial_frames = true;
  options.min_range = 0.1;
  Report report;
  const auto source = open_frame_source(shared("NEBULA_velodyne/vlp32/1713492677464078412"), options, {}, report);
  EXPECT_EQ(source->sensor_model(), "vlp32c");
  std::vector<Eigen::Vector3f> ours;
  std::vector<std::uint16_t> rings;
  ScanFrame frame;
  for (std::size_t i = 0; i < source->size(); ++i) {
    source->read(i, frame);
    ours.insert(ours.end(), frame.positions.begin(), frame.positions.end());
    rings.insert(rings.end(), frame.ring.begin(), frame.ring.end());
  }
  const auto truth = read_cloud(shared("NEBULA_velodyne/vlp32/1713492677464078412.pcd")).cloud;
  ASSERT_EQ(truth.size(), 26216U);
  // The other decoder lets the 32 lasers fire one after the other, 2.304 us apart, which takes longer than a firing
  // sequence; the manual has them fire by pairs. Until the last pair the rotor (10 Hz) turns by 0.13 degrees more in
  // that decoder. In the last block of each packet it does not turn at all.
  const auto model = sensor::load_sensor_model("vlp32c");
  std::vector<double> ahead_deg(32), still_deg(32);
  for (std::size_t c = 0; c < model.channels.size(); ++c) {
    const auto ring = static_cast<std::size_t>(model.channels[c].ring);
    still_deg[ring] = -model.channels[c].firing_time_s * 3600;
    ahead_deg[ring] = still_deg[ring] + static_cast<double>(c) * 2.304e-6 * 3600;
  }
  std::size_t k = 0, ahead = 0, still = 0;
  for (const auto& p : truth.positions()) {
    const auto end = ours.begin() + static_cast<std::ptrdiff_t>(std::min(k + 64, ours.size()));
    const auto match = std::find_if(ours.begin() + static_cast<std::ptrdiff_t>(k), end, [&](const Eigen::Vector3f& q) {
      return std::abs(q.norm() - p.norm()) + std::abs(q.z() - p.z()) < 2e-3F;
    });
    if (match == end) continue;
    const auto at = static_cast<std::size_t>(match - ours.begin());
    const double difference_deg = std::remainder(azimuth_deg(p) - azimuth_deg(*match), 360);
    if (std::abs(difference_deg - ahead_deg[rings[at]]) < 0.03)
      ++ahead;
    else if (std::abs(difference_deg - still_deg[rings[at]]) < 0.03)
      ++still;
    k = at + 1;
  }
  EXPECT_GT(static_cast<double>(ahead + still) / static_cast<double>(truth.size()), 0.99);
  EXPECT_LT(static_cast<double>(still) / static_cast<double>(truth.size()), 1.0 / 12);
  // The sensor left out the sector behind it: five frames of half a turn, and the firings behind the last jump.
  EXPECT_EQ(source->size(), 6U);
  EXPECT_EQ(report.counts.at("lost_packets"), 0);
}

TEST(VelodynePcap, TheCalibrationBesideACaptureWins) {
  const TempDir dir;
  auto model = sensor::load_sensor_model("hdl64e_s2");
  const Recorder recorder{model};
  const auto path = write_pcap(dir / "walk.pcap", recorder.packets(0.35));
  const auto codes = [](const Report& report) {
    std::vector<std::string> out;
    for (const auto& finding : report.findings) out.push_back(finding.code);
    return out;
  };
  const VelodynePcapSource nominal(path, FrameSourceOptions{}, {});
  EXPECT_THAT(codes(nominal.report()), testing::ElementsAre("sensor_not_calibrated"));
  // A unit whose lasers all lie in one plane, 1.5 m short.
  write_file(dir / "db.xml",
             testing_velodyne::calibration_xml(std::vector<testing_velodyne::UnitLaser>(64, {0, 0, 150, 0, 0, 0, 0})));
  const VelodynePcapSource calibrated(path, FrameSourceOptions{}, {});
  EXPECT_TRUE(calibrated.report().findings.empty());
  EXPECT_EQ(calibrated.report().facts.at("calibration"), "db.xml");
  ScanFrame frame;
  calibrated.read(0, frame);
  ASSERT_GT(frame.size(), 10000U);
  for (const auto& p : frame.positions) {
    EXPECT_NEAR(p.norm(), 11.5, 0.002);
    EXPECT_NEAR(p.z(), 0, 1e-5);
  }
  write_file(dir / "other.xml", testing_velodyne::calibration_xml(std::vector<testing_velodyne::UnitLaser>(64)));
  EXPECT_THAT(error_of([&] { VelodynePcapSource(path, FrameSourceOptions{}, {}); }), HasSubstr("several calibrations"));
  std::filesystem::remove(dir / "other.xml");
  write_file(dir / "db.xml", testing_velodyne::calibration_xml(std::vector<testing_velodyne::UnitLaser>(16)));
  const VelodynePcapSource other(path, FrameSourceOptions{}, {});
  EXPECT_THAT(codes(other.report()), testing::ElementsAre("calibration_of_another_sensor"));
}

// Packets of a VLP-32C for an hour: adding the steps up in floating point was milliseconds wrong at its end.
TEST(VelodynePcap, TheClockDoesNotDriftOverAnHour) {
  PacketClock clock;
  constexpr std::int64_t step_ns = 663'552, packets = 5'400'000;
  double worst_s = 0;
  for (std::int64_t i = 0; i < packets; ++i) {
    const std::int64_t past_hour_us = 1'000'000 + i * step_ns / 1000;
    const double true_s = 1.7e9 - 800 + 1e-6 * static_cast<double>(past_hour_us);
    const double time_s = clock.time_s(static_cast<std::uint32_t>(past_hour_us % 3'600'000'000), true_s + 0.02);
    worst_s = std::max(worst_s, std::abs(time_s - true_s));
  }
  EXPECT_TRUE(clock.follows_utc());
  EXPECT_LT(worst_s, 1e-6);
}

TEST(VelodynePcap, TheYamlOfRosIsACalibration) {
  const TempDir dir;
  const Recorder recorder{sensor::load_sensor_model("vlp16")};
  const auto path = write_pcap(dir / "walk.pcap", recorder.packets(0.35));
  const auto heights_mm = [](const VelodynePcapSource& source) {
    std::map<int, long> out;
    ScanFrame frame;
    source.read(0, frame);
    const auto elevations_rad = source.ring_elevations_rad();
    for (std::size_t k = 0; k < frame.size(); ++k)
      out[frame.ring[k]] = std::lround(
          1e3 * (static_cast<double>(frame.positions[k].z()) - 10 * std::sin(elevations_rad[frame.ring[k]])));
    return out;
  };
  const VelodynePcapSource maker(path, FrameSourceOptions{}, {});
  EXPECT_EQ(maker.report().facts.at("laser_heights"), "added");
  EXPECT_EQ(heights_mm(maker).at(0), 11);
  EXPECT_EQ(heights_mm(maker).at(15), -11);
  FrameSourceOptions without;
  without.laser_heights = false;
  const VelodynePcapSource plain(path, without, {});
  EXPECT_EQ(plain.report().facts.at("laser_heights"), "left out");
  EXPECT_EQ(heights_mm(plain).at(0), 0);
  // A unit with its own heights, and one whose file does not know them.
  const auto yaml = [](double height_m) {
    return testing_velodyne::calibration_yaml(
        std::vector<testing_velodyne::UnitLaser>(16, {0, 0, 0, 0, 0, 100 * height_m, 0}), 0.002);
  };
  write_file(dir / "unit.yaml", yaml(0.03));
  const VelodynePcapSource own(path, FrameSourceOptions{}, {});
  EXPECT_EQ(own.report().facts.at("calibration"), "unit.yaml");
  EXPECT_EQ(heights_mm(own).at(3), 30);
  write_file(dir / "unit.yaml", yaml(0));
  const VelodynePcapSource unknown(path, FrameSourceOptions{}, {});
  EXPECT_EQ(heights_mm(unknown).at(0), 11);
  // Files of other sensors beside it do not matter; two of this one do.
  write_file(dir / "other.yml",
             testing_velodyne::calibration_yaml(std::vector<testing_velodyne::UnitLaser>(32), 0.004, true));
  EXPECT_EQ(VelodynePcapSource(path, FrameSourceOptions{}, {}).report().facts.at("calibration"), "unit.yaml");
  write_file(dir / "another.yaml", yaml(0));
  EXPECT_THAT(error_of([&] { VelodynePcapSource(path, FrameSourceOptions{}, {}); }), HasSubstr("several calibrations"));
  std::filesystem::remove(dir / "another.yaml");
  write_file(dir / "metadata.yaml", "rosbag2_bagfile_information:\n  version: 5\n");  // another YAML
  EXPECT_EQ(VelodynePcapSource(path, FrameSourceOptions{}, {}).size(), own.size());
}

}  // namespace
}  // namespace bole::io
