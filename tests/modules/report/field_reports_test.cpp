// The reports of rows and of steering tests.
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "report/check_files.h"
#include "report/revisit_report.h"
#include "report/rows/rows_report.h"
#include "report/steering_report.h"

namespace bole::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Folder {
  Folder() {
    RunRecord before;
    before.stages.push_back({"rows", "rows.from_stems", {}, {}, false});
    before.stages.back().report.warn("planted too unevenly to tell missing plants");
    run.record = std::make_shared<const RunRecord>(std::move(before));
    // Tests run side by side: each has a folder of its own.
    run.output_dir = fs::path(::testing::TempDir()) / ("field_reports_" + std::to_string(::getpid()));
    fs::remove_all(run.output_dir), fs::create_directories(run.output_dir);
  }
  ~Folder() { fs::remove_all(run.output_dir); }
  bole::Run run;
};

template <class... Columns>
Table table(Columns&&... columns) {
  Table t;
  (t.set(columns.first, columns.second), ...);
  return t;
}

using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;
using Texts = std::vector<std::string>;

constexpr const char* utm32 =
    "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
    "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
    "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",9],"
    "PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",0],"
    "UNIT[\"metre\",1]]";

DataSet drawn_rows(const std::string& crs) {
  DataSet in;
  auto rows =
      table(std::pair("row_id", Integers{1, 2}), std::pair("angle_deg", Numbers{0, 90}),
            std::pair("x0_m", Numbers{0, 3}), std::pair("y0_m", Numbers{0, 5}), std::pair("x1_m", Numbers{4, 3}),
            std::pair("y1_m", Numbers{0, 9}), std::pair("plants", Integers{2, 0}));
  if (!crs.empty()) rows.facts["crs"] = crs;
  in.set("rows", std::move(rows));
  in.set("plants",
         table(std::pair("row_id", Integers{1, 1, 1}), std::pair("number", Integers{1, 2, 3}),
               std::pair("x_m", Numbers{0, 2, 4}), std::pair("y_m", Numbers{0, 0, 0}),
               std::pair("state", Texts{"present", "missing", "present"}), std::pair("across_m", Numbers{0, 0, 0})));
  in.set("lines", table(std::pair("row_id", Integers{1, 1, 2, 2}), std::pair("number", Integers{1, 2, 1, 2}),
                        std::pair("x_m", Numbers{0, 4, 3, 3}), std::pair("y_m", Numbers{0, 0, 5, 9})));
  in.set("edits", table(std::pair("edit", Integers{1}), std::pair("action", Texts{"add"}),
                        std::pair("row_id", Texts{"2"}), std::pair("outcome", Texts{"applied"}),
                        std::pair("message", Texts{""}), std::pair("author", Texts{"A. Smith"}),
                        std::pair("time", Texts{""}), std::pair("reason", Texts{"<seen>"})));
  return in;
}

TEST(RowsReport, WritesDrawnRowsEditsAndThePage) {
  Folder folder;
  const auto in = drawn_rows(utm32);
  RowsReportOptions options;
  options.figures = false;
  const auto result = write_rows_report(in, options, folder.run);
  EXPECT_TRUE(result.report.warnings.empty()) << result.report.warnings.front();
  for (const char* name : {"rows.csv", "plants.csv", "edits.csv", "rows.gpkg", "rows.geojson", "report.html"})
    EXPECT_TRUE(fs::exists(folder.run.output_dir / name)) << name;
  // A drawn row without a plant leads a machine too.
  EXPECT_THAT(text_of(folder.run.output_dir / "ab_lines.geojson"), HasSubstr("\"row_id\": 2"));
  const auto page = text_of(folder.run.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("Plants in rows: 2 in 2; missing within rows: 1"));
  EXPECT_THAT(page, HasSubstr("A. Smith"));
  EXPECT_THAT(page, HasSubstr("&lt;seen&gt;"));
  EXPECT_THAT(page, HasSubstr("rows: planted too unevenly to tell missing plants"));
  EXPECT_THAT(page, HasSubstr("rows.geojson"));
}

