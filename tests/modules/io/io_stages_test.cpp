#include <gmock/gmock.h>

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

}  // namespace
}  // namespace bole::io
