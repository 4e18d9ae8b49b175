// The reports of rows and of steering tests.
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "report/rows_report.h"
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

TEST(RowsReport, WritesDrawnRowsEditsAndThePage) {
  Folder folder;
  DataSet in;
  in.set("rows",
         table(std::pair("row_id", Integers{1, 2}), std::pair("angle_deg", Numbers{0, 90}),
               std::pair("x0_m", Numbers{0, 3}), std::pair("y0_m", Numbers{0, 5}), std::pair("x1_m", Numbers{4, 3}),
               std::pair("y1_m", Numbers{0, 9}), std::pair("plants", Integers{2, 0})));
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

}  // namespace
}  // namespace bole::report