// A GIS reads metres of a plot as degrees near 0 E 0 N.
TEST(RowsReport, WithoutAPlaceOnTheEarthThereIsNoGeoJson) {
  Folder folder;
  RowsReportOptions options;
  options.figures = false;
  const auto result = write_rows_report(drawn_rows(""), options, folder.run);
  for (const char* name : {"rows.geojson", "ab_lines.geojson"}) {
    EXPECT_FALSE(fs::exists(folder.run.output_dir / name)) << name;
    EXPECT_THAT(result.report.facts.at(name), HasSubstr("not written"));
  }
  EXPECT_TRUE(fs::exists(folder.run.output_dir / "rows.gpkg"));
  EXPECT_THAT(result.report.message, HasSubstr("no GeoJSON"));
  EXPECT_THAT(text_of(folder.run.output_dir / "report.html"), HasSubstr("there is no GeoJSON"));
}

// A frame of two rows of three tubes on a floor.
PointCloud frame_points(bool floor, bool numbered) {
  PointCloud::Positions points;
  std::vector<std::int32_t> plant;
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 40; ++i) {
      points.emplace_back(k % 2 == 0 ? -0.7F : 0.8F, 2.0F + 0.9F * static_cast<float>(k / 2),
                          -0.4F + 0.025F * static_cast<float>(i));
      plant.push_back(k + 1);
    }
  if (floor)
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 60; ++j) {
        points.emplace_back(-3 + 0.1F * static_cast<float>(i), 0.1F * static_cast<float>(j), -0.45F);
        plant.push_back(0);
      }
  PointCloud cloud(std::move(points));
  if (numbered) cloud.set_column("plant", std::move(plant));
  return cloud;
}

DataSet frame_with_rows() {
  DataSet in;
  const Integers ids{1, 1, 1, 2, 2, 2};
  const Numbers x{-0.7, -0.7, -0.7, 0.8, 0.8, 0.8}, y{2, 2.9, 3.8, 2, 2.9, 3.8};
  in.set("rows", table(std::pair("row_id", Integers{1, 2}), std::pair("angle_deg", Numbers{90, 90}),
                       std::pair("x0_m", Numbers{-0.7, 0.8}), std::pair("y0_m", Numbers{2, 2}),
                       std::pair("x1_m", Numbers{-0.7, 0.8}), std::pair("y1_m", Numbers{3.8, 3.8}),
                       std::pair("plants", Integers{3, 3})));
  in.set("plants", table(std::pair("row_id", ids), std::pair("number", Integers{1, 2, 3, 1, 2, 3}), std::pair("x_m", x),
                         std::pair("y_m", y), std::pair("state", Texts(6, "present"))));
  const auto lines = table(std::pair("row_id", Integers{1, 1, 2, 2}), std::pair("x_m", Numbers{-0.7, -0.7, 0.8, 0.8}),
                           std::pair("y_m", Numbers{2, 3.8, 2, 3.8}));
  in.set("lines", lines);
  in.set("region", frame_points(true, false));
  in.set("cleaned", frame_points(false, false));
  in.set("clusters", frame_points(false, true));
  in.set("trunks", frame_points(false, true));
  in.set("centres", table(std::pair("x_m", x), std::pair("y_m", y)));
  in.set("reference", table(std::pair("row_id", ids), std::pair("x_m", x), std::pair("y_m", y)));
  in.set("reference_lines", lines);
  in.set("matches", table(std::pair("kind", Texts{"matched", "matched"}), std::pair("row_id", Texts{"1", "2"}),
                          std::pair("ref_id", Texts{"1", "2"}), std::pair("angle_deg", Numbers{90.25, 90}),
                          std::pair("ref_angle_deg", Numbers{90, 90}), std::pair("angle_error_deg", Numbers{0.25, 0})));
  return in;
}

TEST(RowsReport, DrawsTheStepsOfAFrameAndTheReference) {
  Folder folder;
  RowsReportOptions options;
  options.dpi = 60;
  const auto in = frame_with_rows();
  const auto result = write_rows_report(in, options, folder.run);
  EXPECT_TRUE(result.report.warnings.empty()) << result.report.warnings.front();
  for (const char* figure : {"row_map", "row_steps", "rows_and_reference", "rows_over_reference"})
    for (const char* ending : {".png", ".svg", ".pdf"})
      EXPECT_TRUE(fs::exists(folder.run.output_dir / "figures" / (std::string(figure) + ending))) << figure << ending;
  EXPECT_TRUE(fs::exists(folder.run.output_dir / "row_matches.csv"));
  const auto page = text_of(folder.run.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("Comparison with the reference"));
  EXPECT_THAT(page, HasSubstr("From the frame to the rows"));
}

