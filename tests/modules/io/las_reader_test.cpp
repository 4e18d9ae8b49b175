#include "io/core/las/las_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "io/core/las/las_format.h"
#include "modules/io/las_file.h"

namespace bole::io {
namespace {

using test::LasFile;
using testing::Contains;
using testing::HasSubstr;

std::string las_error_of(const std::vector<std::uint8_t>& bytes) {
  try {
    read_las(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "";
}

LasFile small_file(int minor = 2, int format = 1, int points = 10) {
  LasFile file;
  file.minor = minor;
  file.format = format;
  for (int i = 0; i < points; ++i)
    file.add(100 * i, 200 - i, 7 * i)[las::field::intensity] = static_cast<std::uint8_t>(i + 1);
  return file;
}

TEST(LasReader, FieldsOfFormat3) {
  LasFile file;
  file.format = 3;
  std::uint8_t* p = file.add(12345, -678, 90);
  las::store(p + 12, std::uint16_t{40000});
  p[14] = 2 | 3 << 3 | 0x40;
  p[15] = 5 | 0x20 | 0x80;  // high vegetation, synthetic, withheld
  p[16] = static_cast<std::uint8_t>(-15);
  p[17] = 9;
  las::store(p + 18, std::uint16_t{1234});
  las::store(p + 20, 123456.789);
  for (int k = 0; k < 3; ++k) las::store(p + 28 + 2 * k, static_cast<std::uint16_t>(1000 * (k + 1)));
  Report report;
  const PointCloud cloud = read_las(file.bytes(), {}, {}, &report);
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_TRUE(exact_position(cloud, 0).isApprox(Eigen::Vector3d(1123.45, 1993.22, 0.90), 1e-12));
  EXPECT_EQ(cloud.values<float>(arrays::intensity)[0], 40000.F);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::return_number)[0], 2);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::number_of_returns)[0], 3);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::classification)[0], 5);
  EXPECT_EQ(cloud.values<std::uint8_t>("synthetic")[0], 1);
  EXPECT_EQ(cloud.values<std::uint8_t>("withheld")[0], 1);
  EXPECT_EQ(cloud.values<std::uint8_t>("scan_direction")[0], 1);
  EXPECT_FALSE(cloud.has("key_point"));
  EXPECT_EQ(cloud.values<float>(arrays::scan_angle)[0], -15.F);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::user_data)[0], 9);
  EXPECT_EQ(cloud.values<std::uint16_t>(arrays::point_source_id)[0], 1234);
  EXPECT_EQ(cloud.values<double>(arrays::time)[0], 123456.789);
  EXPECT_EQ(cloud.values<std::uint16_t>(arrays::green)[0], 2000);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 of 1 points are marked as withheld")));
  EXPECT_EQ(read_las(file.bytes(), {.drop_withheld = true}).size(), 0U);
}

TEST(LasReader, FieldsOfFormat8) {
  LasFile file;
  file.minor = 4;
  file.format = 8;
  std::uint8_t* p = file.add(1, 2, 3);
  p[14] = 9 | 12 << 4;
  p[15] = 8 | 2 << 4;  // overlap, scanner channel 2
  p[16] = 200;
  las::store(p + 18, static_cast<std::int16_t>(-2500));
  las::store(p + 36, std::uint16_t{777});
  const PointCloud cloud = read_las(file.bytes());
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::return_number)[0], 9);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::number_of_returns)[0], 12);
  EXPECT_EQ(cloud.values<std::uint8_t>(arrays::classification)[0], 200);
  EXPECT_EQ(cloud.values<std::uint8_t>("overlap")[0], 1);
  EXPECT_EQ(cloud.values<std::uint8_t>("scanner_channel")[0], 2);
  EXPECT_FLOAT_EQ(cloud.values<float>(arrays::scan_angle)[0], -15.F);
  EXPECT_EQ(cloud.values<std::uint16_t>(arrays::near_infrared)[0], 777);
  EXPECT_FALSE(cloud.has(arrays::intensity)) << "columns of zeros are left out";
}

