#include "io/core/scans/livox_lvx.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "io_test_tools.h"
#include "lvx_bytes.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;
namespace maker = testing_lvx;

constexpr std::uint64_t start_ns = 20'000'000'000, block_ns = 50'000'000;

std::string avia_file(int blocks) {
  maker::File file(false, {{}});
  for (int b = 0; b < blocks; ++b) {
    const auto ns = start_ns + static_cast<std::uint64_t>(b) * block_ns;
    std::string packages;
    for (int p = 0; p < 10; ++p)
      packages += file.package(0, 2, ns + static_cast<std::uint64_t>(p) * 400'000,
                               maker::times(maker::tagged(maker::cartesian(3000, -1000 * b, 500, 60), 0x10), 96));
    packages += file.package(0, 6, ns + 1000, maker::inertial(0.1F, 0, 0, 0, 0, 1));
    file.block(packages);
  }
  return file.bytes();
}

LvxSource open(const std::string& bytes) { return {bytes_of(bytes), "test.lvx", {}, {}}; }

TEST(Lvx, TwoBlocksMakeAFrame) {
  const TempDir folder;
  write_file(folder / "walk.lvx", avia_file(6));
  Report report;
  const auto source = open_frame_source(folder / "walk.lvx", {}, {}, report);
  EXPECT_EQ(source->size(), 3U);
  EXPECT_EQ(source->pattern(), ScanPattern::rosette);
  EXPECT_EQ(source->rings(), 1);
  EXPECT_EQ(source->sensor_model(), "avia");
  EXPECT_TRUE(report.warnings.empty()) << testing::PrintToString(report.warnings);
  ScanFrame frame;
  source->read(1, frame);
  ASSERT_EQ(frame.size(), 2U * 10 * 96);
  EXPECT_NEAR(frame.start_time_s, 20.1, 1e-9);
  EXPECT_EQ(frame.positions.front(), Eigen::Vector3f(3, -2, 0.5F));
  EXPECT_EQ(frame.positions.back(), Eigen::Vector3f(3, -3, 0.5F));
  EXPECT_NEAR(frame.time_offset_s[96 + 1], 400e-6 + 1 / 240e3, 1e-9);
  EXPECT_EQ(frame.intensity[5], 60);
  EXPECT_NEAR(frame.end_time_s - frame.start_time_s, 0.05 + 9 * 400e-6 + 95 / 240e3, 1e-6);
  ASSERT_NE(source->inertial(), nullptr);
  ASSERT_EQ(source->inertial()->samples.size(), 6U);
  EXPECT_NEAR(source->inertial()->samples[2].time_s, 20.100001, 1e-9);
  EXPECT_NEAR(source->inertial()->samples[2].specific_force_m_s2.z(), 9.80665, 1e-6);
  EXPECT_NEAR(source->inertial()->samples[2].angular_rate_rad_s.x(), 0.1, 1e-6);
  EXPECT_TRUE(source->inertial()->T_sensor_imu);
}

TEST(Lvx, EveryPointTypeIsRead) {
  std::string range_and_angles, dual_angles;  // 5 m, 60 degrees from the zenith, 30 degrees to the left
  maker::put(range_and_angles, 5000, 4);
  maker::put(range_and_angles, 6000, 2);
  maker::put(range_and_angles, 3000, 2);
  range_and_angles += '\x40';
  maker::put(dual_angles, 6000, 2);
  maker::put(dual_angles, 3000, 2);
  for (const int range_mm : {5000, 8000}) {
    maker::put(dual_angles, static_cast<std::uint64_t>(range_mm), 4);
    dual_angles += std::string("\x40\0", 2);
  }
  const auto triple_angles = dual_angles + std::string("\0\0\0\0\0\0", 6);  // no third return
  const auto near = maker::cartesian(1000, 2000, 3000, 64), far = maker::cartesian(2000, 4000, 6000, 64),
             none = maker::cartesian(0, 0, 0, 0);
  struct Case {
    int type, count, firings, points_of_firing;
    std::string firing;
    Eigen::Vector3f first;
  };
  const Eigen::Vector3f sphere(5 * std::sin(1.0471975512F) * std::cos(0.5235987756F),
                               5 * std::sin(1.0471975512F) * std::sin(0.5235987756F), 2.5F);
  const Eigen::Vector3f box(1, 2, 3);
  const std::vector<Case> cases{
      {0, 100, 100, 1, near, box},
      {1, 100, 100, 1, range_and_angles, sphere},
      {2, 96, 96, 1, maker::tagged(near, 0), box},
      {3, 96, 96, 1, maker::tagged(range_and_angles, 0), sphere},
      {4, 48, 48, 2, maker::tagged(near, 0) + maker::tagged(far, 0), box},
      {5, 48, 48, 2, dual_angles, sphere},
      {7, 30, 30, 2, maker::tagged(near, 0) + maker::tagged(far, 0) + maker::tagged(none, 0), box},
      {8, 30, 30, 2, triple_angles, sphere}};
  for (const auto& c : cases) {
    maker::File file(false, {{}});
    file.block(file.package(0, static_cast<std::uint8_t>(c.type), start_ns, maker::times(c.firing, c.count)));
    const auto source = open(file.bytes());
    ScanFrame frame;
    source.read(0, frame);
    ASSERT_EQ(frame.size(), static_cast<std::size_t>(c.firings * c.points_of_firing)) << c.type;
    EXPECT_LT((frame.positions[0] - c.first).norm(), 1e-5) << c.type;
    EXPECT_EQ(frame.intensity[0], 64) << c.type;
    EXPECT_EQ(std::ranges::count(frame.return_number, 2), c.firings * (c.points_of_firing - 1)) << c.type;
  }
}

