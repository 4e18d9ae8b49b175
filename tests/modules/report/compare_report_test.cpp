// From folders of runs to the files of their comparison.
#include "report/compare/compare_report.h"
#include "checks.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "evaluation/core/compare_runs.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/runs/plot_file.h"
#include "io/core/runs/run_folders.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "report/compare/compare_tables.h"

namespace bole::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_checks::file_text;

Table trees(unsigned seed, double dx_m, double dbh_cm, double noise_m) {
  std::mt19937 random(seed);
  std::mt19937 noise(7);
  std::normal_distribution<double> error(0, noise_m);
  std::vector<std::int64_t> id;
  std::vector<double> x, y, dbh;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      id.push_back(static_cast<std::int64_t>(id.size()) + 1);
      x.push_back(3.0 * i - 7.5 + 1.5 * seed + static_cast<double>(random() % 1000) / 1000 + dx_m + error(noise));
      y.push_back(3.0 * j - 6 + static_cast<double>(random() % 1000) / 1000 + error(noise));
      dbh.push_back(15 + static_cast<double>(random() % 2000) / 100 + dbh_cm);
    }
  Table t;
  t.set("tree_id", id);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("dbh_cm", dbh);
  return t;
}

Trajectory walk(double off_m) {
  Trajectory t;
  for (int i = 0; i <= 200; ++i) {
    StampedPose p;
    p.time_s = 0.1 * i;
    p.T_target_sensor.translation() =
        Eigen::Vector3d(-6 + 0.06 * i, 3 * std::sin(0.05 * i) + (i > 100 ? off_m : 0), 1.5);
    t.poses.push_back(p);
  }
  return t;
}

// Another seed is another stand: half a row further.
// Rings of points at breast height about each tree, and some ground.
PointCloud cloud_of(const Table& stems) {
  PointCloud::Positions points;
  std::vector<float> heights;
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int i = 0; i < 60; ++i) {
      const double a = 0.1047 * i, r = dbh[k] / 200;
      const bool low = i % 3 == 0;
      points.push_back(Eigen::Vector3d(x[k] + r * std::cos(a), y[k] + r * std::sin(a), low ? 0.1 : 1.3).cast<float>());
      heights.push_back(low ? 0.1F : 1.3F);
    }
  PointCloud cloud(std::move(points));
  cloud.axes = Axes::plot;
  cloud.set_column(arrays::height_above_ground, heights);
  return cloud;
}

