#include "report/make_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "checks.h"
#include "cloud/known_facts.h"
#include "inventory/core/value_tables.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "modules/render/small_survey.h"
#include "modules/render/well_formed.h"
#include "report/core/evaluation_section.h"
#include "report/core/html.h"
#include "report/survey_data.h"
#include "survey/core/plot_options.h"

namespace bole::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_checks::file_text;

Table plot_table() { return to_table({rectangle_area({0, 0}, 32, 32), 7.5}); }

// The outputs of inventory.plot_values for the stems and the plot that `inputs` have.
void add_plot_values(DataSet& inputs, const inventory::PlotValueOptions& options = {}) {
  const auto rule = inputs.has("plot") ? counting_rule(inputs.table("plot")) : CountingRule{};
  const auto values = inventory::plot_values(inputs.table("stems"), rule, options);
  inputs.set("plot_values", inventory::plot_value_table(values, options));
  inputs.set("diameter_classes", inventory::class_table(values));
  inputs.set("height_curve", inventory::height_curve_table(values));
  inputs.set("tree_values", inventory::tree_value_table(values, inputs.table("stems")));
}

DataSet inputs_of(const testing_data::SmallSurvey& s) {
  DataSet inputs;
  inputs.set("stems", s.stems), inputs.set("points", s.points), inputs.set("slice", s.slice), inputs.set("dem", s.dem);
  inputs.set("trajectory", s.trajectory), inputs.set("reference_trajectory", s.reference),
      inputs.set("sections", s.sections), inputs.set("rejected", s.rejected);
  inputs.set("targets", s.targets), inputs.set("matches", s.matches), inputs.set("summary", s.summary);
  inputs.set("plot", plot_table());
  add_plot_values(inputs);
  return inputs;
}

std::shared_ptr<const RunRecord> record() {
  RunRecord r;
  r.document = "forest_plot.json";
  StageRecord stage;
  stage.id = "slice", stage.type = "stems.slice";
  stage.options = {{"height", "1.3", "m", true}, {"thickness", "0.2", "m", false}};
  stage.report.message = "4 000 points <around> breast height";
  stage.report.seconds = 1.25;
  stage.report.peak_mib = 321;
  stage.report.warn("a warning of the slice & more");
  r.stages.push_back(stage);
  return std::make_shared<const RunRecord>(r);
}

class MakeReport : public testing::Test {
 protected:
  void SetUp() override {
    const char* kept = std::getenv("BOLE_FIGURES_DIR");
    dir_ = (kept != nullptr ? std::filesystem::path(kept) : std::filesystem::path(testing::TempDir())) /
           testing::UnitTest::GetInstance()->current_test_info()->name();
    keep_ = kept != nullptr;
    std::filesystem::remove_all(dir_);
    run_.output_dir = dir_;
    run_.record = record();
  }
  void TearDown() override {
    if (!keep_) std::filesystem::remove_all(dir_);
  }
  static ReportOptions quick() {
    ReportOptions o;
    o.dpi = 60;
    o.point_budget = 20000;
    return o;
  }
  std::filesystem::path dir_;
  bool keep_ = false;
  bole::Run run_;
};

std::string without_pictures(std::string html) {
  for (const char* block : {"<script", "<style"})  // what they hold is tested in a browser
    for (auto at = html.find(block); at != std::string::npos; at = html.find(block, at + 5)) {
      const auto from = html.find('>', at) + 1;
      html.erase(from, html.find(std::string("</") + (block + 1), from) - from);
    }
  const std::string begin = "src=\"data:";
  for (auto at = html.find(begin); at != std::string::npos; at = html.find(begin, at + 5))
    html.erase(at + 5, html.find('"', at + 5) - at - 5);
  return html;
}