TEST(Lvx, PointsThatTheDeviceMarksAsNoiseAreLeftOut) {
  maker::File file(false, {{}});
  std::string data;
  for (int i = 0; i < 96; ++i) data += maker::tagged(maker::cartesian(1000, 0, 0, 1), i % 4);
  file.block(file.package(0, 2, start_ns, data));
  ScanFrame frame;
  open(file.bytes()).read(0, frame);
  EXPECT_EQ(frame.size(), 72U);
}

TEST(Lvx, SeveralDevicesArePlacedByTheirExtrinsics) {
  maker::Device second{1, 7, true, 0, 0, 90, 1, 0, 0};
  maker::Device first{0, 7, true};
  for (const bool two : {false, true}) {
    maker::File file(false, two ? std::vector{first, second} : std::vector{second});
    const std::string data = maker::times(maker::tagged(maker::cartesian(2000, 0, 0, 1), 0), 96);
    file.block(file.package(1, 2, start_ns, data));
    const auto source = open(file.bytes());
    ScanFrame frame;
    source.read(0, frame);
    const Eigen::Vector3f expected = two ? Eigen::Vector3f(1, 2, 0) : Eigen::Vector3f(2, 0, 0);
    EXPECT_LT((frame.positions[0] - expected).norm(), 1e-6) << two;
  }
}

TEST(Lvx, Lvx2OfAMid360) {
  maker::File file(true, {{0x6401A8C0, 9}});
  std::string half;  // low resolution: centimetres in 16 bits
  for (const int v : {-150, 200, 50}) maker::put(half, static_cast<std::uint16_t>(v), 2);
  half += std::string("\x21\0", 2);
  for (int b = 0; b < 4; ++b) {
    const auto ns = start_ns + static_cast<std::uint64_t>(b) * block_ns;
    file.block(
        file.package(0x6401A8C0, 1, ns, maker::times(maker::tagged(maker::cartesian(1500, 2500, -500, 9), 0), 96)) +
        file.package(0x6401A8C0, 2, ns + 480'000, maker::times(half, 50)) +
        file.package(0x6401A8C0, 0, ns, maker::inertial(0, 0, 1, 0, 0, 1)) +
        file.package(0x6401A8C0, 77, ns, "of a type to come"));
  }
  const auto source = open(file.bytes());
  EXPECT_EQ(source.size(), 2U);
  EXPECT_EQ(source.sensor_model(), "mid360");
  EXPECT_EQ(source.report().counts.at("other_packets"), 4);
  ScanFrame frame;
  source.read(0, frame);
  ASSERT_EQ(frame.size(), 2U * 146);
  EXPECT_EQ(frame.positions[0], Eigen::Vector3f(1.5F, 2.5F, -0.5F));
  EXPECT_LT((frame.positions[96] - Eigen::Vector3f(-1.5F, 2, 0.5F)).norm(), 1e-6);
  EXPECT_NEAR(frame.time_offset_s[97], 480e-6 + 5e-6, 1e-8);
  ASSERT_NE(source.inertial(), nullptr);
  EXPECT_EQ(source.inertial()->samples.size(), 4U);
}

TEST(Lvx, DamagedFilesGiveWhatTheyHold) {
  const auto whole = avia_file(6);
  const auto cut = open(whole.substr(0, whole.size() * 8 / 10));
  EXPECT_EQ(cut.size(), 2U);
  ASSERT_FALSE(cut.report().findings.empty());
  EXPECT_THAT(cut.report().findings.front().text, HasSubstr("cut off or damaged"));
  auto lying = whole;  // the offset of the second block is beyond the file
  const std::size_t first_block = 24 + 5 + 59;
  lying[first_block + 8 + 5] = '\x7F';
  EXPECT_GE(open(lying).size(), 1U);
  EXPECT_FALSE(open(lying).report().findings.empty());
  EXPECT_THAT(error_of([&] { open(whole.substr(0, first_block)); }), HasSubstr("has no points"));
  EXPECT_THAT(error_of([&] { open(whole.substr(0, 60)); }), HasSubstr("declares 1 device"));
  EXPECT_THAT(error_of([&] { open("livox_tech"); }), HasSubstr("no header"));
  EXPECT_THAT(error_of([&] { open(""); }), HasSubstr("no header"));
  auto old = whole;
  old[17] = 0;
  EXPECT_THAT(error_of([&] { open(old); }), HasSubstr("version 1.0"));
}

}  // namespace
}  // namespace bole::io