class CompareReport : public testing::Test {
 protected:
  void SetUp() override {
    const char* kept = std::getenv("BOLE_FIGURES_DIR");
    keep_ = kept != nullptr;
    dir_ = (keep_ ? std::filesystem::path(kept) : std::filesystem::path(testing::TempDir())) /
           (std::string("compare_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(dir_);
    run_.output_dir = dir_ / "out";
  }
  void TearDown() override {
    if (!keep_) std::filesystem::remove_all(dir_);
  }

  void write_run(const std::string& name, const std::string& preset, unsigned seed, double dx_m, double dbh_cm,
                 double noise_m, bool reference, bool cloud = false) {
    const auto folder = dir_ / name;
    std::filesystem::create_directories(folder);
    const auto stems = trees(seed, dx_m, dbh_cm, noise_m);
    io::write_table(folder / "stems.csv", stems);
    io::write_plot(folder / "plot.csv", {rectangle_area({0, 0}, 20, 20), 7.5});
    io::write_tum(folder / "trajectory.tum", walk(dx_m));
    if (reference) {
      io::write_table(folder / "reference_trees.csv", trees(seed, 0, 0, 0));
      io::write_tum(folder / "reference_trajectory.tum", walk(0));
    }
    if (cloud) io::write_cloud(folder / "cloud.las", cloud_of(stems));
    if (loops_) std::ofstream(folder / "loops.csv") << "from_time_s,to_time_s\n1,15\n3,18\n";
    std::ofstream(folder / "summary.json")
        << R"({"axes": "plot", "stages": [{"type": "slam.run", "options": {"preset": ")" << preset << "\"}}]}";
    folders_ += (folders_.empty() ? "" : ",") + folder.string();
  }

  pipeline::StageResult compare(const CompareReportOptions& options, const std::string& plots = {}) {
    io::RunFolderOptions folders;
    folders.folders = folders_;
    folders.plots = plots;
    auto read = io::read_run_folders(folders, run_);
    auto found = evaluation::compare_runs(evaluation::runs_of({&read.runs, &read.stems, &read.poses, &read.boundaries,
                                                               &read.reference_stems, &read.reference_poses}),
                                          {}, nullptr, {}, run_);
    DataSet in;
    in.set("runs", read.runs);
    in.set("compared", found.runs);
    in.set("groups", found.groups);
    in.set("pairs", found.pairs);
    in.set("trees", found.trees);
    in.set("stems", read.stems);
    in.set("poses", read.poses);
    in.set("boundaries", read.boundaries);
    in.set("reference_poses", read.reference_poses);
    in.set("loops", read.loops);
    return write_compare_report(in, options, run_);
  }

  static CompareReportOptions quick() {
    CompareReportOptions o;
    o.dpi = 60;
    return o;
  }

  std::filesystem::path dir_;
  std::string folders_;
  bool keep_ = false, loops_ = false;
  bole::Run run_;
};

TEST_F(CompareReport, WritesTablesFiguresAndPage) {
  write_run("forest", "forest", 1, 0.01, 0.3, 0.02, true, true);
  write_run("loam", "loam", 1, 0.03, 2.5, 0.06, true, true);
  auto options = quick();
  if (keep_) options.dpi = 150;
  const auto result = compare(options, "plot1,plot1");
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  for (const char* file : {"runs.csv", "positions.csv", "diameters.csv", "detection.csv", "trajectories.csv",
                           "pairs.csv", "compared_trees.csv", "comparison.json", "report.html"})
    EXPECT_TRUE(std::filesystem::is_regular_file(run_.output_dir / file)) << file;
  for (const char* figure : {"paths", "slices", "position_map", "position_errors", "dbh_scatter", "dbh_errors"})
    for (const char* ending : {".png", ".svg", ".pdf"})
      EXPECT_TRUE(std::filesystem::is_regular_file(run_.output_dir / "figures" / (std::string(figure) + ending)))
          << figure << ending;
  EXPECT_FALSE(std::filesystem::exists(run_.output_dir / "figures/loop_closure.png")) << "no run closed a loop";
  const auto diameters = io::read_table(run_.output_dir / "diameters.csv");
  ASSERT_EQ(diameters.rows(), 2U);
  EXPECT_NEAR(diameters.numbers("dbh_bias_cm")[1], 2.5, 1e-6);
  EXPECT_NEAR(diameters.numbers("published_dbh_rel_bias_pct")[0], 1.22, 1e-9) << "improved LOAM beside forest";
  EXPECT_NEAR(diameters.numbers("published_dbh_rel_bias_pct")[1], 12.80, 1e-9) << "LOAM beside loam";
  const auto json = nlohmann::json::parse(file_text(run_.output_dir / "comparison.json"));
  EXPECT_EQ(json.at("runs").size(), 2U);
  EXPECT_EQ(json.at("groups")[0].at("matched"), 25);
  EXPECT_EQ(json.at("pairs")[0].at("against"), "forest");
  EXPECT_TRUE(json.at("pairs")[0].at("published_rmse_x_m").is_null()) << "a difference of runs has no published figure";
  const auto page = file_text(run_.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("(12.80)"));
  EXPECT_THAT(page, HasSubstr("from field data"));
}

TEST_F(CompareReport, LoopClosuresAreShownWhereARunHasSome) {
  write_run("open", "forest loops=none", 1, 0.12, 0.3, 0.02, true, true);
  loops_ = true;
  write_run("closed", "forest", 1, 0.01, 0.3, 0.02, true, true);
  auto options = quick();
  if (keep_) options.dpi = 150;
  const auto result = compare(options, "plot1,plot1");
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  const auto figure = file_text(run_.output_dir / "figures/loop_closure.svg");
  ASSERT_FALSE(figure.empty());
  EXPECT_THAT(file_text(run_.output_dir / "report.html"), HasSubstr("green lines join the two places"));
  // Two pictures: the maps of both runs, from their clouds.
  std::size_t pictures = 0;
  for (auto at = figure.find("<image"); at != std::string::npos; at = figure.find("<image", at + 1)) ++pictures;
  EXPECT_EQ(pictures, 2U);
}

TEST_F(CompareReport, FiguresOfSeveralPlotsAreByPlotAndPooled) {
  write_run("a1", "forest", 1, 0.01, 0.3, 0.02, true);
  write_run("b1", "loam", 1, 0.03, 2.5, 0.06, true);
  write_run("a2", "forest", 2, 0.01, 0.3, 0.02, true);
  write_run("b2", "loam", 2, 0.03, 2.5, 0.06, true);
  const auto result = compare(quick());
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  for (const char* figure : {"dbh_scatter", "dbh_scatter_1", "dbh_scatter_2", "position_errors", "position_map_1",
                             "position_map_2", "paths_1"})
    EXPECT_TRUE(std::filesystem::is_regular_file(run_.output_dir / "figures" / (std::string(figure) + ".png")))
        << figure;
  const auto positions = io::read_table(run_.output_dir / "positions.csv");
  EXPECT_EQ(positions.rows(), 6U) << "four runs, two systems over both plots";
  EXPECT_FALSE(positions.has("published_mu_x_m")) << "stands of no paper";
  EXPECT_THAT(file_text(run_.output_dir / "report.html"), Not(HasSubstr("from field data")));
}

TEST_F(CompareReport, WithoutAReferenceThereAreNoTablesOfErrors) {
  write_run("a", "best", 1, 0, 0, 0, false);
  write_run("b", "best", 1, 0.02, 0.5, 0, false);
  const auto result = compare(quick());
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(run_.output_dir / "diameters.csv"));
  EXPECT_NEAR(io::read_table(run_.output_dir / "pairs.csv").numbers("dbh_bias_cm")[0], 0.5, 1e-9);
  EXPECT_THAT(file_text(run_.output_dir / "figures/dbh_scatter.svg").size(), testing::Gt(1000U));
}