TEST(LasReader, EveryCoordinateComesBackExactly) {
  std::mt19937 random(3);
  // 1 mm over 8 km: the outermost points lie 2^22 steps from the middle.
  std::uniform_int_distribution<std::int32_t> wide(-4190000, 4190000);
  LasFile file;
  file.scale = 0.001;
  file.offset = {4512345.678, 5400000.5, -12.3};
  std::vector<std::array<std::int32_t, 3>> truth;
  for (int i = 0; i < 5000; ++i) {
    truth.push_back({wide(random) + 700, wide(random), wide(random)});
    file.add(truth.back()[0], truth.back()[1], truth.back()[2]);
  }
  Report report;
  const PointCloud cloud = read_las(file.bytes(), {}, {}, &report);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d p = exact_position(cloud, i);
    for (int k = 0; k < 3; ++k) {
      const double steps = (p[k] - file.offset[k]) / file.scale;
      ASSERT_EQ(std::llround(steps), truth[i][static_cast<std::size_t>(k)]);
      ASSERT_NEAR(steps, std::round(steps), 1e-5);
    }
  }
}

TEST(LasReader, WarnsWhereFloatsCannotTellStepsApart) {
  LasFile file = small_file();
  file.add(40'000'000, 0, 0);
  Report report;
  read_las(file.bytes(), {}, {}, &report);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("rounded to float32")));
}

TEST(LasReader, ScalarExtraBytesBecomeColumns) {
  LasFile file;
  file.format = 0;
  file.extra = 4 + 2 + 6 + 8;
  std::vector<std::uint8_t> descriptors(4 * 192);
  const auto describe = [&](std::size_t i, int type, int options, const std::string& name) {
    descriptors[i * 192 + 2] = static_cast<std::uint8_t>(type),
                          descriptors[i * 192 + 3] = static_cast<std::uint8_t>(options);
    las::store_text(&descriptors[i * 192 + 4], 32, name);
  };
  describe(0, 6, 0, "tree_id");
  describe(1, 4, 8 | 16, "height_above_ground");
  las::store(&descriptors[192 + 112], 0.01);
  las::store(&descriptors[192 + 136], 5.0);
  describe(2, 23, 0, "normal");  // three uint16
  describe(3, 7, 0, "pulse");
  file.add_vlr("LASF_Spec", 4, descriptors);
  std::uint8_t* p = file.add(0, 0, 0) + 20;
  las::store(p, std::int32_t{-7});
  las::store(p + 4, std::int16_t{-250});
  las::store(p + 12, std::uint64_t{1} << 40);
  Report report;
  const PointCloud cloud = read_las(file.bytes(), {}, {}, &report);
  EXPECT_EQ(cloud.values<std::int32_t>(arrays::tree_id)[0], -7);
  EXPECT_FLOAT_EQ(cloud.values<float>(arrays::height_above_ground)[0], 2.5F);
  EXPECT_EQ(cloud.values<double>("pulse")[0], std::ldexp(1.0, 40));
  EXPECT_FALSE(cloud.has("normal"));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("'normal' are not a single number")));
  EXPECT_FALSE(read_las(file.bytes(), {.extra_bytes = false}).has("tree_id"));
}

TEST(LasReader, DeclaredNoDataIsAMissingValue) {
  LasFile file;
  file.format = 0;
  file.extra = 4 + 8 + 2;
  std::vector<std::uint8_t> descriptors(3 * 192);
  const auto describe = [&](std::size_t i, int type, const std::string& name) {
    descriptors[i * 192 + 2] = static_cast<std::uint8_t>(type);
    descriptors[i * 192 + 3] = 1;
    las::store_text(&descriptors[i * 192 + 4], 32, name);
  };
  describe(0, 9, "planarity");
  las::store(&descriptors[40], -9999.9);  // no float is equal to it
  describe(1, 10, "depth");
  las::store(&descriptors[192 + 40], std::numeric_limits<double>::max());
  describe(2, 4, "count");
  las::store(&descriptors[2 * 192 + 40], std::int64_t{-1});
  file.add_vlr("LASF_Spec", 4, descriptors);
  std::uint8_t* p = file.add(0, 0, 0) + 20;
  las::store(p, -9999.9F);
  las::store(p + 4, std::numeric_limits<double>::max());
  las::store(p + 12, std::int16_t{-1});
  p = file.add(1, 1, 1) + 20;
  las::store(p, 0.5F);
  las::store(p + 4, 2.5);
  las::store(p + 12, std::int16_t{7});
  const PointCloud cloud = read_las(file.bytes());
  EXPECT_TRUE(std::isnan(cloud.values<float>("planarity")[0]));
  EXPECT_EQ(cloud.values<float>("planarity")[1], 0.5F);
  EXPECT_TRUE(std::isnan(cloud.values<double>("depth")[0]));
  EXPECT_EQ(cloud.values<double>("depth")[1], 2.5);
  EXPECT_TRUE(std::isnan(cloud.values<float>("count")[0]));
  EXPECT_EQ(cloud.values<float>("count")[1], 7);
}