TEST(RowsReport, WithoutTheStepsAndAReferenceThereIsTheMapAlone) {
  Folder folder;
  RowsReportOptions options;
  options.dpi = 60;
  DataSet in;
  const auto all = frame_with_rows();
  for (const char* port : {"rows", "plants", "lines"}) in.set(port, all.table(port));
  in.set("region", all.cloud("region"));  // one step is no sheet
  write_rows_report(in, options, folder.run);
  EXPECT_TRUE(fs::exists(folder.run.output_dir / "figures/row_map.png"));
  for (const char* figure : {"row_steps", "rows_and_reference", "rows_over_reference"})
    EXPECT_FALSE(fs::exists(folder.run.output_dir / "figures" / (std::string(figure) + ".png"))) << figure;
}

TEST(SteeringReport, ShowsCentimetresAndLeavesOutWhatIsNotKnown) {
  Folder folder;
  const double nan = std::nan("");
  DataSet in;
  in.set("summary", table(std::pair("speed_km_h", Texts{"5", "mean"}), std::pair("line_mean_m", Numbers{0.001, 0.001}),
                          std::pair("line_sd_m", Numbers{0.0123, 0.0123}), std::pair("line_max_m", Numbers{0.04, 0.04}),
                          std::pair("receiver_sd_m", Numbers{nan, nan})));
  SteeringReportOptions options;
  options.figures = false;
  EXPECT_TRUE(write_steering_report(in, options, folder.run).report.warnings.empty());
  const auto page = text_of(folder.run.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("1.23"));
  EXPECT_THAT(page, Not(HasSubstr("receiver SD")));
  EXPECT_THAT(page, HasSubstr("as the receiver saw it"));
  EXPECT_THAT(page, Not(HasSubstr("true distance")));
  EXPECT_THAT(page, Not(HasSubstr("Published")));
  EXPECT_THAT(page, HasSubstr("rows: planted too unevenly to tell missing plants"));  // whichever stage it was
  EXPECT_THROW(write_steering_report(DataSet(), options, folder.run), Error);
}

TEST(SteeringReport, LinesInMetresOfAFieldAreNoGeoJson) {
  for (const bool placed : {false, true}) {
    Folder folder;
    auto lines = table(std::pair("line", Integers{0}), std::pair("a_x_m", Numbers{500000}),
                       std::pair("a_y_m", Numbers{5334000}), std::pair("b_x_m", Numbers{500100}),
                       std::pair("b_y_m", Numbers{5334000}), std::pair("length_m", Numbers{100}));
    if (placed) lines.facts["crs"] = utm32;
    DataSet in;
    in.set("lines", std::move(lines));
    const auto result = write_steering_report(in, SteeringReportOptions(), folder.run);
    EXPECT_EQ(fs::exists(folder.run.output_dir / "ab_lines.geojson"), placed);
    EXPECT_EQ(result.report.facts.contains("ab_lines.geojson"), !placed);
  }
}

TEST(SteeringReport, PublishedFiguresStandInTheSameTable) {
  Folder folder;
  DataSet in;
  in.set("summary",
         table(std::pair("speed_km_h", Texts{"5"}), std::pair("line_mean_m", Numbers{-0.001}),
               std::pair("line_sd_m", Numbers{0.0123}), std::pair("published_line_mean_m", Numbers{-0.0009}),
               std::pair("published_line_sd_m", Numbers{0.0251}), std::pair("controller_sd_m", Numbers{0.008})));
  SteeringReportOptions options;
  options.figures = false;
  write_steering_report(in, options, folder.run);
  const auto page = text_of(folder.run.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("1.23 (2.51)"));
  EXPECT_THAT(page, HasSubstr("\u22120.10 (\u22120.09)"));
  EXPECT_THAT(page, HasSubstr("<td>0.80")) << "the controller has no published figure";
  EXPECT_THAT(page, Not(HasSubstr("<h2>Published")));
}

