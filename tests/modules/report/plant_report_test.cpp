// The report of a seedling: what is written, and what is left out.
#include "report/plant_report.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

namespace bole::report {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

struct Folder {
  Folder() {
    run.output_dir = fs::path(testing::TempDir()) / ("plant_report_" + std::to_string(::getpid()));
    fs::remove_all(run.output_dir), fs::create_directories(run.output_dir);
  }
  ~Folder() { fs::remove_all(run.output_dir); }
  std::string text(const char* file) const {
    std::ifstream in(run.output_dir / file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  bool has(const char* file) const { return fs::exists(run.output_dir / file); }
  Run run;
};

Table traits() {
  Table t;
  t.set("plant_id", std::vector<std::string>{"7"});
  for (const auto& [name, value] :
       {std::pair{"height", 312.4567}, {"breadth_length", 180.0}, {"breadth_width", 121.0}, {"stem_diameter", 4.87}})
    for (const auto& [part, by] : {std::pair{"", 0.0}, {"_lo", -1.0}, {"_hi", 1.0}})
      t.set(std::string(name) + part + "_mm", std::vector<double>{value + by});
  return t;
}

// Thirty points of the plant above ten of the pot.
PointCloud points() {
  PointCloud::Positions positions;
  std::vector<std::int32_t> part;
  for (int i = 0; i < 40; ++i) {
    positions.emplace_back(0.001F * static_cast<float>(i), 0.002F * static_cast<float>(i % 7),
                           0.01F * static_cast<float>(i));
    part.push_back(i < 10 ? 2 : 1);
  }
  PointCloud cloud(std::move(positions));
  cloud.set_column("part", std::move(part));
  return cloud;
}

TEST(PlantReport, WritesWhatIsConnected) {
  Folder folder;
  DataSet in;
  in.set("traits", traits());
  in.set("points", points());
  Trajectory poses;
  for (int i = 0; i < 3; ++i) poses.poses.push_back({i / 30.0, Pose(Eigen::Translation3d(0.1 * i, 0, 0.4))});
  in.set("poses", poses);
  Table held_out;
  held_out.set("view", std::vector<std::int64_t>{8, 16});
  held_out.set("name", std::vector<std::string>{"000008", "000016"});
  held_out.set("psnr_db", std::vector<double>{29, 31});
  held_out.set("psnr_plant_db", std::vector<double>{27, 28});
  in.set("held_out", held_out);
  Table field;
  field.facts["encoder"] = "hash";
  in.set("field", field);
  const auto result = write_plant_report(in, {}, folder.run);
  EXPECT_TRUE(result.report.findings.empty());

  const auto table = io::read_table(folder.run.output_dir / "traits.csv");
  EXPECT_EQ(table.rows(), 1U);
  EXPECT_EQ(table.numbers("height_mm").front(), 312.457);
  EXPECT_TRUE(folder.text("traits.csv").starts_with("plant_id,height_mm,height_lo_mm,height_hi_mm,breadth_length_mm"));
  EXPECT_EQ(io::read_cloud(folder.run.output_dir / "cloud.ply").cloud.size(), 30U);
  EXPECT_EQ(io::read_cloud(folder.run.output_dir / "scene.ply").cloud.size(), 40U);
  EXPECT_EQ(io::read_tum(folder.run.output_dir / "trajectory.tum").poses.size(), 3U);
  const auto json = nlohmann::json::parse(folder.text("field.json"));
  EXPECT_EQ(json.at("psnr_db"), 30);
  EXPECT_EQ(json.at("psnr_plant_db"), 27.5);
  EXPECT_EQ(json.at("encoder"), "hash");
  EXPECT_EQ(json.at("views").size(), 2U);
  EXPECT_EQ(json.at("views")[1].at("name"), "000016");
  EXPECT_TRUE(folder.has("plant.xlsx"));
  EXPECT_TRUE(folder.has("figures/plant.png"));
  const auto page = folder.text("report.html");
  EXPECT_THAT(page, HasSubstr("stem diameter"));
  EXPECT_THAT(page, HasSubstr("mean PSNR of 30.0 dB"));
}

TEST(PlantReport, LeavesOutWhatIsNot) {
  Folder folder;
  DataSet in;
  in.set("traits", traits());
  PlantReportOptions options;
  options.figures = false;
  write_plant_report(in, options, folder.run);
  EXPECT_TRUE(folder.has("traits.csv"));
  for (const char* file : {"cloud.ply", "scene.ply", "trajectory.tum", "field.json", "figures"})
    EXPECT_FALSE(folder.has(file)) << file;
}

TEST(PlantReport, ACloudWithoutAPlantIsTold) {
  Folder folder;
  auto cloud = points();
  cloud.set_column("part", std::vector<std::int32_t>(cloud.size(), 2));
  DataSet in;
  in.set("points", cloud);
  const auto result = write_plant_report(in, {}, folder.run);
  ASSERT_EQ(result.report.findings.size(), 1U);
  EXPECT_EQ(result.report.findings[0].code, "no_plant");
  EXPECT_EQ(io::read_cloud(folder.run.output_dir / "cloud.ply").cloud.size(), 40U);
}

TEST(PlantReport, NothingIsNoReport) {
  Folder folder;
  EXPECT_THROW(write_plant_report({}, {}, folder.run), Error);
}

}  // namespace
}  // namespace bole::report