TEST_F(MakeReport, WritesEverything) {
  const auto s = testing_data::make_small_survey();
  auto options = quick();
  if (keep_) options = {};
  options.figure_set = FigureSet::all;
  const auto result = make_report(inputs_of(s), options, run_);
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  for (const char* file : {"stems.csv",
                           "sections.csv",
                           "rejected.csv",
                           "plot_values.csv",
                           "diameter_classes.csv",
                           "height_curve.csv",
                           "tree_values.csv",
                           "matches.csv",
                           "trajectory.tum",
                           "cloud.laz",
                           "dem.tif",
                           "plot.gpkg",
                           "report.html",
                           "figures/stem_map.png",
                           "figures/stem_map.svg",
                           "figures/stem_map.pdf",
                           "figures/map_height.png",
                           "figures/map_tree.png",
                           "figures/map_intensity.png",
                           "figures/map_top_height.png",
                           "figures/dbh_scatter.svg",
                           "figures/dbh_errors.pdf",
                           "figures/dbh_histogram.png",
                           "figures/position_errors.png",
                           "figures/trajectory.svg",
                           "figures/trajectory_overlay.svg",
                           "figures/trajectory_error.pdf",
                           "figures/slices_01.png",
                           "figures/height_diameter.svg",
                           "figures/taper.pdf",
                           "figures/terrain.png",
                           "tally.html"})
    EXPECT_TRUE(std::filesystem::exists(dir_ / file)) << file;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dir_))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part")));
  EXPECT_EQ(io::read_table(dir_ / "stems.csv").rows(), s.stems.rows());
  EXPECT_EQ(io::read_geotiff(dir_ / "dem.tif").values.size(), s.dem.values.size());

  const auto html = file_text(dir_ / "report.html");
  const auto page = without_pictures(html);
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(html, HasSubstr("data:image/svg+xml;base64,"));
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(testing::ContainsRegex("(src|href)=\"[^\"#]")));
  EXPECT_THAT(page, HasSubstr("32 m × 32 m"));  // by design, whatever the distance of the targets
  EXPECT_THAT(page, HasSubstr("a warning of the slice &amp; more"));
  EXPECT_THAT(page, HasSubstr("&lt;around&gt;"));
  EXPECT_THAT(page, HasSubstr("thickness"));
  EXPECT_THAT(page, HasSubstr("321"));
  EXPECT_THAT(page, HasSubstr("rays pass through it"));
  EXPECT_THAT(page, HasSubstr("1.03"));  // published
  EXPECT_EQ(testing_data::markup_trouble(page), "");
}

