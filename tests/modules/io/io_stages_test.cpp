#include <gmock/gmock.h>

#include <cmath>

#include "io/core/clouds/see_cloud.h"
#include "io/core/clouds/take_cloud.h"
#include "io_test_tools.h"
#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

const pipeline::StageType& stage(const char* name) {
  pipeline::register_all_stages(pipeline::StageRegistry::global());
  return pipeline::StageRegistry::global().at(name);
}

pipeline::StageResult run(const char* name, const std::map<std::string, std::string>& values) {
  const auto& type = stage(name);
  OptionSet options(*type.options);
  for (const auto& [option, value] : values) options.set_text(option, value);
  return pipeline::run_stage(type, {}, options, {});
}

TEST(IoStages, ReadWhatTheirOptionsName) {
  const TempDir dir;
  write_file(dir / "a.xyz", "x;y;z\n100;200;300\n");
  const auto cloud = run("io.read_cloud", {{"file", (dir / "a.xyz").string()}, {"unit", "centimetre"}});
  EXPECT_TRUE(cloud.outputs.cloud("points").position(0).isApprox(Eigen::Vector3d(1, 2, 3), 1e-6));
  EXPECT_THAT(cloud.report.message, HasSubstr("a.xyz: 1 points"));

  std::string bin;
  for (const float v : {3.F, 0.F, 0.F, 1.F}) put(bin, v);
  write_file(dir / "frames/0.bin", bin);
  const auto frames = run("io.read_scan", {{"file", (dir / "frames").string()}, {"sensor", "hdl64e_s2"}});
  EXPECT_EQ(frames.outputs.frames("frames").sensor_model(), "hdl64e_s2");
  EXPECT_EQ(frames.report.counts.at("frames"), 1);

  write_file(dir / "t.csv", "a,b\n1,2\n");
  EXPECT_EQ(run("io.read_table", {{"file", (dir / "t.csv").string()}}).outputs.table("table").rows(), 1U);

  write_file(dir / "t.tum", "# c\n1 0 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n");
  const auto path = run("io.read_trajectory", {{"file", (dir / "t.tum").string()}});
  EXPECT_EQ(path.report.metrics.at("length").value, 3);
  write_file(dir / "t.kitti", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(
      run("io.read_trajectory", {{"file", (dir / "t.kitti").string()}}).outputs.trajectory("trajectory").poses.size(),
      1U);
}

TEST(IoStages, ErrorsCarryTheStageAndSayWhatToDo) {
  for (const char* name : {"io.read_cloud", "io.read_scan", "io.read_table", "io.read_track", "io.read_trajectory"}) {
    const auto text = error_of([&] { run(name, {}); });
    EXPECT_THAT(text, HasSubstr(name));
    EXPECT_THAT(text, HasSubstr("Set the option file"));
  }
  EXPECT_THAT(error_of([] {
                run("io.read_scan", {{"file", "/nowhere"}, {"min_range", "10"}, {"max_range", "5"}});
              }),
              HasSubstr("min_range below max_range"));
}

TEST(IoStages, EveryOptionHasADefaultThatItAccepts) {
  for (const char* name : {"io.read_cloud", "io.read_scan", "io.read_table", "io.read_track", "io.read_trajectory"})
    for (const auto& spec : stage(name).options->specs) {
      EXPECT_NO_THROW(spec.checked(spec.default_value)) << spec.name;
      EXPECT_TRUE(spec.help.ends_with('.')) << spec.name;
    }
}

// ---- data in memory in place of a file

PointCloud three_points() {
  PointCloud cloud({{1, 2, 3}, {4, 5, 6}, {std::nanf(""), 0, 0}}, {500000, 5400000, 0});
  cloud.set_column("Reflectance", std::vector<float>{1, 2, 3});
  cloud.set_column("red", std::vector<std::uint16_t>{7, 8, 9});
  cloud.facts["clock"] = "utc";
  cloud.crs_wkt = "PROJCS[...]";
  cloud.axes = Axes::global;
  return cloud;
}

TEST(TakeCloud, IsReadAsAFileIs) {
  const auto reading = take_cloud(three_points());
  ASSERT_EQ(reading.cloud.size(), 2U);
  EXPECT_EQ(reading.report.counts.at("dropped_points"), 1);
  EXPECT_EQ(reading.report.facts.at("format"), "memory");
  EXPECT_TRUE(reading.cloud.position(1).isApprox(Eigen::Vector3d(500004, 5400005, 6)));
  EXPECT_EQ(reading.cloud.values<float>(arrays::intensity), (std::vector<float>{1, 2}));
  EXPECT_EQ(reading.cloud.values<std::uint16_t>(arrays::red), (std::vector<std::uint16_t>{7, 8}));
}

TEST(TakeCloud, FactsAndAxesStayUnlessTheOptionsNameThem) {
  EXPECT_EQ(take_cloud(three_points()).cloud.axes, Axes::global);
  CloudReadOptions options;
  options.axes = Axes::plot;
  const auto cloud = take_cloud(three_points(), options).cloud;
  EXPECT_EQ(cloud.axes, Axes::plot);
  EXPECT_EQ(cloud.facts.at("clock"), "utc");
  EXPECT_EQ(cloud.crs_wkt, "PROJCS[...]");
}

TEST(TakeCloud, UnitAxisAndBoundsHold) {
  SeeCloudOptions options;
  options.unit = LengthUnit::centimetre;
  options.up = UpAxis::y;
  options.reading.bounds = "0,0,300,300";
  const auto reading = see_cloud(PointCloud({{100, 200, -50}, {400, 0, 0}}), options).reading;
  ASSERT_EQ(reading.cloud.size(), 1U);
  EXPECT_EQ(reading.report.counts.at("points_outside_bounds"), 1);
  EXPECT_TRUE(reading.cloud.position(0).isApprox(Eigen::Vector3d(1, 0.5, 2)));
  EXPECT_THAT(reading.report.message, HasSubstr("1 points, given in memory"));
}

TEST(TakeCloud, NumbersThatAreNoCoordinatesAreRefused) {
  EXPECT_THROW(take_cloud(PointCloud({{1e30F, 0, 0}, {0, 1e30F, 0}})), Error);
}

}  // namespace
}  // namespace bole::io