// Extra bytes may bear the name of a flag, in any type.
TEST(LasReader, ExtraBytesNamedAsAFlag) {
  LasFile file;
  file.extra = 4;
  std::vector<std::uint8_t> descriptor(192);
  descriptor[2] = 9;
  las::store_text(&descriptor[4], 32, "withheld");
  file.add_vlr("LASF_Spec", 4, descriptor);
  file.add(0, 0, 0);
  las::store(file.add(1, 1, 1) + 28, 1.F);
  EXPECT_EQ(read_las(file.bytes(), {.drop_withheld = true}).size(), 1U);
}

TEST(LasReader, HeadersThatCannotBeUsed) {
  EXPECT_THAT(las_error_of({}), HasSubstr("does not begin with LASF"));
  const auto good = small_file().bytes();
  EXPECT_THAT(las_error_of({good.begin(), good.begin() + 100}), HasSubstr("ends after 100 bytes"));
  const auto with = [&](std::size_t at, auto value) {
    auto bytes = good;
    las::store(&bytes[at], value);
    return las_error_of(bytes);
  };
  EXPECT_THAT(with(25, std::uint8_t{9}), HasSubstr("LAS version 1.9"));
  EXPECT_THAT(with(94, std::uint16_t{20}), HasSubstr("has 20 bytes"));
  EXPECT_THAT(with(94, std::uint16_t{65000}), HasSubstr("has 65000 bytes"));
  EXPECT_THAT(with(96, std::uint32_t{1U << 30}), HasSubstr("the points begin at byte 1073741824"));
  EXPECT_THAT(with(96, std::uint32_t{7}), HasSubstr("the points begin at byte 7"));
  EXPECT_THAT(with(104, std::uint8_t{11}), HasSubstr("point format 11"));
  EXPECT_THAT(with(105, std::uint16_t{19}), HasSubstr("records of 19 bytes"));
  EXPECT_THAT(with(131, std::nan("")), HasSubstr("coordinate scale"));
  EXPECT_THAT(with(139, 0.0), HasSubstr("coordinate scale"));
  EXPECT_THAT(with(104, std::uint8_t{0x81}), HasSubstr("no LAZ record"));
  EXPECT_THROW(read_las("/nowhere/at/all.las"), Error);
}

TEST(LasReader, CountsBeyondTheFileGiveWhatIsThere) {
  auto bytes = small_file().bytes();
  las::store(&bytes[107], std::uint32_t{4'000'000'000});
  Report report;
  EXPECT_EQ(read_las(bytes, {}, {}, &report).size(), 10U);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("10 of 4000000000 points read")));
  bytes.resize(bytes.size() - 5);
  EXPECT_EQ(read_las(bytes).size(), 9U);
  bytes.resize(las::load<std::uint32_t>(&bytes[96]) + 3);
  EXPECT_THAT(las_error_of(bytes), HasSubstr("none of the 4000000000 points"));
}

TEST(LasReader, CountsThatDisagree) {
  auto bytes = small_file(4, 1).bytes();
  las::store(&bytes[107], std::uint32_t{10});
  las::store(&bytes[247], std::uint64_t{12'000'000'000});
  Report report;
  EXPECT_EQ(read_las(bytes, {}, {}, &report).size(), 10U);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("counts 10 points in its legacy field and 12000000000")));
  las::store(&bytes[247], std::uint64_t{0});
  EXPECT_EQ(read_las(bytes).size(), 10U);
}