TEST_F(MakeReport, WithoutBeingAskedItDrawsWhatThePageShows) {
  const auto s = testing_data::make_small_survey();
  make_report(inputs_of(s), quick(), run_);
  for (const char* file : {"figures/map_height.png", "figures/dbh_histogram.svg", "figures/height_diameter.svg",
                           "figures/terrain.png", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(dir_ / file)) << file;
  for (const char* file : {"figures/map_tree.png", "figures/map_top_height.png", "figures/slices_01.png",
                           "figures/dbh_histogram.png", "figures/dbh_histogram.pdf", "figures/stem_map.png"})
    EXPECT_FALSE(std::filesystem::exists(dir_ / file)) << file;
  EXPECT_LT(std::filesystem::file_size(dir_ / "report.html"), 10'000'000U);
}

TEST_F(MakeReport, BeginsWithWhatWasSurveyedAndTheVerdict) {
  const auto s = testing_data::make_small_survey();
  auto told = *record();
  StageRecord scan;
  scan.id = "scan", scan.type = "io.read_cloud";
  scan.options = {{"file", "/home/anna/clouds/oak_plot.laz", "", false}};
  told.stages.insert(told.stages.begin(), scan);
  run_.record = std::make_shared<const RunRecord>(told);
  auto inputs = inputs_of(s);
  auto points = s.points;
  set_fact(points.facts, facts::sensor, "Sensor X");
  inputs.set("points", points);
  auto options = quick();
  options.figures = false;
  make_report(inputs, options, run_);
  auto page = without_pictures(file_text(dir_ / "report.html"));
  const auto first = page.substr(0, page.find("</header>"));
  EXPECT_THAT(first, HasSubstr("<dd>oak_plot.laz</dd>"));
  EXPECT_THAT(page, Not(HasSubstr("anna</dd>")));
  EXPECT_THAT(first, HasSubstr("<dd>Sensor X</dd>"));
  EXPECT_THAT(first, HasSubstr("day not named in the data"));
  EXPECT_THAT(first, HasSubstr("32 m × 32 m, stems from 7.5 cm DBH"));
  EXPECT_THAT(first, HasSubstr("<div class=\"verdict sign\">\n<h2>Sign after a look at "));
  EXPECT_THAT(first, HasSubstr("Basal area"));
  EXPECT_THAT(first, HasSubstr("<svg class=\"plan\""));
  EXPECT_THAT(first, HasSubstr("<use href=\"#slice-"));
  EXPECT_THAT(first, HasSubstr("seen over"));  // why a tree is to be looked at

  told.stages[0].report.find(Severity::look, "thin_cloud", "6 points per stem, 40 are needed");
  run_.record = std::make_shared<const RunRecord>(told);
  make_report(inputs, options, run_);
  EXPECT_THAT(file_text(dir_ / "report.html"), HasSubstr("<h2>Look before you sign</h2>"));
  told.stages[0].report.find(Severity::refused, "no_ground", "There is no ground");
  run_.record = std::make_shared<const RunRecord>(told);
  const auto result = make_report(inputs, options, run_);
  page = file_text(dir_ / "report.html");
  EXPECT_THAT(page, HasSubstr("<div class=\"verdict refused\">"));
  EXPECT_THAT(page, HasSubstr("Do not use these values"));
  EXPECT_LT(page.find("There is no ground"), page.find("6 points per stem, 40 are needed"));
  EXPECT_EQ(result.report.facts.at("verdict"), "refused");
}

TEST_F(MakeReport, TheTallySheetHasEveryStemOfThePlotAndNoDiameter) {
  auto s = testing_data::make_small_survey();
  auto x = s.stems.numbers("x_m");
  x[0] = 300;  // outside
  s.stems.set("x_m", x);
  DataSet inputs;
  inputs.set("stems", s.stems), inputs.set("plot", plot_table());
  auto options = quick();
  options.figures = false;
  make_report(inputs, options, run_);
  const auto page = file_text(dir_ / "tally.html");
  const auto table = page.substr(page.find("Distance (m)"));
  EXPECT_EQ(testing_data::markup_trouble(without_pictures(page)), "");
  for (std::size_t i = 1; i < s.stems.rows(); ++i)
    EXPECT_THAT(table, HasSubstr("<td class=\"n\">" + s.stems.text("tree_id", i, 0) + "</td>"));
  EXPECT_THAT(table, Not(HasSubstr("<td class=\"n\">1</td>")));
  const double y = s.stems.numbers("y_m")[1], away = std::hypot(x[1], y);
  const double bearing = std::fmod(std::atan2(x[1], y) * 180 / std::numbers::pi + 360, 360);
  char place[64];
  std::snprintf(place, sizeof place, "<td class=\"n\">%.1f</td><td class=\"n\">%.0f</td>", away, bearing);
  EXPECT_THAT(table, HasSubstr(place));
  const auto dbh = s.stems.text("dbh_cm", 1, 1);
  EXPECT_THAT(table, Not(HasSubstr(">" + dbh + "<")));
}

TEST_F(MakeReport, SlamIsTold) {
  const auto s = testing_data::make_small_survey();
  DataSet inputs;
  Table loops, odometry;
  loops.set("from_time_s", std::vector<double>{2}), loops.set("to_time_s", std::vector<double>{31.5}),
      loops.set("way_m", std::vector<double>{27}), loops.set("correction_m", std::vector<double>{0.042}),
      loops.set("overlap", std::vector<double>{0.91}), loops.set("found_by", std::vector<std::string>{"context"});
  odometry.set("frame", std::vector<std::int64_t>{0, 1, 2}), odometry.set("time_s", std::vector<double>{1, 1.1, 1.2}),
      odometry.set("ok", std::vector<std::int64_t>{1, 0, 1}),
      odometry.set("overlap", std::vector<double>{1, 0.12, 0.8});
  inputs.set("stems", s.stems), inputs.set("loops", loops), inputs.set("odometry", odometry);
  auto told = *record();
  StageRecord slam;
  slam.id = "slam", slam.type = "slam.run";
  slam.report.counts = {{"frames", 2}, {"frames_failed", 1}, {"loops", 1}, {"loop_candidates", 3}};
  slam.report.metrics = {{"sigma0", {0.93, Unit::none}},
                         {"weakest_observability", {2.84, Unit::none}},
                         {"open_below", {2.3, Unit::none}},
                         {"registration_per_frame", {12.34, Unit::millisecond}},
                         {"loops_per_frame", {10, Unit::millisecond}}};
  slam.report.facts["lost_at_frame"] = "77";
  told.stages.push_back(slam);
  run_.record = std::make_shared<const RunRecord>(told);
  make_report(inputs, quick(), run_);
  EXPECT_EQ(io::read_table(dir_ / "loops.csv").rows(), 1u);
  EXPECT_EQ(io::read_table(dir_ / "odometry.csv").rows(), 3u);
  const auto html = file_text(dir_ / "report.html");
  const auto section = html.substr(html.find("<div id=\"slam\">"));
  for (const char* text :
       {"SLAM: from frames to a map", "Frames that could not be registered", "(below 2.3: not determined)", ">2.8<",
        "Track lost at frame", ">77<", ">0.93<", ">12.3<", "Loop closures and pose graph", ">10.0<", ">22.3<",
        "context", ">30.5<", ">4.2<", "Failed frames"})
    EXPECT_THAT(section, HasSubstr(text));

  // With poses from a file there is nothing to tell.
  told.stages.back().report.facts["trajectory"] = "poses.tum";
  run_.record = std::make_shared<const RunRecord>(told);
  make_report(inputs, quick(), run_);
  EXPECT_THAT(file_text(dir_ / "report.html"), Not(HasSubstr("SLAM: from frames")));
}

TEST_F(MakeReport, StemsAloneAreEnough) {
  DataSet inputs;
  inputs.set("stems", testing_data::make_small_survey().stems);
  run_.record = nullptr;
  auto options = quick();
  const auto result = make_report(inputs, options, run_);
  EXPECT_THAT(result.report.warnings, testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(dir_ / "report.html"));
  // The page computes no values of its own: it names the stage that does.
  EXPECT_THAT(file_text(dir_ / "report.html"), HasSubstr("inventory.plot_values is not part of this pipeline"));
  EXPECT_THAT(file_text(dir_ / "report.html"), Not(HasSubstr("class=\"cards\"")));
}

TEST_F(MakeReport, WithoutAPlotNothingIsToldPerHectare) {
  DataSet inputs;
  inputs.set("stems", testing_data::make_small_survey().stems);
  add_plot_values(inputs);
  make_report(inputs, quick(), run_);
  EXPECT_THAT(file_text(dir_ / "report.html"), Not(HasSubstr("per ha<")));
  inputs.set("plot", plot_table());
  add_plot_values(inputs);
  make_report(inputs, quick(), run_);
  EXPECT_THAT(file_text(dir_ / "report.html"), HasSubstr("per ha<"));
  EXPECT_THAT(file_text(dir_ / "report.html"), HasSubstr("32 m × 32 m"));
}

TEST_F(MakeReport, TreesOutsideAreCountedAndNotListed) {
  auto s = testing_data::make_small_survey();
  auto x = s.stems.numbers("x_m");
  std::vector<std::int64_t> seen(x.size(), 0);
  std::vector<std::string> state(x.size(), "check"),
      reasons(x.size(), "wide interval: +-5.4 cm; only 90 deg of the bark seen");
  for (std::size_t i = 0; i + 1 < x.size(); ++i) x[i] = 100;
  s.stems.set("x_m", x), s.stems.set("height_seen", seen), s.stems.set("state", state), s.stems.set("reasons", reasons);
  DataSet inputs;
  inputs.set("stems", s.stems), inputs.set("slice", s.slice), inputs.set("plot", plot_table());
  add_plot_values(inputs);
  const auto result = make_report(inputs, quick(), run_);
  EXPECT_EQ(result.report.counts.at("stems_outside"), 39);
  EXPECT_EQ(result.report.counts.at("trees_to_check"), 1);
  const auto page = without_pictures(file_text(dir_ / "report.html"));
  EXPECT_THAT(page, HasSubstr("39 stems outside the plot are in stems.csv"));
  EXPECT_THAT(page, HasSubstr("Trees to look at in the plot (1)"));
  EXPECT_THAT(page, HasSubstr("wide interval: ±5.4 cm; only 90° of the bark seen"));
  EXPECT_THAT(page, HasSubstr("≥ "));
  EXPECT_THAT(page, HasSubstr("tops seen on 0 of 1 stems: heights are lower bounds"));
  EXPECT_THAT(page.substr(0, page.find("<section id=\"terms\">")), Not(HasSubstr("Lorey")));
  EXPECT_FALSE(std::filesystem::exists(dir_ / "figures/slices_02.png"));
}

TEST_F(MakeReport, WhatAPersonDecidedNeedsNoLookAnyMore) {
  auto s = testing_data::make_small_survey();
  const auto n = s.stems.rows();
  std::vector<std::string> state(n, "auto"), quality(n, "good"), reasons(n);
  const std::vector<std::string> decided{"check", "accepted", "edited", "rejected", "auto"};
  for (std::size_t i = 0; i < decided.size(); ++i)
    state[i] = decided[i], quality[i] = "poor", reasons[i] = "reason of stem " + std::to_string(i + 1);
  s.stems.set("state", state), s.stems.set("quality", quality), s.stems.set("reasons", reasons);
  DataSet inputs;
  inputs.set("stems", s.stems);
  auto options = quick();
  options.figures = options.tables = false;
  add_plot_values(inputs, {.class_width_cm = 2.5});
  make_report(inputs, options, run_);
  const auto page = without_pictures(file_text(dir_ / "report.html"));
  EXPECT_THAT(page, HasSubstr("Trees to look at in the plot (2)"));
  EXPECT_THAT(page, HasSubstr("reason of stem 1<"));
  EXPECT_THAT(page, HasSubstr("reason of stem 5<"));
  for (const char* stem : {"2", "3", "4"}) EXPECT_THAT(page, Not(HasSubstr("reason of stem " + std::string(stem))));
  EXPECT_THAT(page, HasSubstr("17.5–20.0"));  // classes of 2.5 cm
  EXPECT_THAT(page, HasSubstr("survey.plot"));
  for (const auto& name : {"shape", "width", "length", "radius"}) {
    EXPECT_NE(option_table(static_cast<const survey::PlotOptions*>(nullptr)).find(name), nullptr) << name;
    EXPECT_THAT(page.substr(page.find("No plot boundary"), 300), HasSubstr(name));
  }
}

// Whoever signs can add up the plot from the stem table: it says which stems count, and the page which do not.
TEST_F(MakeReport, TheStemTableSaysWhichStemsCount) {
  auto s = testing_data::make_small_survey();
  const auto n = s.stems.rows();
  std::vector<std::string> state(n, "auto");
  auto dbh = s.stems.numbers("dbh_cm");
  const auto x = s.stems.numbers("x_m"), y = s.stems.numbers("y_m");
  ASSERT_GE(n, 3U);
  state[0] = "rejected", dbh[1] = 5.5;
  s.stems.set("state", state), s.stems.set("dbh_cm", dbh);
  const CountingRule rule{rectangle_area({0, 0}, 200, 200), 7.5};
  DataSet inputs;
  inputs.set("stems", s.stems), inputs.set("plot", to_table(rule));
  auto options = quick();
  options.figures = false;
  add_plot_values(inputs);
  make_report(inputs, options, run_);
  const auto counted = io::read_table(dir_ / "stems.csv").integers("counted");
  const auto m = inventory::plot_values(s.stems, rule);
  EXPECT_EQ(counted[0], 0);
  EXPECT_EQ(counted[1], 0);
  EXPECT_EQ(std::count(counted.begin(), counted.end(), 1), static_cast<std::ptrdiff_t>(m.stems));
  double area_m2 = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (counted[i] == 1) area_m2 += std::numbers::pi / 40000 * dbh[i] * dbh[i];
  EXPECT_NEAR(area_m2, m.basal_area_m2, 1e-12);
  const auto page = without_pictures(file_text(dir_ / "report.html"));
  EXPECT_THAT(page,
              HasSubstr("Listed here, but not part of the values of the plot: tree " + s.stems.text("tree_id", 1, 0) +
                        " (thinner than 7.5 cm); tree " + s.stems.text("tree_id", 0, 0) + " (rejected by hand)."));
  EXPECT_THAT(page, HasSubstr("Checked and accepted"));
  EXPECT_THAT(page, HasSubstr("Breast height"));
}

TEST_F(MakeReport, HeroIsDrawnWhenAskedFor) {
  const auto s = testing_data::make_small_survey();
  DataSet inputs;
  inputs.set("stems", s.stems), inputs.set("points", s.points);
  auto options = quick();
  options.hero = true, options.tables = options.cloud = false;
  make_report(inputs, options, run_);
  const auto png = file_text(dir_ / "figures/hero.png");
  ASSERT_GT(png.size(), 24U);
  const auto width = static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]);
  EXPECT_NEAR(width, 1600, 1);
}