TEST(SteeringReport, TheTrueDistanceIsToldWhereItIsKnown) {
  Folder folder;
  DataSet in;
  in.set("summary", table(std::pair("speed_km_h", Texts{"5"}), std::pair("line_sd_m", Numbers{0.01}),
                          std::pair("controller_sd_m", Numbers{0.008}), std::pair("receiver_sd_m", Numbers{0.006})));
  SteeringReportOptions options;
  options.figures = false;
  write_steering_report(in, options, folder.run);
  const auto page = text_of(folder.run.output_dir / "report.html");
  EXPECT_THAT(page, HasSubstr("true distance"));
  EXPECT_THAT(page, Not(HasSubstr("as the receiver saw it")));
}

TEST(RevisitReport, WritesTheTreesTheMapAndThePage) {
  Folder folder;
  DataSet in;
  in.set("growth", table(std::pair("tree_id", Texts{"1", "2", ""}), std::pair("tree_id_second", Texts{"7", "", "9"}),
                         std::pair("kind", Texts{"matched", "gone", "ingrowth"}),
                         std::pair("why", Texts{"", "<felled>", ""}), std::pair("x_m", Numbers{0, 4, 8}),
                         std::pair("y_m", Numbers{0, 3, 6}), std::pair("dbh1_cm", Numbers{20, 30, std::nan("")}),
                         std::pair("dbh2_cm", Numbers{21.5, std::nan(""), 8}),
                         std::pair("growth_cm", Numbers{1.5, std::nan(""), std::nan("")}),
                         std::pair("growth_lo_cm", Numbers{1, std::nan(""), std::nan("")}),
                         std::pair("growth_hi_cm", Numbers{2, std::nan(""), std::nan("")}),
                         std::pair("change", Texts{"grew", "", ""})));
  in.set("values", table(std::pair("measure", Texts{"mean_growth"}), std::pair("value", Numbers{1.5}),
                         std::pair("unit", Texts{"cm"}), std::pair("lo", Numbers{1.2}), std::pair("hi", Numbers{1.8})));
  const auto result = write_revisit_report(in, {.figure_width = 100, .dpi = 60}, folder.run);
  EXPECT_TRUE(result.report.findings.empty());
  for (const char* file :
       {"growth.csv", "growth_values.csv", "report.html", "figures/revisit_map.png", "figures/growth.svg"})
    EXPECT_TRUE(fs::exists(folder.run.output_dir / file)) << file;
  EXPECT_THAT(text_of(folder.run.output_dir / "growth.csv"),
              HasSubstr("1,7,matched,,0.0000,0.0000,20.00,21.50,1.500,1.000,2.000,grew"));
  EXPECT_THAT(text_of(folder.run.output_dir / "report.html"), HasSubstr("&lt;felled&gt;"));
}

TEST(CheckFiles, HoldTheVerdictAndWhereToGo) {
  auto findings =
      table(std::pair("code", Texts{"ground_never_seen", "heights_without_tops"}),
            std::pair("severity", Texts{"look", "note"}), std::pair("text", Texts{"a hole", "no tops"}),
            std::pair("x_m", Numbers{4, std::nan("")}), std::pair("y_m", Numbers{-3, std::nan("")}),
            std::pair("distance_m", Numbers{5, std::nan("")}), std::pair("bearing_deg", Numbers{126.9, std::nan("")}));
  findings.facts["verdict"] = "look";
  findings.facts["not_judged"] = "passes: none";
  SurveyData data;
  data.check = &findings;
  const auto json = check_json(data, nullptr);
  EXPECT_THAT(json, HasSubstr("\"verdict\": \"look\""));
  EXPECT_THAT(json, HasSubstr("\"x_m\": 4.0"));
  EXPECT_THAT(json, Not(HasSubstr("null"))) << "what has no place has no coordinates";
  const auto page = check_html("Plot 1", data, {});
  EXPECT_THAT(page, HasSubstr("Look before you sign"));
  EXPECT_THAT(page, HasSubstr("passes: none"));
}

}  // namespace
}  // namespace bole::report