TEST_F(CompareReport, ACloudThatCannotBeReadIsAFinding) {
  write_run("a", "best", 1, 0, 0, 0, true);
  std::ofstream(dir_ / "a" / "cloud.las") << "no cloud";
  const auto result = compare(quick());
  ASSERT_FALSE(result.report.findings.empty());
  EXPECT_THAT(result.report.findings[0].text, HasSubstr("paths on the cloud could not be written"));
  EXPECT_TRUE(std::filesystem::exists(run_.output_dir / "positions.csv"));
}

TEST(CompareTables, PublishedFiguresStandInBrackets) {
  Table groups;
  for (const char* name : {"scope", "plot", "system", "name", "against"})
    groups.set(name, std::vector<std::string>{"run", "run"});
  groups.set("runs", std::vector<std::int64_t>{1, 1});
  const auto& part = compare_parts()[1];
  for (const auto& column : part.columns) groups.set(column.name, std::vector<double>{1.234, std::nan("")});
  groups.set("published_dbh_rel_bias_pct", std::vector<double>{-0.59, std::nan("")});
  const auto printed = printed_part(part, groups);
  ASSERT_EQ(printed.rows(), 1U) << "a row without figures is left out";
  EXPECT_EQ(printed.texts("dbh_rel_bias_pct")[0], "1.23 (\u22120.59)");
  EXPECT_EQ(printed.texts("dbh_rmse_cm")[0], "1.23");
}

}  // namespace
}  // namespace bole::report