TEST_F(MakeReport, NoStemsNoTrouble) {
  Table empty;
  for (const char* c : {"x_m", "y_m", "dbh_cm"}) empty.set(c, std::vector<double>{});
  DataSet inputs;
  inputs.set("stems", empty);
  add_plot_values(inputs);
  make_report(inputs, quick(), run_);
  EXPECT_TRUE(std::filesystem::exists(dir_ / "report.html"));
}

TEST_F(MakeReport, OneFigureThatFailsEndsNothing) {
  DataSet inputs;
  auto s = testing_data::make_small_survey();
  auto broken = s.matches;
  broken.remove("dbh_cm");
  inputs.set("stems", s.stems), inputs.set("matches", broken), inputs.set("plot", plot_table());
  PointCloud nowhere(PointCloud::Positions(5, Eigen::Vector3f::Constant(std::nanf(""))));
  inputs.set("points", nowhere);
  auto options = quick();
  const auto result = make_report(inputs, options, run_);
  EXPECT_THAT(result.report.warnings, testing::Contains(HasSubstr("map by height")));
  EXPECT_TRUE(std::filesystem::exists(dir_ / "figures/dbh_histogram.svg"));
  EXPECT_THAT(file_text(dir_ / "report.html"), HasSubstr("map by height"));
}

