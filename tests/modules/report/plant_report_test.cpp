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
#include "render/charts/match_figure.h"

namespace bole::report {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

struct PlantFolder {
  PlantFolder() {
    run.output_dir = fs::path(testing::TempDir()) / ("plant_report_" + std::to_string(::getpid()));
    fs::remove_all(run.output_dir), fs::create_directories(run.output_dir);
  }
  ~PlantFolder() { fs::remove_all(run.output_dir); }
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
  PlantFolder folder;
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
  PlantFolder folder;
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
  PlantFolder folder;
  auto cloud = points();
  cloud.set_column("part", std::vector<std::int32_t>(cloud.size(), 2));
  DataSet in;
  in.set("points", cloud);
  const auto result = write_plant_report(in, {}, folder.run);
  ASSERT_EQ(result.report.findings.size(), 1U);
  EXPECT_EQ(result.report.findings[0].code, "no_plant");
  EXPECT_EQ(io::read_cloud(folder.run.output_dir / "cloud.ply").cloud.size(), 40U);
}

// Grey pictures of 80 x 60 pixels.
class GreyViews : public ViewSource {
 public:
  std::size_t size() const override { return 6; }
  void read(std::size_t, View& view, ViewParts) const override { view.color = ColorImage(80, 60, 3, 120); }
  double time_s(std::size_t i) const override { return static_cast<double>(i); }
  std::string name(std::size_t i) const override { return "view_" + std::to_string(i); }
  const RgbdCamera& camera(std::size_t) const override { return camera_; }
  bool has_depth() const override { return false; }
  const Trajectory& given_poses() const override { return none_; }
  std::string description() const override { return "grey"; }
  std::string locator() const override { return "{}"; }

 private:
  RgbdCamera camera_;
  Trajectory none_;
};

// Three pairs of neighbours with 9, 5 and 2 kept matches and one refused each, and a loop with more than all.
Table matches() {
  std::vector<std::int64_t> a, b;
  std::vector<std::string> name_a, name_b, state, reason;
  std::vector<double> x_a, y_a, x_b, y_b;
  const auto add = [&](int from, int to, int kept) {
    for (int i = 0; i <= kept; ++i) {
      a.push_back(from), b.push_back(to);
      name_a.push_back("view_" + std::to_string(from)), name_b.push_back("view_" + std::to_string(to));
      const double y = i < kept ? 30 : 10;
      x_a.push_back(5.0 * i), y_a.push_back(y), x_b.push_back(5.0 * i + 4), y_b.push_back(y + 1);
      state.emplace_back(i < kept ? "kept" : "refused"), reason.emplace_back(i < kept ? "kept" : "gms");
    }
  };
  add(0, 1, 9), add(1, 2, 2), add(2, 3, 5), add(0, 5, 14);
  Table t;
  t.set("view_a", a), t.set("view_b", b), t.set("name_a", name_a), t.set("name_b", name_b);
  t.set("x_a_px", x_a), t.set("y_a_px", y_a), t.set("x_b_px", x_b), t.set("y_b_px", y_b);
  t.set("state", state), t.set("reason", reason);
  return t;
}

TEST(PlantReport, ShowsTheMatchesOfATypicalPair) {
  const auto pair = render::typical_pair(matches());
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->name_a + " " + pair->name_b, "view_2 view_3");
  EXPECT_EQ(pair->kept.size(), 5U);
  EXPECT_EQ(pair->reasons.at("gms"), 1U);
  EXPECT_FALSE(render::typical_pair(Table{}));

  const ColorImage grey(80, 60, 3, 120);
  const auto figure = render::match_figure(*pair, grey, grey, 180);
  const auto drawn = render::figure_image(figure, 160);
  EXPECT_LE(drawn.width, 1200);
  const double px_per_mm = drawn.width / 180.0, mm_per_px = 88.5 / 80;
  const auto at = [&](double x_mm, double y_mm) {
    return drawn.pixel(static_cast<int>(x_mm * px_per_mm), static_cast<int>(y_mm * px_per_mm));
  };
  // The first kept match begins at (0, 30) of the left picture and ends at (4, 31) of the right one, in blue; the
  // refused one at (25, 10) and (29, 11), in red.
  for (const auto& [x, y] : {std::pair{0.5 * mm_per_px, 30.5 * mm_per_px}, {91.5 + 4.5 * mm_per_px, 31.5 * mm_per_px}})
    EXPECT_GT(at(x, y).b, at(x, y).r + 0.2);
  for (const auto& [x, y] :
       {std::pair{25.5 * mm_per_px, 10.5 * mm_per_px}, {91.5 + 29.5 * mm_per_px, 11.5 * mm_per_px}})
    EXPECT_GT(at(x, y).r, at(x, y).b + 0.2);

  PlantFolder folder;
  DataSet in;
  in.set("traits", traits());
  in.set("matches", matches());
  write_plant_report(in, {}, folder.run);
  EXPECT_FALSE(folder.has("figures/matches.png"));  // nothing to draw them on
  in.set("views", Data(std::shared_ptr<const ViewSource>(std::make_shared<GreyViews>())));
  EXPECT_TRUE(write_plant_report(in, {}, folder.run).report.findings.empty());
  EXPECT_TRUE(folder.has("figures/matches.png"));
  EXPECT_THAT(folder.text("report.html"), HasSubstr("5 matches were kept (blue), 1 were refused (red) (gms 1)"));
}

TEST(PlantReport, NothingIsNoReport) {
  PlantFolder folder;
  EXPECT_THROW(write_plant_report({}, {}, folder.run), Error);
}

}  // namespace
}  // namespace bole::report
