#include "io/core/las/las_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "io/core/las/las_facts.h"
#include "io/core/las/las_reader.h"
#include "modules/io/las_file.h"

namespace bole::io {
namespace {

using testing::Contains;
using testing::HasSubstr;

class LasWriter : public testing::Test {
 protected:
  LasWriter()
      : folder_(std::filesystem::temp_directory_path() /
                ("bole_las_writer_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~LasWriter() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path path(const std::string& name = "cloud.las") const { return folder_ / name; }
  std::filesystem::path folder_;
};

std::vector<std::uint8_t> file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The point records of a LAS file without its header.
std::vector<std::uint8_t> records_of(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path);
  return {bytes.begin() + las::load<std::uint32_t>(&bytes[96]), bytes.end()};
}

PointCloud mapped_cloud(std::size_t count, const Eigen::Vector3d& origin) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(-40, 40);
  PointCloud::Positions positions;
  for (std::size_t i = 0; i < count; ++i) positions.emplace_back(uniform(random), uniform(random), uniform(random));
  PointCloud cloud(std::move(positions), origin);
  std::vector<std::int32_t> tree(count), pass(count);
  std::vector<float> range(count), height(count), intensity(count), sensor(count);
  std::vector<double> time(count);
  std::vector<std::uint16_t> ring(count);
  for (std::size_t i = 0; i < count; ++i) {
    tree[i] = static_cast<int>(i % 50);
    pass[i] = static_cast<int>(i % 3);
    range[i] = uniform(random);
    height[i] = uniform(random);
    sensor[i] = uniform(random);
    intensity[i] = static_cast<float>(i % 256), time[i] = 1e9 + 1e-4 * static_cast<double>(i),
    ring[i] = static_cast<std::uint16_t>(i % 32);
  }
  cloud.set_column(arrays::tree_id, tree), cloud.set_column(arrays::pass, pass), cloud.set_column(arrays::range, range),
      cloud.set_column(arrays::height_above_ground, height);
  cloud.set_column(arrays::intensity, intensity), cloud.set_column(arrays::time, time),
      cloud.set_column(arrays::ring, ring);
  cloud.set_column(arrays::sensor_x, sensor);
  return cloud;
}

// JSON, HTML and the screen take UTF-8 only.
TEST_F(LasWriter, NamesInLatin1AreReadAsUtf8) {
  PointCloud cloud = mapped_cloud(10, Eigen::Vector3d::Zero());
  const std::string in_utf8 = "h\xC3\xB6he", in_latin1 = "h\xF6hen";
  cloud.set_column(in_utf8, std::vector<float>(10, 1));
  cloud.set_column(in_latin1, std::vector<float>(10, 2));
  write_las(path(), cloud);
  const auto back = read_las(path());
  EXPECT_EQ(back.values<float>(in_utf8), std::vector<float>(10, 1));
  EXPECT_EQ(back.values<float>(in_utf8 + "n"), std::vector<float>(10, 2));
  // A text that is cut stays one.
  std::array<std::uint8_t, 2> field;
  las::store_text(field.data(), field.size(), in_utf8);
  EXPECT_EQ(las::load_text(field.data(), field.size()), "h");
}

TEST_F(LasWriter, AUtmCloudComesBackWithAllItsColumns) {
  const PointCloud cloud = mapped_cloud(2000, {691234.5678, 5334567.891, 512.25});
  write_las(path(), cloud);
  Report report;
  const PointCloud back = read_las(path(), {}, {}, &report);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  ASSERT_EQ(back.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_LT((exact_position(back, i) - cloud.position(i)).cwiseAbs().maxCoeff(), 0.5001e-4);
  for (const auto* info : {&arrays::tree_id, &arrays::pass, &arrays::range, &arrays::height_above_ground,
                           &arrays::intensity, &arrays::time, &arrays::ring})
    EXPECT_EQ(back.column(info->name), cloud.column(info->name)) << info->name;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_NEAR(back.origin.x() + static_cast<double>(back.values<float>(arrays::sensor_x)[i]),
                cloud.origin.x() + static_cast<double>(cloud.values<float>(arrays::sensor_x)[i]), 1e-4);
  // Written once more, not a byte of the points changes.
  write_las(path("again.las"), back);
  EXPECT_EQ(records_of(path("again.las")), records_of(path()));
}

TEST_F(LasWriter, GridOfTheSourceIsKeptToTheLastStep) {
  test::LasFile file;
  file.minor = 4;
  file.format = 7;
  file.scale = 0.001;
  file.offset = {4512345.0, 5400000, 0};
  std::mt19937 random(4);
  std::uniform_int_distribution<std::int32_t> wide(-4'000'000, 4'000'000);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int i = 0; i < 3000; ++i) {
    std::uint8_t* p = file.add(wide(random), wide(random), wide(random));
    for (std::size_t k = 12; k < file.stride(); ++k) p[k] = static_cast<std::uint8_t>(byte(random));
    las::store(p + 18, static_cast<std::int16_t>(wide(random) % 30000));
    las::store(p + 22, 3e8 + i);
  }
  std::vector<std::uint8_t> source = file.bytes();
  const PointCloud cloud = read_las(source);
  Report report;
  write_las(path(), cloud, {}, {}, &report);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  const LasInfo info = las_info(path());
  EXPECT_EQ(info.points, 3000U);
  EXPECT_EQ(info.point_format, 7);
  EXPECT_EQ(info.version_minor, 4);
  const auto bytes = file_bytes(path());
  for (std::size_t i = 0; i < file.points; ++i) {
    const std::uint8_t* written = &bytes[info.data_offset + i * static_cast<std::size_t>(info.record_length)];
    const std::uint8_t* original = &file.records[i * file.stride()];
    for (int k = 0; k < 3; ++k) {
      const double a = las::load<std::int32_t>(written + 4 * k) * info.scale[k] + info.offset[k],
                   b = las::load<std::int32_t>(original + 4 * k) * file.scale + file.offset[k];
      ASSERT_NEAR(a, b, 1e-9) << "point " << i;
    }
    ASSERT_EQ(std::memcmp(written + 12, original + 12, file.stride() - 12), 0) << "point " << i;
  }
  EXPECT_EQ(info.offset, Eigen::Vector3d(4512000, 5400000, 0)) << "whole kilometres, or metres";
}

TEST_F(LasWriter, OlderProgramsGetLas12) {
  PointCloud cloud = mapped_cloud(100, {0, 0, 0});
  std::vector<std::uint8_t> classes(100, 2);
  classes[5] = 64;
  cloud.set_column(arrays::classification, classes);
  Report report;
  write_las(path(), cloud, {.version = "1.2"}, {}, &report);
  const LasInfo info = las_info(path());
  EXPECT_EQ(info.version_minor, 2);
  EXPECT_EQ(info.point_format, 1);
  EXPECT_EQ(info.points, 100U);
  EXPECT_EQ(info.points_by_return[0], 100U);
  const PointCloud back = read_las(path());
  EXPECT_EQ(back.values<std::uint8_t>(arrays::classification)[4], 2);
  EXPECT_EQ(back.values<std::uint8_t>(arrays::classification)[5], 1);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 values of classification")));
  cloud.set_column(arrays::red, std::vector<std::uint16_t>(100, 7));
  write_las(path(), cloud, {.version = "1.2"});
  EXPECT_EQ(las_info(path()).point_format, 3);
  EXPECT_EQ(read_las(path()).values<std::uint16_t>(arrays::red)[3], 7);
}

TEST_F(LasWriter, FactsComeBackAndAForeignFileHasNone) {
  auto cloud = mapped_cloud(10, Eigen::Vector3d::Zero());
  write_las(path("plain.las"), cloud);
  Report report;
  EXPECT_TRUE(read_las(path("plain.las"), {}, {}, &report).facts.empty());
  EXPECT_EQ(las::find_vlr(las_info(path("plain.las")), las::facts_user, las::facts_record), nullptr);

  cloud.facts = {
      {"sensor", "Dôme \"64\""}, {"beam_divergence_mrad", "0.5"}, {"poses", "estimated"}, {"operator", "A. S."}};
  LasWriteOptions old;
  old.version = "1.2";
  for (const auto& options : {LasWriteOptions(), old}) {
    write_las(path(), cloud, options);
    const auto back = read_las(path(), {}, {}, &report);
    EXPECT_EQ(back.facts, cloud.facts);
    EXPECT_EQ(back.positions(), read_las(path("plain.las")).positions());
  }
  EXPECT_TRUE(report.warnings.empty());
}

// The points count, whatever became of the facts.
TEST_F(LasWriter, DamagedFactsAreLeftOutWithAWarning) {
  auto cloud = mapped_cloud(10, Eigen::Vector3d::Zero());
  cloud.facts = {{"range_noise_m", "0.005"}, {"sensor", "Dome-64"}};
  write_las(path(), cloud);
  const auto vlr = *las::find_vlr(las_info(path()), las::facts_user, las::facts_record);
  const auto whole = file_bytes(path());
  const auto read_with = [&](std::size_t at, char c, Report& report) {
    auto bytes = whole;
    bytes[vlr.offset + at] = static_cast<std::uint8_t>(c);
    const auto back = read_las(bytes, {}, {}, &report);
    EXPECT_EQ(back.size(), 10U);
    return back.facts;
  };
  Report no_json, no_number;
  EXPECT_TRUE(read_with(0, 'x', no_json).empty());
  EXPECT_THAT(no_json.warnings, testing::ElementsAre(HasSubstr("the facts of the file are damaged")));
  const std::string text(whole.begin() + static_cast<std::ptrdiff_t>(vlr.offset),
                         whole.begin() + static_cast<std::ptrdiff_t>(vlr.offset + vlr.length));
  EXPECT_EQ(read_with(text.find("0.005"), 'x', no_number), (Facts{{"sensor", "Dome-64"}}));
  EXPECT_THAT(no_number.warnings, testing::ElementsAre(HasSubstr("range_noise_m")));
}

TEST_F(LasWriter, HeaderTellsTheBoxAndTheSystem) {
  PointCloud cloud(PointCloud::Positions{{-1, -2, -3}, {4, 5, 6}}, {500000, 5000000, 100});
  cloud.crs_wkt = "PROJCS[\"made up\"]";
  write_las(path(), cloud);
  const LasInfo info = las_info(path());
  EXPECT_LT((info.min - Eigen::Vector3d(499999, 4999998, 97)).norm(), 1e-6);
  EXPECT_LT((info.max - Eigen::Vector3d(500004, 5000005, 106)).norm(), 1e-6);
  EXPECT_EQ(info.crs_wkt, cloud.crs_wkt);
  EXPECT_EQ(info.global_encoding & 16U, 16U);
  EXPECT_EQ(read_las(path()).axes, Axes::global);
}

TEST_F(LasWriter, ValuesThatDoNotFitAreHeldAndTold) {
  PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, 1, 1}});
  cloud.set_column(arrays::intensity, std::vector<float>{70000, 0.25F});
  cloud.set_column("a name that is much longer than LAS can hold", std::vector<float>{1, 2});
  Report report;
  write_las(path(), cloud, {}, {}, &report);
  EXPECT_EQ(read_las(path()).values<float>(arrays::intensity)[0], 65535.F);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 values of intensity")));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 values of intensity are rounded")));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("much longer")));
}