TEST_F(MakeReport, TitleIsHarmless) {
  DataSet inputs;
  inputs.set("stems", testing_data::make_small_survey().stems);
  auto options = quick();
  options.title = "<script>alert('x')</script>";
  make_report(inputs, options, run_);
  EXPECT_THAT(file_text(dir_ / "report.html"), Not(HasSubstr("<script>alert")));
}

TEST_F(MakeReport, CancelStops) {
  std::stop_source stop;
  run_.cancel = stop.get_token();
  stop.request_stop();
  DataSet inputs;
  inputs.set("stems", testing_data::make_small_survey().stems);
  EXPECT_THROW(make_report(inputs, quick(), run_), Error);
  EXPECT_FALSE(std::filesystem::exists(dir_ / "report.html"));
}

TEST_F(MakeReport, NeedsAFolder) {
  run_.output_dir.clear();
  DataSet inputs;
  inputs.set("stems", testing_data::make_small_survey().stems);
  try {
    make_report(inputs, quick(), run_);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("--out"));
  }
}

Table summary_of(const std::vector<std::tuple<std::string, double, std::string, std::string>>& rows) {
  std::vector<std::string> measure, unit, published;
  std::vector<double> value;
  for (const auto& [m, v, u, p] : rows)
    measure.push_back(m), value.push_back(v), unit.push_back(u), published.push_back(p);
  Table t;
  t.set("measure", measure), t.set("value", value), t.set("unit", unit), t.set("published", published);
  return t;
}