TEST(LasReader, HostileVariableLengthRecords) {
  LasFile file = small_file();
  file.add_vlr("LASF_Projection", 2112, {'L', 'O', 'C', 'A', 'L', 0});
  auto bytes = file.bytes();
  EXPECT_EQ(read_las(bytes).crs_wkt, "LOCAL");
  las::store(&bytes[227 + 20], std::uint16_t{60000});
  Report report;
  EXPECT_EQ(read_las(bytes, {}, {}, &report).size(), 10U);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("says it has 60000 bytes")));
  las::store(&bytes[100], std::uint32_t{4'000'000'000});
  EXPECT_EQ(read_las(bytes).size(), 10U);
}

TEST(LasReader, ZeroBoundingBoxDoesNotMatter) {
  const PointCloud cloud = read_las(small_file().bytes());  // the test's headers all have one
  EXPECT_TRUE(exact_position(cloud, 9).isApprox(Eigen::Vector3d(1009, 2001.91, 0.63), 1e-12));
}

TEST(LasReader, WktBehindThePointsAndGeoTiffKeys) {
  LasFile file = small_file(4, 6);
  auto bytes = file.bytes();
  las::store(&bytes[235], std::uint64_t{bytes.size()});
  las::store(&bytes[243], std::uint32_t{1});
  std::vector<std::uint8_t> evlr(60);
  las::store_text(&evlr[2], 16, "LASF_Projection");
  las::store(&evlr[18], std::uint16_t{2112});
  las::store(&evlr[20], std::uint64_t{5});
  for (const char c : std::string("WKT!")) evlr.push_back(static_cast<std::uint8_t>(c));
  evlr.push_back(0);
  bytes.insert(bytes.end(), evlr.begin(), evlr.end());
  const PointCloud cloud = read_las(bytes);
  EXPECT_EQ(cloud.crs_wkt, "WKT!");
  EXPECT_EQ(cloud.axes, Axes::global);
  EXPECT_EQ(cloud.size(), 10U);

  LasFile old = small_file();
  std::vector<std::uint8_t> keys(2 * 12);
  const std::uint16_t values[] = {1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 25832};
  std::memcpy(keys.data(), values, sizeof values);
  old.add_vlr("LASF_Projection", 34735, keys);
  EXPECT_THAT(read_las(old.bytes()).crs_wkt, HasSubstr("UTM zone 32N"));
}

TEST(LasReader, CancelsAndReports) {
  const auto bytes = small_file(2, 1, 100).bytes();
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  double last = -1;
  run.progress = [&](double fraction, std::string_view) { last = fraction; };
  read_las(bytes, {}, run);
  EXPECT_EQ(last, 1.0);
  stop.request_stop();
  try {
    read_las(bytes, {}, run);
    ADD_FAILURE() << "was not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

// A cloud whose columns are larger than memory should hold comes out the same, with its large columns on file.
class LargeColumns : public testing::Test {
 protected:
  static constexpr std::size_t points = min_file_bytes / sizeof(double) + 4321;

  void SetUp() override {
    LasFile file;
    for (std::size_t i = 0; i < points; ++i) {
      std::uint8_t* p = file.add(static_cast<std::int32_t>(i), 5, static_cast<std::int32_t>(i % 1000));
      las::store(p + 12, static_cast<std::uint16_t>(i));
      las::store(p + 20, 0.25 * static_cast<double>(i));
    }
    const auto bytes = file.bytes();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  void TearDown() override { std::filesystem::remove(path); }

  static bool on_file(const PointCloud& c) {
    const auto& times = c.values<double>(arrays::time);
    return lies_on_file(times.data(), times.size() * sizeof(double));
  }
  static void expect_same(const PointCloud& cloud, const PointCloud& plain) {
    EXPECT_TRUE(on_file(cloud));
    EXPECT_FALSE(on_file(plain));
    EXPECT_EQ(cloud.values<double>(arrays::time), plain.values<double>(arrays::time));
    EXPECT_EQ(cloud.values<float>(arrays::intensity), plain.values<float>(arrays::intensity));
    EXPECT_EQ(cloud.positions(), plain.positions());
    EXPECT_EQ(cloud.origin, plain.origin);
  }

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("bole_large_columns_{}.las", ::getpid());
};

TEST_F(LargeColumns, OfAllPointsLieOnFile) {
  Report report;
  const PointCloud cloud = read_las(path, {.columns_in_memory = 0}, {}, &report);
  EXPECT_TRUE(report.warnings.empty());
  expect_same(cloud, read_las(path));
  EXPECT_EQ(cloud.values<double>(arrays::time)[points - 1], 0.25 * static_cast<double>(points - 1));
}

// How many points will be chosen is not known before they are: columns move to larger files as they grow.
TEST_F(LargeColumns, OfChosenPointsLieOnFile) {
  const double step = las_info(path).scale.x(), last = las_info(path).offset.x() + step * (points - 101);
  LasReadOptions options;
  options.bounds = CloudBounds();
  options.bounds->max.x() = last;
  const PointCloud plain = read_las(path, options);
  options.columns_in_memory = 0;
  Report report;
  const PointCloud cloud = read_las(path, options, {}, &report);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_EQ(cloud.size(), points - 100);
  expect_same(cloud, plain);
}

}  // namespace
}  // namespace bole::io