TEST_F(LasWriter, CoordinatesBeyondTheGridAreRefusedAndLeaveNoFile) {
  for (const float bad : {1e7F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, bad, 1}});
    try {
      write_las(path(), cloud);
      ADD_FAILURE() << bad << " was written";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_THAT(error.what(), HasSubstr("point 1 has the coordinate"));
    }
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  std::ofstream(path("file")) << "not a folder";
  EXPECT_THROW(write_las(path("file/cloud.las"), PointCloud()), Error);
}

TEST_F(LasWriter, EmptyCloud) {
  write_las(path(), PointCloud());
  EXPECT_EQ(read_las(path()).size(), 0U);
}

PointCloud timed_cloud() {
  PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, 1, 1}});
  cloud.set_column(arrays::time, std::vector<double>{1600000000.25, 1600000001.5});
  return cloud;
}

unsigned encoding_of(const std::filesystem::path& file) { return las_info(file).global_encoding; }

// What bit 0 of the global encoding says of the times is what it said of those that were read.
TEST_F(LasWriter, TheKindOfGpsTimeIsKept) {
  for (const auto& [kind, bit] : {std::pair{las::gps_week, 0U}, {las::gps_standard, 1U}}) {
    auto cloud = timed_cloud();
    cloud.facts[std::string(las::gps_time_fact)] = kind;
    write_las(path(), cloud, {}, {}, nullptr);
    EXPECT_EQ(encoding_of(path()), 16U | bit);
    const auto back = read_las(path(), {}, {}, nullptr);
    EXPECT_EQ(back.facts.at(std::string(las::gps_time_fact)), kind);
    EXPECT_EQ(back.values<double>(arrays::time), cloud.values<double>(arrays::time));
    write_las(path("again.las"), back, {}, {}, nullptr);
    EXPECT_EQ(encoding_of(path("again.las")), 16U | bit);
  }
}

// Seconds of another clock, such as Unix time, are no GPS time: other programs must not take them for it.
TEST_F(LasWriter, TimesOfAnotherClockAreNotDeclaredAsGpsTime) {
  const auto cloud = timed_cloud();
  write_las(path(), cloud, {}, {}, nullptr);
  EXPECT_THAT(las_info(path()).extra_columns, Contains("time"));
  const auto records = records_of(path());
  const auto back = read_las(path(), {}, {}, nullptr);
  EXPECT_EQ(back.values<double>(arrays::time), cloud.values<double>(arrays::time));
  EXPECT_FALSE(back.facts.contains(std::string(las::gps_time_fact)));
  LasReadOptions fields_alone;
  fields_alone.extra_bytes = false;
  EXPECT_FALSE(read_las(path(), fields_alone, {}, nullptr).has(arrays::time)) << "the field of GPS times is empty";
}

}  // namespace
}  // namespace bole::io