TEST(Evaluation, NamesForPeople) {
  const auto summary = summary_of({{"dbh_rmse", 0.61234, "cm", "1.03"},
                                   {"matched", 40, "", ""},
                                   {"position_mean_x", -0.0412, "m", "-0.048"},
                                   {"ate_rmse", 1e-9, "m", ""},
                                   {"ate_mean", 1e-9, "m", ""},
                                   {"new_measure", 3, "", ""},
                                   {"dbh_20_to_24_cm_trees", 7, "", ""},
                                   {"dbh_20_to_24_cm_bias", 0.126, "cm", ""},
                                   {"distance_0_to_5_m_trees", 9, "", ""}});
  const auto trees = evaluation_html(summary), walk = walk_evaluation_html(summary, false), html = trees + walk;
  EXPECT_EQ(testing_data::markup_trouble("<div>" + html + "</div>"), "");
  EXPECT_THAT(html, HasSubstr("DBH RMSE</abbr></td><td class=\"n\">0.61</td><td>cm</td><td class=\"n\">1.03</td>"));
  EXPECT_THAT(html, HasSubstr("\u22120.048"));
  EXPECT_THAT(html, HasSubstr("<td>new measure</td>"));
  EXPECT_THAT(
      html,
      HasSubstr(
          "<td>20–24</td><td class=\"n\">7</td><td class=\"n\"></td><td class=\"n\"></td><td class=\"n\">0.13</td>"));
  EXPECT_THAT(html, HasSubstr("<td>0–5</td><td class=\"n\">9</td>"));
  EXPECT_LT(html.find("Found"), html.find("Mean error in x"));
  EXPECT_LT(html.find("Mean error in x"), html.find("DBH RMSE"));
  for (const char* key : {"dbh_", "position_", "_to_", "ate_", "given poses"}) EXPECT_THAT(html, Not(HasSubstr(key)));
  EXPECT_THAT(walk, HasSubstr("Absolute trajectory error (ATE) after alignment"));
  EXPECT_THAT(trees, Not(HasSubstr("trajectory")));
  EXPECT_THAT(walk_evaluation_html(summary, true), HasSubstr("given poses"));
  EXPECT_EQ(evaluation_html(summary_of({})), "");
  EXPECT_EQ(walk_evaluation_html(summary_of({}), true), "");
}

TEST(ReportStage, IsRegistered) {
  pipeline::StageRegistry registry;
  report::register_stages(registry);
  const auto& type = registry.at("report.plot");
  EXPECT_TRUE(type.writes_files);
  EXPECT_NE(type.input("reference_trajectory"), nullptr);
  EXPECT_FALSE(type.input("stems")->optional);
}

TEST(Html, Base64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

}  // namespace
}  // namespace bole::report
